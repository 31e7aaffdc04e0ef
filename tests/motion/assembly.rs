//! Assembly of the start.

use sim::{Settings, What, assemble, declared_start, mechanism};
use tests::any_model::{interpreted, run};
use tests::run_with;

mechanism! {
    /// A four-bar linkage.
    FourBar;
    coordinates { crank [deg]; coupler [deg]; rocker [deg]; }
    parameters { a [m] = 0.2; b [m] = 0.6; c [m] = 0.5; d [m] = 0.6; J [kg*m^2] = 0.1; start [deg] = 0; }
    let A = a*[cos(crank), sin(crank)];
    let B = A + b*[cos(coupler), sin(coupler)];
    bodies {
        one: inertia J, angle crank;
        two: inertia J, angle coupler;
        three: inertia J, angle rocker;
    }
    constraints { closure: B = [d, 0] + c*[cos(rocker), sin(rocker)]; }
    initial { crank = start; dot(crank) = 10; guess coupler = 60; guess rocker = 100; }
}

mechanism! {
    /// A point that must be at two heights.
    Contradiction;
    coordinates { x [m]; y [m]; }
    parameters { m [kg] = 1; }
    bodies { point: mass m at [x, y]; }
    constraints { low: y = 1 [m]; far: x = 3 [m]; high: y = 2 [m]; }
}

mechanism! {
    /// Nothing given: assembly finds the nearest point of the circle.
    Free;
    coordinates { x [m]; y [m]; }
    parameters { m [kg] = 1; }
    bodies { point: mass m at [x, y]; }
    constraints { circle: x^2 + y^2 = 25 [m^2]; }
    initial { guess x = 3.3; guess y = 4.4; dot(x) = 8; }
}

#[test]
fn a_four_bar_closes_on_the_branch_of_its_guesses() {
    let linkage = FourBar::default();
    let state = assemble(&linkage, &declared_start(&linkage)).unwrap();
    let [crank, coupler, rocker] = state.positions;
    assert_eq!(crank, 0.0);
    // With the crank along the ground link: law of cosines in the triangle of sides d - a, b, c.
    let (b, c, base) = (0.6f64, 0.5f64, 0.4f64);
    let at_crank = ((base * base + b * b - c * c) / (2.0 * base * b)).acos();
    let at_rocker = ((base * base + c * c - b * b) / (2.0 * base * c)).acos();
    assert!((coupler - at_crank).abs() < 1e-12 && (rocker - (std::f64::consts::PI - at_rocker)).abs() < 1e-12);
    // A plain number in `initial` is in the coordinate's unit: 10 degrees a second.
    assert!((state.speeds[0] - 10f64.to_radians()).abs() < 1e-15);
}

#[test]
fn the_nearest_configuration_is_found_and_speeds_follow() {
    let mechanism = Free::default();
    let state = assemble(&mechanism, &declared_start(&mechanism)).unwrap();
    assert!((state.positions[0] - 3.0).abs() < 1e-12 && (state.positions[1] - 4.0).abs() < 1e-12);
    assert_eq!(state.speeds[0], 8.0);
    assert!((state.speeds[1] + 6.0).abs() < 1e-12);
}

#[test]
fn what_cannot_be_assembled_names_the_constraint_and_the_closest_state() {
    let mechanism = Contradiction::default();
    let failure = assemble(&mechanism, &declared_start(&mechanism)).unwrap_err();
    let What::NotAssembled { constraint, residual, ref others } = failure.what else { panic!("{failure}") };
    assert!(constraint == "low" && (residual.abs() - 0.5).abs() < 1e-9 && others.contains("`high`"), "{failure}");
    assert!(!others.contains("far"), "{failure}");
    let [("x", x), ("y", y)] = failure.state[..] else { panic!("{failure}") };
    assert!((x - 3.0).abs() < 1e-12 && (y - 1.5).abs() < 1e-12, "{failure}");
    let too_long = FourBar { d: 2.0, ..FourBar::default() };
    assert!(run(too_long, 1.0, 10).unwrap_err().to_string().contains("`closure_x` stays open"));
}

#[test]
fn contradicting_speeds_name_the_constraint() {
    let linkage = FourBar::default();
    let mut start = declared_start(&linkage);
    start.speed_given = vec![true; 3];
    start.speeds = [1.0, 0.0, 0.0];
    let failure = assemble(&linkage, &start).unwrap_err();
    assert!(matches!(failure.what, What::SpeedsContradict { constraint: "closure_y", .. }), "{failure}");
}

