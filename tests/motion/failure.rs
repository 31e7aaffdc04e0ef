//! Runs that fail say what, when and where, and keep what was computed until then.

use models::QuickReturn;
use sim::{Failure, Method, Settings, Stabilisation, Table, What, declared_start, mechanism, run_while};
use tests::any_model::{interpreted, run, run_with};

mechanism! {
    /// A bead on a rod in a groove that ends: y = sqrt(1 - x) leaves its domain at x = 1.
    Groove;
    coordinates { x [m]; y [m]; }
    parameters { m [kg] = 1; }
    bodies { bead: mass m at [x, y]; }
    constraints { groove: y = sqrt(1 [m]*(1 [m] - x)); }
    initial { x = 0; dot(x) = 1; guess y = 1; }
}

mechanism! {
    /// Two parallel guides are one too many.
    Overconstrained;
    coordinates { x [m]; y [m]; }
    parameters { m [kg] = 1; }
    bodies { bead: mass m at [x, y]; }
    loads { force [1 [N], 0] at [x, y]; }
    constraints { first: y = 0; second: 2*y = 0; }
}

mechanism! {
    /// A load with a pole.
    Pole;
    coordinates { x [m]; }
    parameters { m [kg] = 1; at [m] = 0.5; }
    bodies { bead: mass m at [x, 0]; }
    loads { force [1 [N]*sqrt((at - x)/1 [m]), 0] at [x, 0]; }
    initial { dot(x) = 1; }
}

mechanism! {
    /// A coordinate that moves a body without inertia, held by a constraint: no pivot on the diagonal.
    Massless;
    coordinates { x [m]; phi [rad]; }
    parameters { m [kg] = 2; k [N/m] = 50; r [m] = 0.1; J [kg*m^2] = 0; T [N*m] = 0.5; }
    bodies { block: mass m at [x, 0]; wheel: inertia J, angle phi; }
    loads { force [-k*x, 0] at [x, 0]; torque T on wheel; }
    constraints { rolling: x = r*phi; }
    initial { x = 0.3; guess phi = 3; }
    events { centre: x = T/(r*k); }
}

mechanism! {
    /// An output that leaves its domain when x passes 0.5.
    Undefined;
    coordinates { x [m]; }
    parameters { m [kg] = 1; }
    bodies { bead: mass m at [x, 0]; }
    initial { dot(x) = 1; }
    outputs { fine [m] = x; broken = sqrt((0.5 [m] - x)/1 [m]); }
}

fn failing<M: sim::Compiled>(mechanism: M) -> (usize, f64, Failure) {
    let run = run(mechanism, 2.0, 2000).unwrap();
    let last = run.trajectory.samples.last().map_or(0.0, |sample| sample.state.time);
    (run.trajectory.samples.len(), last, run.trajectory.failure.unwrap())
}

#[test]
fn a_constraint_that_leaves_its_domain_ends_the_run_with_its_name() {
    let (samples, last, failure) = failing(Groove::default());
    assert!(samples > 100 && last > 0.1 && failure.time >= last, "{failure}");
    let message = failure.to_string();
    assert!(message.contains("constraint `groove`"), "{message}");
}

#[test]
fn a_load_that_leaves_its_domain_ends_the_run_with_its_equation() {
    let (samples, last, failure) = failing(Pole::default());
    assert!(samples > 100 && last > 0.1 && last < 0.6);
    assert_eq!(failure.what, What::NotFinite { quantity: "the equation of the acceleration of `x`".into() });
}

/// Of two guides that say the same, one carries nothing; the motion is the free one, x = t^2/2.
#[test]
fn redundant_constraints_are_named_and_the_motion_goes_on() {
    let run = run(Overconstrained::default(), 1.0, 10).unwrap();
    assert_eq!(run.trajectory.failure, None);
    assert_eq!((run.mobility.degrees_of_freedom, &run.mobility.dependent[..]), (1, &["second"][..]));
    for sample in &run.trajectory.samples {
        let t = sample.state.time;
        assert!((sample.state.positions[0] - t * t / 2.0).abs() < 1e-14 && sample.state.positions[1] == 0.0);
    }
}

/// m x'' = -k x + T/r and lambda = -T/r, although the planned elimination cannot eliminate phi: every state is solved by complete
/// pivoting.
#[test]
fn a_coordinate_without_inertia_is_solved_by_pivoting() {
    let run = run(Massless::default(), 2.0, 4000).unwrap();
    assert_eq!(run.trajectory.failure, None);
    let quarter = std::f64::consts::FRAC_PI_2 * (2.0f64 / 50.0).sqrt();
    // (h omega)^4 = 4e-11.
    assert!((run.events[0].state.time - quarter).abs() < 1e-9);
    assert!(run.trajectory.samples.iter().all(|sample| (sample.multipliers[0] + 5.0).abs() < 1e-12));
}

#[test]
fn an_output_that_leaves_its_domain_is_named_with_its_time() {
    let run = run(Undefined::default(), 1.0, 100).unwrap();
    assert_eq!(run.trajectory.failure, None);
    let table = Table::of(&run.mechanism, &run.trajectory);
    let [("broken", time)] = table.undefined_outputs()[..] else { panic!("{:?}", table.undefined_outputs()) };
    // The first sample after 0.5 s.
    assert!((time - 0.51).abs() < 1e-12, "{time}");
}

