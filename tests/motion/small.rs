//! Events of small, light and fast mechanisms are those of large ones, and conditions that stay at zero happen where they reach
//! it.

use sim::{Array, Method, Settings, Simulation, StopAt, What, declared_start};
use tests::any_model::{AnyModel, interpreted};

fn run(declaration: &str, settings: &Settings) -> sim::Run<AnyModel> {
    tests::run_with(interpreted(declaration).unwrap(), settings).unwrap()
}

/// The times of an event.
fn times(run: &sim::Run<AnyModel>, name: &str) -> Vec<f64> {
    run.events.iter().filter(|event| event.name == name).map(|event| event.state.time).collect()
}

/// Crossings of x = 0 at quarter turns, and a wall on the way, at each speed.
#[test]
fn fast_motions_are_located_like_slow_ones() {
    for w in [1.0, 1e6, 1e9, 1e12] {
        let declaration = format!(
            "pub Fast; coordinates {{ x [m]; }} parameters {{ m [kg] = 1; x0 [m] = 1e-8; w [1/s] = {w:e}; }}
             bodies {{ b: mass m at [x, 0]; }} loads {{ force [-m*w^2*x, 0] at [x, 0]; }} initial {{ x = x0; }}
             events {{ zero: x = 0 falling; wall: x = -x0/2 falling {{ set dot(x) = -dot(x); }} }}"
        );
        let run = run(&declaration, &Settings::adaptive(Method::Dop853, 5.0 / w, 1e-12));
        assert_eq!(run.trajectory.failure, None);
        // From x0 to -x0/2 takes a third of a turn, and from there the mass returns the same way, to come again after two
        // thirds of a turn.
        let third = 2.0 * std::f64::consts::PI / 3.0;
        let (zero, wall) = (times(&run, "zero"), times(&run, "wall"));
        assert_eq!((zero.len(), wall.len()), (1, 1), "{w:e}");
        // To rtol, over some radians; 1e-12 of the duration of the run.
        assert!((w * zero[0] - std::f64::consts::FRAC_PI_2).abs() < 1e-10, "{w:e}: {}", w * zero[0]);
        assert!((w * wall[0] - third).abs() < 1e-10, "{w:e}: {}", w * wall[0]);
    }
}

/// A stop lets go when its reaction changes sign, at t = 0.5 s, whatever the size of moments.
#[test]
fn reactions_of_light_parts_are_no_rounding() {
    for size in [1.0, 1e-9, 1e-12, 1e-15] {
        let declaration = format!(
            "pub Light; coordinates {{ p [rad]; }} parameters {{ J [kg*m^2] = {size:e}; T [N*m] = {size:e}; s [s] = 1; }}
             bodies {{ b: inertia J, angle p; }} loads {{ torque T*(t/s - 0.5) on p; }}
             constraints {{ stop_: p = 0 initially active; }} initial {{ p = 0; }}
             events {{ lift: reaction(stop_) = 0 rising {{ release stop_; }} }}"
        );
        let run = run(&declaration, &Settings::adaptive(Method::Dop853, 1.5, 1e-10));
        assert_eq!(times(&run, "lift").len(), 1);
        assert!((times(&run, "lift")[0] - 0.5).abs() < 1e-9, "{size:e}: {:?}", times(&run, "lift"));
        // p'' = t - 0.5 s from there: (1 s)^3 / 6.
        let end = run.trajectory.samples.last().unwrap().state.positions[0];
        assert!((end - 1.0 / 6.0).abs() < 1e-9, "{size:e}: {end}");
    }
}

/// The force of a one-sided spring vanishes where the spring is left, though it stays zero beyond.
#[test]
fn a_condition_that_stays_zero_happens_where_it_reaches_zero() {
    let declaration = "pub OneSided; coordinates { x [m]; } parameters { k [N/m] = 1; m [kg] = 1; }
        bodies { b: mass m at [x, 0]; } loads { spring k, rest 0 on x; } initial { x = 1; }
        let F = k*max(x, 0 [m]);
        events { off: F = 0 falling; left: x = 0 falling; }";
    for settings in [
        Settings::adaptive(Method::Dop853, 16.0, 1e-10),
        Settings::adaptive(Method::Dopri5, 16.0, 1e-6),
        Settings::equal_steps(Method::Rk4, 16.0, 64),
    ] {
        let run = run(declaration, &settings);
        let (off, left) = (times(&run, "off"), times(&run, "left"));
        assert_eq!(off.len(), 3, "{settings:?}");
        for (off, left) in off.iter().zip(&left) {
            // Both to the accuracy of locating.
            assert!((off - left).abs() < 1e-11, "{settings:?}: {off} {left}");
        }
    }
}

