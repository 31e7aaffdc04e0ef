//! Starts in singular positions, which are no redundancy, and redundancies, which hold at every position.

use sim::{Mechanism, Settings, What, assemble, declared_start, mechanism, mobility};
use std::f64::consts::PI;
use tests::any_model::{self, AnyModel, interpreted};

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
    let failure = any_model::run_with(Flat::default(), &Settings::new(1.0)).unwrap_err();
    println!("{failure}");
    assert_eq!(failure.what, What::SingularStart { constraint: "closure_x" });
    let run = any_model::run_with(Flat { at: 0.01, ..Default::default() }, &Settings::new(1.0)).unwrap();
    assert_eq!(run.trajectory.failure, None);
    println!("{:?}", run.steps.singularities);
    assert!(run.steps.singularities.len() > 1);
    let apart = |sample: &sim::Sample<AnyModel>| (sample.state.positions[0] - sample.state.positions[2]).abs();
    assert!(run.trajectory.samples.iter().all(|sample| apart(sample) < 1e-7));
}

/// A quaternion of which q0 = 1 is given has no other components, and stands in a double solution of its norm.
#[test]
fn a_double_solution_is_found_exactly() {
    for length in [1e-3, 1.0, 1e3] {
        let declaration = format!(
            "pub Hanging; parameters {{ L [m] = {length}; m [kg] = 1; }}
             bodies {{ b: free, mass m, inertia [0.02*m*L^2, 0.03*m*L^2, 0.04*m*L^2];
                 c: free, mass m, inertia [0.02*m*L^2, 0.03*m*L^2, 0.04*m*L^2]; }}
             joints {{ j: ball ground at [0, 0, 0] to b at [0, 0, L];
                 k: universal b at [0, 0, -L] axis [0, 1, 0] to c at [0, 0, L] axis [1, 0, 0]; }}
             initial {{ b_q0 = 0.8; b_q1 = 0.6; b_q2 = 0; b_q3 = 0; c_q0 = 1; guess b_z = -L; guess c_z = -3*L; }}"
        );
        let model = interpreted(&declaration).unwrap();
        let state = assemble(&model, &declared_start(&model)).unwrap();
        let at = |name: &str| {
            let coordinates = model.description().coordinates;
            state.positions[coordinates.iter().position(|c| c.position.name == name).unwrap()]
        };
        // The norm tells the others to the square root of its rounding, and places are known to that of the length.
        for name in ["c_q1", "c_q2", "c_q3"] {
            assert!(at(name).abs() < 1e-8, "{name} = {:e} at {length} m", at(name));
        }
        // Two links of 2 L, which lean by sin = 2*0.8*0.6.
        assert!((at("c_y") / length - 1.92).abs() < 1e-8, "{}", at("c_y") / length);
    }
}

/// Two bodies, one on a ball and one welded to it, of the first of which q0 = 1 is given, from guesses that are far away.
#[test]
fn a_double_solution_is_found_from_far_away() {
    for length in [1e-3, 0.1, 1.0, 100.0] {
        let declaration = format!(
            "pub Welded; parameters {{ L [m] = {length}; m [kg] = 1; }}
             bodies {{ b: free, mass m, inertia [0.02*m*L^2, 0.03*m*L^2, 0.04*m*L^2];
                 c: free, mass m, inertia [0.02*m*L^2, 0.03*m*L^2, 0.04*m*L^2]; }}
             joints {{ j: ball ground at [0, 0, 0] to b at [0, 0, L]; k: weld b at [0, 0, -L] to c at [0, 0, L]; }}
             initial {{ b_q0 = 1; guess b_q1 = 0.2; guess b_z = -L; guess c_z = -3*L; }}"
        );
        let model = interpreted(&declaration).unwrap();
        let state = assemble(&model, &declared_start(&model)).unwrap();
        let coordinates = model.description().coordinates.iter();
        for (j, name) in coordinates.map(|c| c.position.name).enumerate() {
            let (expected, scale) = match name {
                "b_q0" | "c_q0" => (1.0, 1.0),
                "b_z" => (-length, length),
                "c_z" => (-3.0 * length, length),
                _ => (0.0, if name.contains('q') { 1.0 } else { length }),
            };
            // The square root of the rounding of a norm, over lever arms of three lengths.
            let found = state.positions[j];
            assert!((found - expected).abs() < 1e-7 * scale, "{name} = {found:e} at {length} m");
        }
    }
}