mechanism! {
    /// A wheel with a condition that changes a million times as fast as the wheel.
    Chattering;
    coordinates { phi [rad]; }
    parameters { J [kg*m^2] = 1; }
    bodies { wheel: inertia J, angle phi; }
    initial { dot(phi) = 1; }
    events { rattle: sin(1e9*phi) = 0; }
}

/// An adaptive method comes as near to where a load leaves its domain as its steps can shrink, and then says where.
#[test]
fn an_adaptive_method_ends_where_a_load_leaves_its_domain() {
    for method in [Method::Dop853, Method::Dopri5, Method::Radau5] {
        let run = run_with(Pole::default(), &Settings::adaptive(method, 2.0, 1e-8)).unwrap();
        let failure = run.trajectory.failure.unwrap();
        let last = run.trajectory.samples.last().unwrap().state.clone();
        println!("{}: {failure}", method.name());
        assert!(last.time > 0.3 && last.positions[0] < 0.5 && failure.time >= last.time, "{failure}");
        assert!(failure.state[0].1 > 0.49, "{failure}");
    }
}

mechanism! {
    /// A bead on a wire that is bent by a right angle at the origin, which it reaches at t = 1 s.
    Bent;
    coordinates { x [m]; y [m]; }
    parameters { m [kg] = 2; slope [1] = 1; }
    bodies { bead: mass m at [x, y]; }
    constraints { wire: y = slope*sqrt(x^2); }
    initial { x = -1; guess y = 1; dot(x) = 1; }
}

/// A projection onto a wire on which the bead cannot go on would bring it back to the bend, step after step, with its speed
/// kept. Steeper bends take back more than that, and flatter ones let it through with another speed.
#[test]
fn a_bend_of_a_constraint_ends_the_run_with_its_name() {
    let methods = [Method::Dopri5, Method::Dop853, Method::Radau5];
    for (method, slope) in methods.into_iter().flat_map(|method| [0.5, 1.0, 3.0].map(|slope| (method, slope))) {
        for stabilisation in [Stabilisation::Projection, Stabilisation::MassProjection] {
            let bent = Bent { slope, ..Bent::default() };
            let settings = Settings { stabilisation, ..Settings::adaptive(method, 1.5, 1e-9) };
            let failure = run_with(bent, &settings).unwrap().trajectory.failure.unwrap();
            println!("{} {slope} {stabilisation}: {failure}", method.name());
            // It ends before a step that is a millionth of the longest one.
            assert!((failure.time - 1.0).abs() < 1e-5, "{failure}");
            let is_kink = matches!(failure.what, What::Kink { constraint: "wire" });
            assert!(is_kink || slope < 1.0, "{failure}");
        }
    }
}

#[test]
fn events_that_chatter_end_the_run_with_their_name() {
    let run = run_with(Chattering::default(), &Settings::equal_steps(Method::Rk4, 1.0, 10)).unwrap();
    let failure = run.trajectory.failure.unwrap();
    assert!(matches!(failure.what, What::Chattering { event: "rattle", .. }), "{failure}");
    assert_eq!(run.trajectory.samples.len(), 1);
}

#[test]
fn steps_too_large_for_newton_say_so() {
    let run = run_with(QuickReturn::default(), &Settings::equal_steps(Method::Radau5, 2.0, 3)).unwrap();
    let message = run.trajectory.failure.unwrap().to_string();
    assert!(message.contains("Newton's method does not converge") || message.contains("constraint"), "{message}");
}

#[test]
fn a_method_without_an_estimate_cannot_choose_its_steps() {
    let run = run_with(QuickReturn::default(), &Settings::adaptive(Method::Rk4, 2.0, 1e-8)).unwrap();
    assert_eq!(run.trajectory.failure.unwrap().what, What::NoErrorEstimate);
}

#[test]
fn negative_masses_are_refused_by_name() {
    let failure = run(QuickReturn { J2: -100.0, ..Default::default() }, 2.0, 10).unwrap_err();
    let message = failure.to_string();
    assert!(message.contains("`alpha`") && message.contains("`J2` is -100 kg*m^2"), "{message}");
}

#[test]
fn an_interrupted_run_keeps_what_it_has() {
    let mechanism = QuickReturn::default();
    let start = declared_start(&mechanism);
    let mut asked = 0;
    let mut goes_on = |_| {
        asked += 1;
        asked < 3
    };
    let run = run_while(mechanism, &start, &Settings::equal_steps(Method::Rk4, 2.0, 100), &mut goes_on).unwrap();
    // It is asked where the motion begins, and after each step.
    assert_eq!((run.trajectory.failure.unwrap().what, run.trajectory.samples.len()), (What::Interrupted, 3));
}

/// The lock contradicts the clutch; what is released is not to blame.
#[test]
fn a_released_constraint_is_not_blamed() {
    let declaration = "pub Locked; coordinates { x [m]; phi [rad]; }
        bodies { a: mass 1 [kg] at [x, 0]; b: inertia 1 [kg*m^2], angle phi; }
        constraints {
            hit: x = 1 [m] initially released;
            clutch: phi = 0 initially active;
            lock: dot(phi) = 0.3 [rad/s] initially released;
        }
        initial { dot(x) = 0.1; } events { locks: t = 0.5 [s] rising { impact lock restitution 0.5; } }";
    let run =
        tests::run_with(interpreted(declaration).unwrap(), &Settings::adaptive(Method::Dop853, 1.0, 1e-10)).unwrap();
    let failure = run.trajectory.failure.unwrap().to_string();
    assert!(failure.contains("the reaction of `lock` is not determined"), "{failure}");
}
