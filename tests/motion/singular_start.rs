//! Starts in singular positions, which are no redundancy, and redundancies, which hold at every position.

use sim::{Settings, What, assemble, declared_start, mechanism, mobility};
use std::f64::consts::PI;
use tests::run_with;

mechanism! {
    /// A parallelogram whose start is a parameter: flat at 0.
    Flat;
    coordinates { crank [rad]; coupler [rad]; rocker [rad]; }
    parameters { a [m] = 0.2; b [m] = 0.5; at [rad] = 0; }
    let A = a*[cos(crank), sin(crank)];
    let B = A + b*[cos(coupler), sin(coupler)];
    bodies {
        one: mass 1 [kg] at A/2, inertia 0.01 [kg*m^2], angle crank;
        two: mass 1 [kg] at (A + B)/2, inertia 0.02 [kg*m^2], angle coupler;
        three: mass 1 [kg] at [b, 0] + a/2*[cos(rocker), sin(rocker)], inertia 0.01 [kg*m^2], angle rocker;
    }
    loads { gravity [0, -9.81 [m/s^2]]; }
    constraints { closure: B = [b, 0] + a*[cos(rocker), sin(rocker)]; }
    initial { crank = at; dot(crank) = 10; guess coupler = 0; guess rocker = at; }
}

mechanism! {
    /// The same, carried by a third crank in the middle of its coupler: one closure too many wherever it is.
    Carried;
    coordinates { crank [rad]; coupler [rad]; rocker [rad]; middle [rad]; }
    parameters { a [m] = 0.2; b [m] = 0.5; at [rad] = 0.5; }
    let A = a*[cos(crank), sin(crank)];
    let u = [cos(coupler), sin(coupler)];
    bodies {
        one: mass 1 [kg] at A/2, inertia 0.01 [kg*m^2], angle crank;
        two: mass 1 [kg] at A + b/2*u, inertia 0.02 [kg*m^2], angle coupler;
        three: mass 1 [kg] at [b, 0] + a/2*[cos(rocker), sin(rocker)], inertia 0.01 [kg*m^2], angle rocker;
        four: inertia 0.01 [kg*m^2], angle middle;
    }
    constraints {
        closure: A + b*u = [b, 0] + a*[cos(rocker), sin(rocker)];
        carried: A + b/2*u = [b/2, 0] + a*[cos(middle), sin(middle)];
    }
    initial { crank = at; dot(crank) = 10; guess coupler = 0; guess rocker = at; guess middle = at; }
}

fn found<M: sim::Compiled>(mechanism: M) -> (usize, Vec<&'static str>, Vec<&'static str>) {
    let state = assemble(&mechanism, &declared_start(&mechanism)).unwrap();
    let found = mobility(&mechanism, 0.0, &state.positions);
    (found.degrees_of_freedom, found.dependent, found.singular)
}

/// A parallelogram has one degree of freedom, in its flat positions too, and no redundant constraint.
#[test]
fn a_flat_parallelogram_is_singular_and_has_no_redundancy() {
    for at in [0.0, PI] {
        assert_eq!(found(Flat { at, ..Default::default() }), (1, vec![], vec!["closure_x"]));
    }
    assert_eq!(found(Flat { at: 0.1, ..Default::default() }), (1, vec![], vec![]));
}

/// A third crank is redundant in every position that the linkage can take, though not in others.
#[test]
fn a_redundant_constraint_is_no_singular_position() {
    assert_eq!(found(Carried::default()), (1, vec!["carried_y"], vec![]));
}

/// Which motion leads on from the crossing of two, nothing says: no run starts there. Beside it one does, and goes round through
/// both flat positions.
#[test]
fn a_run_does_not_start_where_the_motion_is_not_determined() {
    let failure = run_with(Flat::default(), &Settings::new(1.0)).unwrap_err();
    println!("{failure}");
    assert_eq!(failure.what, What::SingularStart { constraint: "closure_x" });
    let run = run_with(Flat { at: 0.01, ..Default::default() }, &Settings::new(1.0)).unwrap();
    assert_eq!(run.trajectory.failure, None);
    println!("{:?}", run.steps.singularities);
    assert!(run.steps.singularities.len() > 1);
    let apart = |sample: &sim::Sample<Flat>| (sample.state.positions[0] - sample.state.positions[2]).abs();
    assert!(run.trajectory.samples.iter().all(|sample| apart(sample) < 1e-7));
}
