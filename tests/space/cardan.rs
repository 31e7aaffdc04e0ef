//! A universal joint that closes a loop of two hinges: rows of it that nothing moves are redundant, and the motion has a closed form.

use crate::common::{apart, column};
use sim::{Compiled, Settings, Stabilisation, mechanism};
use tests::any_model::run_with;

mechanism! {
    /// Two shafts in hinges of the ground, whose axes meet in the centre of the cross.
    pub(crate) Loop;
    parameters { beta [deg] = 30; J [kg*m^2] = 0.02; m [kg] = 1; speed [rad/s] = 10; }
    bodies { first: mass m, inertia [J, J, J]; second: mass m, inertia [J, J, J]; }
    joints {
        a: revolute ground at [0, 0, 0] axis [1, 0, 0] to first at [0, 0, 0] axis [1, 0, 0];
        b: revolute ground at [0, 0, 0] axis [cos(beta), sin(beta), 0] to second at [0, 0, 0] axis [1, 0, 0];
        cross: universal first at [0, 0, 0] axis [0, 0, 1] to second at [0, 0, 0] axis [0, 1, 0];
    }
    initial { a = 0; dot(a) = speed; guess b = 0; }
    outputs { ratio = dot(b)/dot(a); force [N] = norm(reaction(cross)); }
}

mechanism! {
    /// The same with the hinges away from the centre of the cross.
    pub(crate) Apart;
    parameters { beta [deg] = 30; J [kg*m^2] = 0.02; m [kg] = 1; speed [rad/s] = 10; l [m] = 0.3; }
    bodies { first: mass m, inertia [J, J, J]; second: mass m, inertia [J, J, J]; }
    joints {
        a: revolute ground at [-l, 0, 0] axis [1, 0, 0] to first at [0, 0, 0] axis [1, 0, 0];
        b: revolute ground at [l*cos(beta), l*sin(beta), 0] axis [cos(beta), sin(beta), 0] to second at [0, 0, 0] axis [1, 0, 0];
        cross: universal first at [l, 0, 0] axis [0, 0, 1] to second at [-l, 0, 0] axis [0, 1, 0];
    }
    initial { a = 0; dot(a) = speed; guess b = 0; }
    outputs { ratio = dot(b)/dot(a); force [N] = norm(reaction(cross)); }
}

/// The ratio of speeds is cos(beta)/(1 - sin(beta)^2 sin(a)^2), where the fork of the first shaft is across the plane of the shafts at
/// a = 0 (Wittenburg, Dynamics of Multibody Systems, 2008, section 5.1), and J (a'^2 + b'^2) is constant.
fn check<M: Compiled + Copy>(mechanism: M) {
    let (sin, cos) = 30f64.to_radians().sin_cos();
    let ratio = |a: f64| cos / (1.0 - (sin * a.sin()).powi(2));
    let speed = |a: f64| 10.0 * ((1.0 + ratio(0.0).powi(2)) / (1.0 + ratio(a).powi(2))).sqrt();
    for stabilisation in [Stabilisation::Projection, Stabilisation::Partitioning] {
        let mut settings = Settings::new(1.0);
        settings.stabilisation = stabilisation;
        let run = run_with(mechanism, &settings).unwrap();
        assert_eq!(run.mobility.degrees_of_freedom, 1);
        // The joint's equations hold to rounding; the motion has the tolerance of 1e-10, at speeds of 10.
        assert!(apart(&run, "ratio", "a", ratio) < 1e-12);
        assert!(apart(&run, "a_dot", "a", speed) < 1e-8);
        assert!(column(&run, "force").iter().all(|force| *force == 0.0));
    }
}

#[test]
fn a_universal_joint_closes_a_loop_of_two_hinges() {
    check(Loop::defaults());
    check(Apart::defaults());
}