mechanism! {
    /// A four-bar whose coupler's constraint is in square metres, with a gear whose constraint has no unit.
    Geared;
    coordinates { a [rad]; c [rad]; w [rad]; }
    parameters { s [m] = 1; J [kg*m^2] = 1; }
    let P = s*[cos(a), sin(a)];
    let R = [3.5*s, 0] + 2*s*[cos(c), sin(c)];
    bodies { crank: inertia J, angle a; rocker: inertia J, angle c; wheel: inertia J, angle w; }
    constraints { coupler: inner(P - R, P - R) = 9*s^2; gear: w = 2*a; }
    initial { a = 0.8; dot(a) = 2; guess c = 1.5; guess w = 1.6; }
}

/// Angles do not depend on size or inertia, also where the rows of C_q differ by a factor of 1e13.
#[test]
fn starts_do_not_depend_on_the_size_of_a_row() {
    let state = |s: f64, inertia: f64| {
        let geared: Geared = Geared { s, J: inertia };
        assemble(&geared, &declared_start(&geared)).unwrap()
    };
    let known = state(1.0, 1.0);
    // c' = 2 (P - R).P' / ((P - R).R' of c' = 1).
    let ([a, c], d) = ([0.8f64, known.positions[1]], 3.5);
    let gap = [a.cos() - d - 2.0 * c.cos(), a.sin() - 2.0 * c.sin()];
    let rate = 2.0 * (gap[1] * a.cos() - gap[0] * a.sin()) / (2.0 * (gap[1] * c.cos() - gap[0] * c.sin()));
    for (s, inertia) in [(1.0, 1.0), (1e-3, 1e-9), (1e-6, 1e-22), (3e-7, 1e-25)] {
        let found = state(s, inertia);
        // Positions are met to 1e-12 of the terms.
        assert!((found.speeds[1] - rate).abs() < 1e-10, "{s}: {} for {rate}", found.speeds[1]);
        assert!((found.positions[1] - c).abs() < 1e-10, "{s}: {}", found.positions[1]);
    }
}

/// A door on two hinges along one axis, of which the second is written in so many digits that it lies 2e-17 m beside: no
/// coordinate moves its rows, and it closes.
#[test]
fn a_second_hinge_may_be_off_by_rounding() {
    let door = interpreted(
        "pub Door; bodies { door: mass 20 [kg], inertia [1 [kg*m^2], 1 [kg*m^2], 2 [kg*m^2]]; }
        joints {
            lower: revolute ground at [0, 0, 0] axis [0, 0.6, 0.8] to door at [-0.4 [m], 0, 0] axis [0, 0, 1];
            upper: revolute ground at [0, 0.19999999999999998 [m], 0.26666666666666666 [m]] axis [0, 0.6, 0.8]
                to door at [-0.4 [m], 0, 0.3333333333333333 [m]] axis [0, 0, 1];
        }
        loads { gravity [0, 0, -9.81 [m/s^2]]; } initial { lower = 0.3; }",
    )
    .unwrap();
    let run = tests::run_with(door, &Settings::new(1.0)).unwrap();
    assert_eq!(run.trajectory.failure, None);
    // The moment of inertia about the hinges is 2 + 20 0.4^2 kg m^2; the energy is conserved.
    let last = run.trajectory.samples.last().unwrap();
    let (kinetic, work) = (last.state.speeds[0].powi(2) * (2.0 + 20.0 * 0.16) / 2.0, last.state.work);
    assert!((kinetic - work).abs() < 1e-8 && kinetic > 0.01, "{kinetic} J, {work} J");
}

/// What turns fast, or is large, carries a loop that is closed in itself: the rates at which it opens are rounding.
#[test]
fn rates_of_what_is_carried_along_are_rounding() {
    for (size, speed) in [(1.0, 1e6), (1e5, 2.0), (1e6, 2.0)] {
        let carried = interpreted(&format!(
            "pub Carried;
            bodies {{ a: mass 1 [kg], inertia [1 [kg*m^2], 1 [kg*m^2], 1 [kg*m^2]];
                b: mass 1 [kg], inertia [1 [kg*m^2], 1 [kg*m^2], 1 [kg*m^2]]; }}
            joints {{
                j0: revolute ground at [0, 0, 0] axis [0, 0.6, 0.8] to a at [{} [m], 0, 0] axis [0, 0.6, 0.8];
                j1: planar a at [0, 0, 0] axis [0, 0, 1] to b at [0, 0, 0] axis [0, 0, 1];
                k0: ball b at [{} [m], 0, 0] to a at [{} [m], {} [m], 0];
            }}
            initial {{ guess j0 = 0.3; guess j1_x = {} [m]; guess j1_y = {} [m]; guess j1_turn = 0.4; dot(j0) = {speed}; }}",
            -0.3 * size, 0.37 * size, 0.7 * size, 0.11 * size, 0.1 * size, 0.1 * size
        ))
        .unwrap();
        let state = assemble(&carried, &declared_start(&carried)).unwrap();
        assert!((state.speeds[0] - speed).abs() < 1e-9 * speed);
        // Those of the loop in itself are 0.
        assert!((1..4).all(|j| state.speeds[j].abs() < 1e-9 * speed * size), "{:?}", state.speeds);
    }
}

