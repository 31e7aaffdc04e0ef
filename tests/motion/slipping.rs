//! Dry friction whose limit is the same at rest and in motion: where it is just overcome the force on a block is rounding, and
//! so is the direction in which it moves at first.

use sim::{Method, Settings, What};
use tests::any_model::interpreted;
use tests::{Random, run_with};

/// A block that a growing force pulls, held by friction up to a limit; the condition under which it is caught again.
fn pulled(limit: f64, caught: &str) -> String {
    format!(
        "/// A block that is pulled.
        Pulled;
        coordinates {{ x [m]; }}
        parameters {{ m [kg] = 1; limit [N] = {limit:?}; s = 0; }}
        bodies {{ block: mass m at [x, 0]; }}
        loads {{ force [10 [N/s]*t - s*limit, 0] at [x, 0]; }}
        constraints {{ stick: dot(x) = 0 initially active; }}
        initial {{ x = 0; }}
        events {{
            slip: reaction(stick) = limit rising {{ release stick; set s = 1; }}
            halt: {caught} {{ activate stick; set s = 0; }}
        }}"
    )
}

/// From then on x'' = 10 (t - t0)/m.
#[test]
fn a_block_slips_where_friction_is_overcome() {
    let mut random = Random(3);
    for caught in ["dot(x) = 0", "dot(x) = 0 falling", "s*dot(x) = 0 falling"] {
        for _ in 0..25 {
            let limit = random.between(0.5, 8.0);
            let slipping = 2.0 - limit / 10.0;
            let run = run_with(interpreted(&pulled(limit, caught)).unwrap(), &Settings::new(2.0)).unwrap();
            let end = run.trajectory.samples.last().unwrap();
            // Twice the tolerance of the run, at speeds of up to 20 m/s.
            assert!((end.state.speeds[0] - 5.0 * slipping.powi(2)).abs() < 4e-9, "{limit} N, {caught}: {end:?}");
            assert_eq!(run.events.len(), 1, "{limit} N, {caught}");
        }
    }
}

/// A one-way clutch lets go where the force changes its sign and holds again where the motion would turn back: at rest
/// x = 0 and t = 0, F (1 - cos w t)/(m w) from there on, and so once in each period.
#[test]
fn a_one_way_clutch_lets_go_and_holds_in_each_period() {
    let mut random = Random(4);
    for _ in 0..25 {
        let [force, rate] = [random.between(1.0, 20.0), random.between(2.0, 9.0)];
        let declaration = format!(
            "/// A one-way clutch.
            Clutch;
            coordinates {{ x [m]; }}
            parameters {{ m [kg] = 1; F [N] = {force:?}; w [rad/s] = {rate:?}; }}
            bodies {{ block: mass m at [x, 0]; }}
            loads {{ force F*(sin(w*t) - 0.5) on x; }}
            constraints {{ held: dot(x) = 0 initially active; }}
            initial {{ x = 0; }}
            events {{
                free: reaction(held) = 0 rising {{ release held; }}
                hold: dot(x) = 0 falling {{ activate held; }}
            }}"
        );
        let run = run_with(interpreted(&declaration).unwrap(), &Settings::new(5.0)).unwrap();
        let begins = (0..).map(|k| (std::f64::consts::FRAC_PI_6 + std::f64::consts::TAU * f64::from(k)) / rate);
        let expected: Vec<f64> = begins.take_while(|time| *time < 5.0).collect();
        let found: Vec<f64> =
            run.events.iter().filter(|event| event.name == "free").map(|event| event.state.time).collect();
        assert_eq!(found.len(), expected.len(), "F = {force}, w = {rate}: {found:?}");
        // Times of events are located to 1e-12 s.
        assert!(found.iter().zip(&expected).all(|(found, expected)| (found - expected).abs() < 1e-11), "{found:?}");
    }
}

/// An event that catches a block again in the instant in which it slips: the two undo each other, and the run says so.
#[test]
fn what_is_caught_again_at_once_slips_again() {
    let declaration = pulled(2.0, "s*dot(x) = 0 rising");
    let failure = run_with(interpreted(&declaration).unwrap(), &Settings::new(2.0)).unwrap().trajectory.failure;
    assert!(matches!(failure.map(|failure| failure.what), Some(What::Accumulating { .. })));
}

/// A latch that holds 3 N, whose load jumps from 1 N to 5 N at 1 s.
#[test]
fn a_latch_lets_go_where_its_load_jumps_past_its_limit() {
    for condition in
        ["reaction(latch) = 3 [N] rising", "reaction(latch) = 3 [N]", "abs(reaction(latch)) = 3.5 [N] rising"]
    {
        let declaration = format!(
            "/// A latch.
            Latch;
            coordinates {{ x [m]; }}
            parameters {{ m [kg] = 1; }}
            bodies {{ block: mass m at [x, 0]; }}
            loads {{ force if t < 1 [s] then 1 [N] else 5 [N] on x; }}
            constraints {{ latch: x = 0 initially active; }}
            events {{ snap: {condition} {{ release latch; }} }}"
        );
        for method in [Method::Dop853, Method::Dopri5, Method::Radau5] {
            let settings = Settings::adaptive(method, 2.0, 1e-10);
            let run = run_with(interpreted(&declaration).unwrap(), &settings).unwrap();
            let end = run.trajectory.samples.last().unwrap();
            // x = 5 (t - 1)^2/2, from a time known to 1e-12 s and a first step that may begin just before the jump.
            assert!((end.state.positions[0] - 2.5).abs() < 1e-7, "{condition}, {}: {end:?}", method.name());
        }
    }
}

