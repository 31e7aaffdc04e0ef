//! Loops that close in closed form.

use models::{Andrews, FourBar, QuickReturn, QuickReturnRatio, SliderCrank};
use sim::{Array, Compiled, Form, Start, assemble, branches, declared_start, mechanism};
use std::f64::consts::{FRAC_PI_2, PI};
use tests::Random;

/// Every configuration holds the constraints to rounding; their number.
fn count<M: Compiled>(mechanism: &M, start: &Start<M>) -> usize {
    let found = branches(mechanism, start);
    for q in &found.positions {
        for residual in mechanism.constraints(0.0, q).iter() {
            assert!(residual.abs() < 1e-12, "{residual:e}");
        }
    }
    found.positions.len()
}

#[test]
fn a_four_bar_has_its_elbow_up_or_down() {
    let linkage = FourBar::default();
    let mut random = Random(4);
    for _ in 0..200 {
        let crank = random.between(-7.0, 7.0);
        let start = Start { positions: [crank, 1.0, 1.7], ..declared_start(&linkage) };
        let found = branches(&linkage, &start);
        assert_eq!((found.loops.len(), found.loops[0].form, found.positions.len()), (1, Form::Rrr, 2));
        assert_eq!((found.loops[0].constraints.len(), &found.loops[0].coordinates[..]), (2, &["theta3", "theta4"][..]));
        // The diagonal from A to O4 halves the angle between both: they are mirror images.
        let diagonal = (-0.2 * crank.sin()).atan2(0.6 - 0.2 * crank.cos());
        let mirrored = found.positions[0][1] + found.positions[1][1] - 2.0 * diagonal;
        assert!((mirrored / (2.0 * PI) - (mirrored / (2.0 * PI)).round()).abs() < 1e-13);
        count(&linkage, &start);
    }
    // Where the links do not reach there is none, and where they only just do there is one.
    let far = FourBar { d: 1.4, ..linkage };
    assert_eq!(count(&far, &Start { positions: [PI, 0.0, 0.0], ..declared_start(&far) }), 0);
    let just = FourBar { d: 1.3, ..linkage };
    assert_eq!(count(&just, &Start { positions: [0.0, 0.0, PI], ..declared_start(&just) }), 1);
}

/// The guess decides which is taken, however far it is.
#[test]
fn assembly_takes_the_branch_nearest_to_the_guesses() {
    let linkage = FourBar::default();
    for (guess, up) in [([0.0, 1.0, 1.7], true), ([0.0, -1.0, 4.0], false), ([0.0, -2.4, 4.2], false)] {
        let start = Start { positions: guess, ..declared_start(&linkage) };
        let found = assemble(&linkage, &start).unwrap().positions;
        assert!((found[1] > 0.0) == up, "{guess:?}: {found:?}");
    }
}

#[test]
fn shipped_mechanisms_have_the_branches_that_they_should() {
    let (quick, slider) = (QuickReturn::default(), SliderCrank::default());
    // Bar 5 to the left or right; the rocker the other way round does not reach the guide.
    assert_eq!(count(&quick, &declared_start(&quick)), 2);
    let low = QuickReturn { yc: 0.1, BC: 0.8, ..quick };
    assert_eq!(count(&low, &declared_start(&low)), 4);
    assert_eq!(count(&slider, &declared_start(&slider)), 2);
    // A quotient of coordinates is of no form that is known; Newton's method finds what its guess is near to.
    let ratio = QuickReturnRatio::default();
    assert_eq!((branches(&ratio, &declared_start(&ratio)).open.len(), count(&ratio, &declared_start(&ratio))), (2, 1));
}

/// Angles from the link before: Andrews' mechanism has three loops, each closed by two angles of which one is relative.
#[test]
fn relative_angles_are_recognised() {
    let andrews = Andrews::default();
    let found = branches(&andrews, &declared_start(&andrews));

    assert!(found.loops.len() == 3 && found.open.is_empty() && found.loops.iter().all(|l| l.form == Form::Rrr));
    let nearest = assemble(&andrews, &declared_start(&andrews)).unwrap().positions;
    for (a, b) in nearest.iter().zip(found.positions[0].iter()) {
        assert!((a - b).abs() < 1e-12);
    }
    count(&andrews, &declared_start(&andrews));
}

mechanism! {
    /// A crank with a rod to a slider on an inclined guide, whose place is a coordinate; and a wedge that two coordinates move.
    Inclined;
    coordinates { theta [rad]; s [mm]; phi [rad]; u [m]; v [m]; }
    parameters { r [m] = 0.1; l [m] = 0.3; m [kg] = 1; }
    let A = r*[cos(theta), sin(theta)];
    let P = [0.05 [m], 0.02 [m]] + s*[cos(0.4), sin(0.4)];
    bodies { slider: mass m at P; wedge: mass m at [u, v]; crank: inertia m*r^2, angle theta; rod: inertia m*l^2, angle phi; }
    constraints { rod: A + l*[cos(phi), sin(phi)] = P; wedge: [u + v, u - v] = A; }
    initial { theta = 1; guess s = 300; guess phi = 0.2; }
}

#[test]
fn a_link_and_a_slider_close_in_an_angle_and_a_length() {
    let inclined = Inclined::default();
    let found = branches(&inclined, &declared_start(&inclined));
    let forms: Vec<Form> = found.loops.iter().map(|l| l.form).collect();
    assert_eq!((forms, found.positions.len()), (vec![Form::Rrp, Form::Pp], 2));
    assert_eq!(count(&inclined, &declared_start(&inclined)), 2);
    // Across the guide the rod's angles are mirror images: phi - 0.4 and pi - (phi - 0.4).
    let sum = found.positions[0][2] + found.positions[1][2] - 0.8;
    assert!((sum.abs() - PI).abs() < 1e-14, "{sum}");
    let [x, y] = [0.1 * 1f64.cos(), 0.1 * 1f64.sin()];
    assert!((found.positions[0][3] - (x + y) / 2.0).abs() < 1e-16 && FRAC_PI_2 > found.positions[0][2]);
}

mechanism! {
    /// Ten arms that each close in two ways.
    Arms;
    const n = 10;
    coordinates { repeat i in 1..=n { phi_[i]; } s; }
    bodies { cart: mass 1 at [s, 0]; repeat i in 1..=n { arm_[i]: mass 1 at [cos(phi_[i]), sin(phi_[i])]; } }
    constraints { repeat i in 1..=n { reach_[i]: cos(phi_[i]) = s; } }
    initial { s = 0.5; repeat i in 1..=n { guess phi_[i] = 1; } }
}

/// Two to the tenth configurations are not all followed, the one at the guesses is: cos 60 deg = 1/2.
#[test]
fn of_many_ways_to_close_the_nearest_are_followed() {
    let mut start = declared_start(&Arms::default());
    start.positions[3] = -0.9;
    let found = branches(&Arms::default(), &start);
    assert_eq!((found.loops.len(), found.positions.len()), (10, 256));
    let expected = |j: usize| if j == 3 { -PI / 3.0 } else { PI / 3.0 };
    (0..10).for_each(|j| assert!((found.positions[0][j] - expected(j)).abs() < 1e-12, "{j}: {:?}", found.positions[0]));
}