/// At a dead point the crank says nothing of the slider: pi/2 is known to rounding, and its cosine is none.
#[test]
fn a_speed_that_a_dead_point_does_not_allow_is_refused() {
    let ways = [("sin", "pi/2"), ("sin", "90 [deg]"), ("cos", "0"), ("cos", "pi"), ("cos", "1e-300"), ("sin", "-pi/2")];
    for (way, angle) in ways {
        for size in [1e-3, 0.5, 1e3] {
            let text = format!(
                "pub Dead; coordinates {{ a [rad]; x [m]; }}
                 bodies {{ crank: inertia 1 [kg*m^2], angle a; slider: mass 1 [kg] at [x, 0]; }}
                 constraints {{ c: x = {size:?} [m]*{way}(a); }} initial {{ a = {angle}; dot(x) = {size:?}; }}"
            );
            let model = interpreted(&text).unwrap();
            let failure = assemble(&model, &declared_start(&model)).unwrap_err();
            assert!(
                matches!(failure.what, What::SpeedsContradict { constraint: "c", .. }),
                "{way} {angle} {size}: {failure}"
            );
        }
    }
    // A little before it, it turns fast.
    let text = "pub Near; coordinates { a [rad]; x [m]; }
        bodies { crank: inertia 1 [kg*m^2], angle a; slider: mass 1 [kg] at [x, 0]; }
        constraints { c: x = 0.5 [m]*cos(a); } initial { a = 1e-7; dot(x) = 1; }";
    let model = interpreted(text).unwrap();
    let speed = assemble(&model, &declared_start(&model)).unwrap().speeds[0];
    assert!((speed / -2e7 - 1.0).abs() < 1e-9, "{speed:e}");
}

/// The direction of a cylinder along an axis of the world: cos 90 deg is 6e-17, and says nothing of the size of the mechanism.
#[test]
fn a_cylinder_stands_at_right_angles_as_at_others() {
    for (degrees, scale) in
        [0.0f64, 90.0, 180.0, 270.0, -90.0, 37.0].into_iter().flat_map(|a| [1e-3, 1.0, 100.0].map(|s| (a, s)))
    {
        let text = format!(
            "pub Cylinder; coordinates {{ a [deg]; b [deg]; x [m]; }}
             parameters {{ r [m] = {:e}; l [m] = {:e}; be [deg] = {degrees}; a0 [deg] = {}; }}
             bodies {{ crank: inertia {:e} [kg*m^2], angle a; piston: mass 0.6 [kg] at x*[cos(be), sin(be)]; }}
             constraints {{ c: r*[cos(a), sin(a)] + l*[cos(b), sin(b)] = x*[cos(be), sin(be)]; }}
             initial {{ a = a0; dot(a) = 3600; guess b = be + 6 [deg]; guess x = l; }}",
            0.045 * scale,
            0.15 * scale,
            degrees + 70.0,
            0.1 * scale * scale
        );
        let run = run_with(interpreted(&text).unwrap(), &Settings::new(0.05)).unwrap();
        assert_eq!(run.trajectory.failure, None, "{degrees} {scale}");
        // Along the cylinder, with the crank at the angle t from it: x = r cos t + sqrt(l^2 - r^2 sin(t)^2).
        for sample in [&run.trajectory.samples[0], run.trajectory.samples.last().unwrap()] {
            let (q, speeds) = (&sample.state.positions, &sample.state.speeds);
            let (r, l, angle) = (0.045 * scale, 0.15 * scale, q[0] - degrees.to_radians());
            let root = (l * l - (r * angle.sin()).powi(2)).sqrt();
            let speed = -r * angle.sin() * (1.0 + r * angle.cos() / root) * speeds[0];
            assert!((q[2] - r * angle.cos() - root).abs() < 1e-12 * scale, "{degrees} {scale}: {}", q[2]);
            // The tolerance of the run, at some 60 rad/s.
            assert!((speeds[2] - speed).abs() < 1e-8 * scale, "{degrees} {scale}: {} for {speed}", speeds[2]);
        }
        // All energy is kinetic, and kept.
        let energy = |k: usize| {
            let speeds = &run.trajectory.samples[k].state.speeds;
            0.1 * (scale * speeds[0]).powi(2) / 2.0 + 0.3 * speeds[2].powi(2)
        };
        let (first, last) = (energy(0), energy(run.trajectory.samples.len() - 1));
        assert!((last - first).abs() < 1e-8 * first, "{degrees} {scale}: {first} {last}");
    }
}
