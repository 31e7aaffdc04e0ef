//! Ways to stay on the constraints: partitioning against projection, redundant constraints.

use models::{Andrews, FourBar, QuickReturn, QuickReturnRatio, SliderCrank};
use nalgebra::{DMatrix, DVector};
use sim::{Compiled, Mechanism, Method, Run, Settings, Stabilisation, Table, What, mechanism};
use tests::any_model::{AnyModel, interpreted, run_with};

mechanism! {
    /// The shipped four-bar with its loop closed twice, the second time in other lengths.
    Doubled;
    coordinates { crank [rad]; coupler [rad]; rocker [rad]; }
    parameters { a [m] = 0.2; b [m] = 0.6; c [m] = 0.5; d [m] = 0.6; m [kg] = 4; g [m/s^2] = 9.81; }
    let A = a*[cos(crank), sin(crank)];
    let u = [cos(coupler), sin(coupler)];
    let v = [cos(rocker), sin(rocker)];
    bodies {
        one: mass 2 [kg] at A/2, inertia 2 [kg]*a^2/12, angle crank;
        two: mass m at A + b/2*u, inertia m*b^2/12, angle coupler;
        three: mass 3 [kg] at [d, 0] + c/2*v, inertia 3 [kg]*c^2/12, angle rocker;
    }
    loads { gravity [0, -g]; }
    constraints { closure: A + b*u = [d, 0] + c*v; again: 3*A + 3*b*u = [3*d, 0] + 3*c*v; }
    initial { crank = 0; dot(crank) = 10; guess coupler = 1; guess rocker = 1.7; }
}

mechanism! {
    /// A hanging parallelogram whose coupler a third crank carries in its middle: one closure too many.
    Overconstrained;
    coordinates { crank [rad]; coupler [rad]; rocker [rad]; middle [rad]; }
    parameters { a [m] = 0.2; b [m] = 0.6; m [kg] = 2; n [kg] = 0.3; c [N*m*s] = 0.02; g [m/s^2] = 9.81; }
    let A = a*[cos(crank), sin(crank)];
    let u = [cos(coupler), sin(coupler)];
    let third = a*[cos(middle), sin(middle)];
    bodies {
        one: inertia 0.1 [kg*m^2], angle crank;
        two: mass m at A + 0.3*b*u, inertia m*b^2/12, angle coupler;
        three: inertia 0.2 [kg*m^2], angle rocker;
        four: mass n at [b/2, 0] + third/2, inertia n*a^2/12, angle middle;
    }
    loads { gravity [0, -g]; torque -c*dot(crank) on one; }
    constraints {
        closure: A + b*u = [b, 0] + a*[cos(rocker), sin(rocker)];
        carried: A + b/2*u = [b/2, 0] + third;
    }
    initial { crank = -0.6; dot(crank) = 1; guess coupler = 0; guess rocker = -0.6; guess middle = -0.6; }
}

mechanism! {
    /// The same held by one condition less.
    Determined;
    coordinates { crank [rad]; coupler [rad]; rocker [rad]; middle [rad]; }
    parameters { a [m] = 0.2; b [m] = 0.6; m [kg] = 2; n [kg] = 0.3; c [N*m*s] = 0.02; g [m/s^2] = 9.81; }
    let A = a*[cos(crank), sin(crank)];
    let u = [cos(coupler), sin(coupler)];
    let third = a*[cos(middle), sin(middle)];
    bodies {
        one: inertia 0.1 [kg*m^2], angle crank;
        two: mass m at A + 0.3*b*u, inertia m*b^2/12, angle coupler;
        three: inertia 0.2 [kg*m^2], angle rocker;
        four: mass n at [b/2, 0] + third/2, inertia n*a^2/12, angle middle;
    }
    loads { gravity [0, -g]; torque -c*dot(crank) on one; }
    constraints {
        closure: A + b*u = [b, 0] + a*[cos(rocker), sin(rocker)];
        carried: middle = crank;
    }
    initial { crank = -0.6; dot(crank) = 1; guess coupler = 0; guess rocker = -0.6; }
}

/// The largest difference of positions and speeds, relative to the largest of each column.
fn difference(one: &Run<AnyModel>, other: &Run<AnyModel>) -> f64 {
    assert_eq!((&one.trajectory.failure, &other.trajectory.failure), (&None, &None));
    let columns = 1..=2 * one.mechanism.n();
    let (one, other) = (Table::of(&one.mechanism, &one.trajectory), Table::of(&other.mechanism, &other.trajectory));
    let of_column = |i: usize| {
        let (a, b) = (&one.columns[i].values, &other.columns[i].values);
        assert_eq!(a.len(), b.len());
        let largest = a.iter().fold(0.0f64, |largest, a| largest.max(a.abs()));
        a.iter().zip(b).fold(0.0f64, |worst, (a, b)| worst.max((a - b).abs())) / largest
    };
    columns.map(of_column).fold(0.0, f64::max)
}