/// A block that only a wall holds: where the force turns away from it, it leaves, and does not land in the same instant.
#[test]
fn a_block_leaves_a_wall_where_the_force_turns() {
    let mut random = Random(5);
    for _ in 0..25 {
        let [force, rate] = [random.between(2.0, 20.0), random.between(2.0, 9.0)];
        let declaration = format!(
            "/// A block on a wall.
            Wall;
            coordinates {{ x [m]; }}
            parameters {{ m [kg] = 0.3; F [N] = {force:?}; w [rad/s] = {rate:?}; }}
            bodies {{ block: mass m at [x, 0]; }}
            loads {{ force F*(sin(w*t) - 0.5) on x; }}
            constraints {{ wall: x = 0 initially active; }}
            initial {{ x = 0; }}
            events {{
                leaves: reaction(wall) = 0 rising {{ release wall; }}
                lands: x = 0 falling {{ activate wall; }}
            }}"
        );
        let run = run_with(interpreted(&declaration).unwrap(), &Settings::new(2.0)).unwrap();
        assert_eq!(run.trajectory.failure, None, "F = {force}, w = {rate}");
        let leaves = std::f64::consts::FRAC_PI_6 / rate;
        // With s = w (t - t0), x is proportional to s cos(pi/6) - sin(s + pi/6) + 1/2 - s^2/4, which is positive up to s = 4.6.
        let next = run.events.get(1).map_or(f64::INFINITY, |event| event.state.time);
        assert!((run.events[0].state.time - leaves).abs() < 1e-11 && next > leaves + 4.5 / rate, "{next} s");
    }
}

/// A block that slides up an incline until friction holds it, while a clock ticks.
fn on_an_incline(slope: f64, speed: f64) -> String {
    format!(
        "/// A block on an incline.
        Incline;
        coordinates {{ x [m]; y [m]; }}
        parameters {{ slope = {slope:?}; m [kg] = 2; limit [N] = 20; push [N] = 1; s = 1; next [s] = 0.1; }}
        let P = [x, y];
        let u = [cos(slope), sin(slope)];
        bodies {{ block: mass m at P; }}
        loads {{ gravity [0, -9.81 [m/s^2]]; force (push*sin(5 [rad/s]*t) - s*limit)*u at P; }}
        constraints {{
            plane: inner(P, [-sin(slope), cos(slope)]) = 0;
            held: inner(dot(P), u) = 0 initially released;
        }}
        initial {{ x = 0; guess y = 0; dot(x) = {speed:?}; }}
        events {{
            halt: inner(dot(P), u) = 0 falling {{ activate held; set s = 0; }}
            tick: t = next rising {{ set next = next + 0.1 [s]; }}
        }}"
    )
}

/// Two wheels that rub until they roll on each other, beside the same clock.
fn wheels(radius: f64, speed: f64) -> String {
    format!(
        "/// Two wheels.
        Wheels;
        coordinates {{ a [rad]; b [rad]; }}
        parameters {{ r [m] = {radius:?}; R [m] = 0.3; J [kg*m^2] = 0.1; f [N] = 5; T [N*m] = 0.1; s = 1; next [s] = 0.1; }}
        bodies {{ one: inertia J, angle a; other: inertia 2*J, angle b; }}
        constraints {{ held: r*dot(a) + R*dot(b) = 0 initially released; }}
        loads {{ torque T*cos(3 [rad/s]*t) - s*f*r on one; torque -s*f*R on other; }}
        initial {{ dot(a) = {:?}; dot(b) = 0.3; }}
        events {{
            halt: r*dot(a) + R*dot(b) = 0 falling {{ activate held; set s = 0; }}
            tick: t = next rising {{ set next = next + 0.1 [s]; }}
        }}",
        5.0 * speed
    )
}

/// What has come to rest does so once, though the speed that is held at zero is rounding at every tick.
#[test]
fn what_is_held_does_not_halt_again() {
    let mut random = Random(6);
    for _ in 0..25 {
        let [size, speed] = [random.between(0.2, 0.6), random.between(0.5, 2.0)];
        for declaration in [on_an_incline(size, speed), wheels(size, speed)] {
            let run = run_with(interpreted(&declaration).unwrap(), &Settings::new(3.0)).unwrap();
            assert_eq!(run.trajectory.failure, None);
            let halts = run.events.iter().filter(|event| event.name == "halt").count();
            assert_eq!(halts, 1, "{declaration}");
        }
    }
}