/// Where an event has ended a motion, accelerations are those of its time, for every method and after restoring.
#[test]
fn the_sample_at_an_event_that_ends_the_motion_is_of_its_time() {
    let declaration = "pub Crank; coordinates { a [rad]; b [rad]; x [m]; } parameters { r [m] = 0.05; l [m] = 0.2; J [kg*m^2] = 0.01; }
        let A = r*[cos(a), sin(a)];
        bodies { crank: inertia J, angle a; rod: inertia J, angle b; piston: mass 1 [kg] at [x, 0]; }
        constraints { loop: A + l*[cos(b), -sin(b)] = [x, 0]; }
        initial { a = 0.5; dot(a) = 6; guess x = 0.24; guess b = 0.1; } events { top: a = pi/2; }";
    let mechanism = interpreted(declaration).unwrap();
    let start = declared_start(&mechanism);
    for method in Method::ALL {
        let settings = match method.is_adaptive() {
            true => Settings::adaptive(method, 10.0, 1e-9),
            false => Settings::equal_steps(method, 10.0, 4000),
        };
        let settings = Settings { stop: Some(StopAt { event: 0, occurrence: 1 }), ..settings };
        let mut simulation = Simulation::new(mechanism.clone(), &start, &settings).unwrap();
        simulation.advance_to(10.0).unwrap();
        let mut restored = Simulation::new(mechanism.clone(), &start, &settings).unwrap();
        restored.restore(&simulation.save()).unwrap();
        for simulation in [simulation, restored] {
            let (state, sample) = (simulation.state(), simulation.sample().unwrap());
            assert_eq!((sample.state.time, sample.state.positions.as_ref()), (state.time, state.positions.as_ref()));
            let right = sim::accelerate(&mechanism, state.time, &state.positions, &state.speeds).unwrap();
            for (found, right) in sample.accelerations.iter().zip(right.accelerations.iter()) {
                assert!((found - right).abs() < 1e-9, "{}: {found} {right}", method.name());
            }
        }
    }
}

/// A motion passes a singular position, but inputs and parameters do not change there; a mass does not vanish on the way.
#[test]
fn changes_that_cannot_be_continued_are_refused() {
    let declaration =
        "pub Flat; coordinates { a [rad]; b [rad]; c [rad]; } parameters { l [m] = 0.2; d [m] = 0.6; m [kg] = 1; }
        inputs { T [N*m] = 0; }
        let A = l*[cos(a), sin(a)]; let B = A + d*[cos(b), sin(b)];
        bodies { ba: mass m at A/2, inertia m*l^2/12, angle a; bb: mass m at (A + B)/2, inertia m*d^2/12, angle b;
                 bc: mass m at [d, 0] + l/2*[cos(c), sin(c)], inertia m*l^2/12, angle c; }
        loads { torque T on ba; } constraints { loop: B = [d, 0] + l*[cos(c), sin(c)]; }
        initial { a = pi/3; dot(a) = 120 [deg/s]; guess c = 1; guess b = 0; }";
    let mechanism = interpreted(declaration).unwrap();
    let settings = Settings::equal_steps(Method::Rk4, 2.0, 200);
    let mut flat = Simulation::new(mechanism.clone(), &declared_start(&mechanism), &settings).unwrap();
    flat.advance_to(1.0).unwrap();
    let refused = flat.set_input("T", sim::Input::Held(0.1)).unwrap_err();
    assert!(matches!(refused.what, What::SingularStart { .. }), "{refused}");
    // It goes on as without, and a little later the input counts: a'' = T/(5/3 m l^2) = 1.5 rad/s^2.
    flat.advance_to(1.1).unwrap();
    flat.set_input("T", sim::Input::Held(0.1)).unwrap();
    flat.advance_to(1.6).unwrap();
    let right = 2.0 * std::f64::consts::FRAC_PI_3 + 0.5 * 1.5;
    assert!((flat.state().speeds[0] - right).abs() < 1e-6, "{} {right}", flat.state().speeds[0]);
    let spring =
        "pub Spring; coordinates { x [m]; } parameters { m [kg] = 1; k [N/m] = 4; } bodies { b: mass m at [x, 0]; }
        loads { spring k, rest 0 on x; } initial { x = 1; }";
    let mechanism = interpreted(spring).unwrap();
    let settings = Settings::adaptive(Method::Dop853, 2.0, 1e-10);
    let mut simulation = Simulation::new(mechanism.clone(), &declared_start(&mechanism), &settings).unwrap();
    simulation.advance_to(1.0).unwrap();
    assert!(simulation.set_parameter("m", 0.0).is_err());
    simulation.advance_to(2.0).unwrap();
    assert!((simulation.state().positions[0] - 4f64.cos()).abs() < 1e-9);
}