#[test]
fn partitioning_and_both_projections_agree_on_every_closed_loop() {
    fn check<M: Compiled>(mechanism: M, end: f64) {
        let settings = Settings::adaptive(Method::Dop853, end, 1e-12);
        let with = |stabilisation| run_with(mechanism, &Settings { stabilisation, ..settings }).unwrap();
        let projected = with(Stabilisation::Projection);
        for stabilisation in [Stabilisation::MassProjection, Stabilisation::Partitioning] {
            let found = difference(&projected, &with(stabilisation));
            println!("{:<20} {stabilisation:<16} {found:.1e}", M::DESCRIPTION.name);
            assert!(found < 1e-9, "{} {stabilisation}: {found:e}", M::DESCRIPTION.name);
        }
    }
    check(QuickReturn::default(), 2.0);
    check(QuickReturnRatio::default(), 2.0);
    check(FourBar::default(), 1.0);
    check(SliderCrank::default(), 1.0);
    // To where its motion, which grows until nothing holds it, has lost three digits.
    check(Andrews::default(), 0.02);
}

/// Baumgarte's method and none let the constraints drift, which is what they are offered to show.
#[test]
fn without_projection_constraints_drift() {
    let with = |stabilisation| {
        let settings = Settings { stabilisation, ..Settings::equal_steps(Method::Rk4, 2.0, 512) };
        run_with(QuickReturn::default(), &settings).unwrap().position_residual
    };
    let [projected, held, free] =
        [Stabilisation::Projection, Stabilisation::Baumgarte(20.0), Stabilisation::None].map(with);
    println!("{projected:.1e} {held:.1e} {free:.1e}");
    assert!(projected <= 1e-12 && held > 1e-12 && held < 0.2 * free);
}

/// A loop closed twice moves as one closed once, and the second closure is named.
#[test]
fn a_doubled_constraint_changes_nothing_and_is_named() {
    for method in [Method::Dop853, Method::Radau5] {
        let settings = Settings::adaptive(method, 1.0, 1e-12);
        let (once, twice) =
            (run_with(FourBar::default(), &settings).unwrap(), run_with(Doubled::default(), &settings).unwrap());
        let found = difference(&once, &twice);
        println!("{}: {found:.1e}", method.name());
        assert!(found < 1e-9, "{found:e}");
        assert_eq!(
            (twice.mobility.degrees_of_freedom, &twice.mobility.dependent[..]),
            (1, &["again_x", "again_y"][..])
        );
        assert_eq!(twice.mobility.implied_by, [["closure_x"], ["closure_y"]]);
        // lambda + 3 mu is what the one closure has; the shortest (lambda, mu) with that sum are its tenth and three of them.
        for (a, b) in once.trajectory.samples.iter().zip(&twice.trajectory.samples) {
            for axis in 0..2 {
                let whole = a.multipliers[axis];
                let shares = [b.multipliers[axis], b.multipliers[2 + axis]];
                let size = a.multipliers[axis].abs().max(1.0);
                assert!((shares[0] - 0.1 * whole).abs() < 1e-8 * size, "{shares:?} {whole}");
                assert!((shares[1] - 0.3 * whole).abs() < 1e-8 * size, "{shares:?} {whole}");
            }
        }
    }
}

/// The reactions of an overconstrained loop are the pseudo-inverse of C_q' applied to Q - h - M q'', by the singular value
/// decomposition of another library; it moves as the same loop with one condition less.
#[test]
fn an_overconstrained_loop_has_the_reactions_of_least_norm() {
    let settings = Settings::adaptive(Method::Dop853, 2.0, 1e-12);
    let run = run_with(Overconstrained::default(), &settings).unwrap();
    let determined = run_with(Determined::default(), &settings).unwrap();
    for (a, b) in run.trajectory.samples.iter().zip(&determined.trajectory.samples) {
        for i in 0..4 {
            let apart =
                (a.state.positions[i] - b.state.positions[i]).abs() + (a.state.speeds[i] - b.state.speeds[i]).abs();
            assert!(apart < 1e-9, "coordinate {i} at {}: {apart:e}", a.state.time);
        }
    }
    assert_eq!((run.mobility.degrees_of_freedom, run.mobility.dependent.len()), (1, 1));
    assert_eq!(run.mobility.dependent, ["carried_y"]);
    assert!(run.mobility.implied_by[0].contains(&"closure_x") && run.mobility.implied_by[0].contains(&"carried_x"));
    let mechanism = &run.mechanism;
    let mut worst = 0.0f64;
    for sample in &run.trajectory.samples {
        let (t, q, qd) = (sample.state.time, &sample.state.positions, &sample.state.speeds);
        let mass = mechanism.mass_matrix(t, q);
        let (loads, convective) = (mechanism.generalized_forces(t, q, qd), mechanism.convective_forces(t, q, qd));
        let missing = DVector::from_fn(4, |i, _| {
            let inertial: f64 = (0..4).map(|j| mass[i][j] * sample.accelerations[j]).sum();
            loads[i] - convective[i] - inertial
        });
        let jacobian = mechanism.constraint_jacobian(t, q);
        let transposed = DMatrix::from_fn(4, 4, |i, j| jacobian[j][i]);
        let expected = transposed.pseudo_inverse(1e-9).unwrap() * missing;
        let apart = (0..4).map(|i| (expected[i] - sample.multipliers[i]).abs()).fold(0.0, f64::max);
        worst = worst.max(apart / expected.amax());
    }
    println!("reactions {worst:.1e}");
    // Both ways amplify rounding by the condition of C_q, some tens here.
    assert!(worst < 1e-11, "{worst:e}");
}

/// A slide that moves one of its conditions by cos(90 deg) alone, 6e-17: that is no freedom the condition takes, and the arm that
/// seems to belong to it, of some 1e15 m, no length of the mechanism. It slides under its force.
#[test]
fn what_moves_a_condition_by_rounding_is_free() {
    for size in [1e-3, 1.0, 100.0] {
        let text = format!(
            "pub Slid; coordinates {{ s [m]; phi [rad]; }}
             bodies {{ slide: mass 2 [kg] at [s, 0]; arm: inertia 3 [kg]*({size} [m])^2, angle phi; }}
             loads {{ force {size} [N] on s; }} initial {{ phi = 0; s = 0; }}
             constraints {{ axis: sin(phi) = 0; plane: 0.3*({size} [m])*sin(phi) + 6e-17*s = 0; }}"
        );
        for settings in [Settings::adaptive(Method::Dop853, 2.0, 1e-10), Settings::equal_steps(Method::Rk4, 2.0, 20)] {
            let run = tests::run_with(interpreted(&text).unwrap(), &settings).unwrap();
            assert_eq!((&run.trajectory.failure, &run.mobility.dependent[..]), (&None, &["plane"][..]));
            let state = &run.trajectory.samples.last().unwrap().state;
            // F t^2/(2 m), which is a polynomial.
            assert!((state.positions[0] - size).abs() < 1e-12 * size, "{size}: {}", state.positions[0]);
        }
    }
}

/// A load on a rope of 40 m whose inertia is next to nothing: its radius of gyration says nothing of lengths. The forces between
/// trolley and load keep their common momentum.
#[test]
fn a_rope_of_almost_no_inertia_has_a_length() {
    for inertia in [1e-3, 1e-12, 1e-24] {
        let text = format!(
            "pub Crane; coordinates {{ s [m]; x [m]; y [m]; phi [rad]; }} parameters {{ l [m] = 40; }}
             bodies {{ trolley: mass 1000 [kg] at [s, 0]; load: mass 5000 [kg] at [x, y]; rope: inertia {inertia:e} [kg*m^2], angle phi; }}
             loads {{ gravity [0, -9.81 [m/s^2]]; force 1000 [N] on s; }}
             constraints {{ hang: [x, y] = [s, 0] + l*[sin(phi), -cos(phi)]; }}
             initial {{ phi = 0.3; s = 0; guess x = 12; guess y = -38; }}"
        );
        let run = tests::run_with(interpreted(&text).unwrap(), &Settings::new(5.0)).unwrap();
        assert_eq!((&run.trajectory.failure, run.mobility.degrees_of_freedom), (&None, 2));
        let speeds = &run.trajectory.samples.last().unwrap().state.speeds;
        let momentum = 1000.0 * speeds[0] + 5000.0 * speeds[1];
        assert!((momentum - 5000.0).abs() < 1e-6 * 5000.0, "{inertia:e}: {momentum}");
    }
}

/// A plane across the axis of a hinge, whose distance from it is written in so many digits: its rows are moved by nothing, and are
/// rounding, whether or not there are units.
#[test]
fn a_condition_that_nothing_moves_may_be_off_by_rounding() {
    let disc = |outputs: &str, gap: &str| {
        format!(
            "pub Disc;
             bodies {{ b: mass 1 [kg], inertia [0.01 [kg*m^2], 0.01 [kg*m^2], 0.02 [kg*m^2]]; }}
             joints {{
                hinge: revolute ground at [0, 0, 0] axis [0, 0.8, 0.6] to b at [0, 0, 0] axis [0, 0.8, 0.6];
                plane: planar ground at [0, 0.3333333333333333 [m], 0.25 [m]] axis [0, 0.8, 0.6]
                    to b at [0.1 [m], 0.3333333333333333 [m], {gap} [m]] axis [0, 0.8, 0.6];
             }}
             initial {{ dot(hinge) = 1; }} {outputs}"
        )
    };
    for outputs in ["", "outputs { turn [rad] = hinge; }"] {
        let run = |gap| tests::run_with(interpreted(&disc(outputs, gap)).unwrap(), &Settings::new(1.0));
        let rounded = run("0.25000000000000006").unwrap();
        assert_eq!(rounded.mobility.dependent, ["plane_f", "plane_m1", "plane_m2"]);
        assert!((rounded.trajectory.samples.last().unwrap().state.positions[0] - 1.0).abs() < 1e-12);
        assert!(matches!(run("0.2500001").unwrap_err().what, What::NotAssembled { .. }));
    }
}
