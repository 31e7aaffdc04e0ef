//! Joints and loops in space against geometry.

use crate::common::{apart, column};
use models::{Bennett, Cardan, Rssr, Stewart};
use sim::{Method, Settings, mechanism, mobility};
use std::f64::consts::TAU;
use tests::any_model::run_with;

/// cos(beta)/(1 - sin(beta)^2 cos(alpha)^2)
fn cardan_ratio(beta: f64, alpha: f64) -> f64 {
    beta.cos() / (1.0 - (beta.sin() * alpha.cos()).powi(2))
}

#[test]
fn cardans_joint_has_its_ratio_of_speeds() {
    let joint = Cardan::default();
    let run = run_with(joint, &Settings::adaptive(Method::Dop853, 1.0, 1e-12)).unwrap();
    let worst = apart(&run, "ratio", "alpha", |alpha| cardan_ratio(joint.beta, alpha));
    let turns = column(&run, "alpha").last().unwrap() / TAU;
    println!("Cardan's joint: ratio of speeds off by {worst:.1e} in {turns:.1} turns");
    assert!(worst < 1e-12 && turns > 3.0, "{worst:e}");
}

mechanism! {
    /// The same of three free bodies, two shafts in bearings and their joint, by joints alone.
    pub(crate) CardanOfBodies;
    parameters { m [kg] = 1; J [kg*m^2] = 0.02; l [m] = 0.2; w [rad/s] = 30; }
    let beta = 35 [deg];
    bodies {
        driving: free, mass m, inertia [J, 2*J, 2*J];
        driven: free, mass m, inertia [J, 2*J, 2*J];
    }
    joints {
        bearing: revolute ground at [-l, 0, 0] axis [1, 0, 0] to driving at [0, 0, 0] axis [1, 0, 0];
        cross: universal driving at [l, 0, 0] axis [0, 1, 0] to driven at [-l, 0, 0] axis [0, 0, 1];
        guide: cylindrical ground at [0, 0, 0] axis [cos(beta), sin(beta), 0] to driven at [0, 0, 0] axis [1, 0, 0];
    }
    initial {
        driving_x = -l; driving_y = 0; driving_z = 0; driving_q0 = 1; driving_q1 = 0;
        guess driven_x = l*cos(beta); guess driven_y = l*sin(beta); guess driven_q0 = cos(beta/2); guess driven_q3 = sin(beta/2);
        dot(driving_q1) = w/2;
    }
    outputs {
        ratio = inner(omega(driven), [cos(beta), sin(beta), 0])/omega(driving).x;
        cosine = (attitude(driving)*[0, 1, 0]).y;
        bearing_moment [N*m] = reaction(bearing_m1);
    }
}

#[test]
fn cardans_joint_by_joints_of_free_bodies() {
    let run = run_with(CardanOfBodies::default(), &Settings::adaptive(Method::Dop853, 0.5, 1e-12)).unwrap();
    let beta = 35f64.to_radians();
    let worst = apart(&run, "ratio", "cosine", |cosine| beta.cos() / (1.0 - (beta.sin() * cosine).powi(2)));
    println!(
        "Cardan's joint of free bodies: {} freedom, dependent {:?}, ratio off by {worst:.1e}, energy {:.1e}",
        run.mobility.degrees_of_freedom, run.mobility.dependent, run.energy_balance
    );
    assert_eq!(run.mobility.degrees_of_freedom, 1);
    assert!(worst < 1e-12 && run.energy_balance < 1e-9, "{worst:e}");
}

#[test]
fn bennetts_linkage_moves_though_counting_says_that_it_cannot() {
    let linkage: Bennett = Bennett::default();
    let beta = (linkage.b * linkage.alpha.sin() / linkage.a).asin();
    let product = ((beta + linkage.alpha) / 2.0).sin() / ((beta - linkage.alpha) / 2.0).sin();
    let run = run_with(linkage, &Settings::adaptive(Method::Dop853, 1.0, 1e-11)).unwrap();
    let second = |theta1: f64| 2.0 * (product / (theta1 / 2.0).tan()).atan();
    let turned = apart(&run, "theta2", "theta1", second);
    let mirrored = apart(&run, "theta3", "theta1", |theta1| -theta1);
    let swing = column(&run, "theta1");
    let (low, high) = swing.iter().fold((f64::MAX, f64::MIN), |(low, high), x| (low.min(*x), high.max(*x)));
    println!(
        "Bennett: turns {low:.2} to {high:.2} rad, theta2 off by {turned:.1e}, theta3 by {mirrored:.1e}; redundant {:?}, energy {:.1e}",
        run.mobility.dependent, run.energy_balance
    );
    assert_eq!(run.mobility.degrees_of_freedom, 1);
    assert_eq!(run.mobility.dependent.len(), 3);
    assert!(run.mobility.dependent.iter().all(|name| name.starts_with("closure")));
    assert!(high - low > 0.5 && turned < 1e-9 && mirrored < 1e-9, "{turned:e} {mirrored:e}");
}

mechanism! {
    /// Every other joint between free bodies, and one that is welded on.
    pub(crate) Joined;
    parameters { m [kg] = 1; J [kg*m^2] = 0.02; l [m] = 0.2; g [m/s^2] = 9.81; }
    bodies {
        a: free, mass m, inertia [J, J, J];
        b: free, mass m, inertia [J, 2*J, 2*J];
        c: free, mass m, inertia [J, 1.5*J, J];
        d: free, mass m, inertia [J, J, J];
        e: free, mass m, inertia [J, J, J];
        f: free, mass m, inertia [J, J, J];
    }
    loads { gravity [0, -g, -g/2]; }
    joints {
        slide: prismatic ground at [0, 0, 0] axis [0.6, 0, 0.8] to a at [0, 0, 0] axis [0.6, 0, 0.8];
        hang: ball a at [0, -l, 0] to b at [0, l, 0];
        drive: screw ground at [1 [m], 0, 0] axis [0, 1, 0] to c at [0, 0, 0] axis [0, 1, 0] pitch l;
        table: planar ground at [0, 0, 0] axis [0, 0, 1] to d at [0, 0, 0] axis [0, 0, 1];
        rigid: weld d at [l, 0, 0] to e at [-l, 0, 0];
        tube: cylindrical c at [0, 0, 0] axis [1, 0, 0] to f at [0, 0, 0] axis [1, 0, 0];
    }
    initial {
        guess a_x = 0; guess b_y = -0.4; guess c_x = 1; c_y = 0; guess d_x = 0.5; guess e_x = 0.9; guess f_x = 1.2;
        dot(b_q1) = 0.7; dot(d_q3) = 1.5; dot(c_q2) = 1; d_y = 0.3;
    }
    outputs {
        advance [m] = on(c, [0, 0, 0]).y;
        turned [rad] = 2*atan2(c_q2, c_q0);
        height [m] = on(e, [0, 0, 0]).z;
        held [m] = norm(on(e, [0, 0, 0]) - on(d, [0, 0, 0]));
        tilted = (attitude(a)*[0, 0, 1]).z;
        across [m] = (on(a, [0, 0, 0]) - [0, 0, 0]).y;
        bob [m] = norm(on(b, [0, l, 0]) - on(a, [0, -l, 0]));
        weld_moment [N*m] = reaction(rigid_m3);
    }
}

/// What each joint leaves: 1 of the prismatic, 3 of the ball, 1 of the screw, 3 of the plane, 0 of the weld, 2 of the tube.
#[test]
fn joints_leave_what_they_should() {
    let joined = Joined::default();
    let run = run_with(joined, &Settings::adaptive(Method::Dop853, 0.6, 1e-11)).unwrap();
    let start = run.trajectory.samples[0].state.clone();
    assert_eq!(mobility(&run.mechanism, 0.0, &start.positions).degrees_of_freedom, 10);
    let pitch = joined.l;
    let screw = apart(&run, "advance", "turned", |angle| pitch * angle / TAU);
    let still = ["height", "across", "bob"].map(|name| column(&run, name).iter().fold(0.0f64, |m, x| m.max(x.abs())));
    let held = column(&run, "held").iter().map(|x| (x - 2.0 * joined.l).abs()).fold(0.0, f64::max);
    println!("joints: screw off by {screw:.1e}, still {still:?}, welded {held:.1e}, energy {:.1e}", run.energy_balance);
    // The screw holds between speeds, so that its error is that of integration.
    assert!(screw < 1e-9 && still.iter().all(|x| *x < 1e-11) && held < 1e-11, "{screw:e} {held:e} {still:?}");
    assert!(run.energy_balance < 1e-9);
}

/// With legs of one length the platform is level, at the height of that geometry; the legs' forces balance its weight and its
/// acceleration, by symmetry each the same.
#[test]
fn stewarts_platform_goes_straight_up() {
    let platform: Stewart = Stewart::default();
    let Stewart { m, R, r, foot, head, L, heave, w, g, .. } = platform;
    // A head is 60 degrees less both halves ahead of its foot.
    let across = R * R + r * r - 2.0 * R * r * (60f64.to_radians() - foot - head).cos();
    let height = |t: f64| ((L + heave * (w * t).sin()).powi(2) - across).sqrt();
    let run = run_with(platform, &Settings::adaptive(Method::Dop853, 2.0, 1e-11)).unwrap();
    let off = apart(&run, "height", "t", height);
    let lean = column(&run, "lean").iter().map(|x| (x - 1.0).abs()).fold(0.0, f64::max);
    let second = |t: f64| {
        let (l, l1, l2) = (L + heave * (w * t).sin(), heave * w * (w * t).cos(), -heave * w * w * (w * t).sin());
        let z = height(t);
        let z1 = l * l1 / z;
        (l1 * l1 + l * l2 - z1 * z1) / z
    };
    let tension = |t: f64| -m * (g + second(t)) / 6.0 * (L + heave * (w * t).sin()) / height(t);
    let force = apart(&run, "force1", "t", tension) / (m * g);
    println!("Stewart's platform: height off by {off:.1e}, lean {lean:.1e}, force in a leg {force:.1e} of the weight");
    assert_eq!(run.mobility.degrees_of_freedom, 0);
    assert!(off < 1e-11 && lean < 1e-11 && force < 1e-9, "{off:e} {lean:e} {force:e}");
}

/// Both angles of the rocker at an angle of the crank: |A - B|^2 = c^2 as a cos(psi) + b sin(psi) = k.
pub(crate) fn rssr_rocker([a, b, c, dx, dz]: [f64; 5], phi: f64) -> [f64; 2] {
    // From A to the rocker's axis; B = O - b [sin(psi), 0, cos(psi)].
    let [x, y, z] = [dx - a * phi.cos(), -a * phi.sin(), dz];
    let k = (x * x + y * y + z * z + b * b - c * c) / (2.0 * b);
    let middle = x.atan2(z);
    let half = (k / x.hypot(z)).acos();
    [middle - half, middle + half]
}

#[test]
fn a_spatial_four_bar_closes() {
    let linkage: Rssr = Rssr::default();
    let Rssr { a, b, c, dx, dz, .. } = linkage;
    let run = run_with(linkage, &Settings::adaptive(Method::Dop853, 2.0, 1e-11)).unwrap();
    let rocker = |phi| rssr_rocker([a, b, c, dx, dz], phi);
    let start = column(&run, "psi")[0];
    let root = usize::from((rocker(0.0)[1] - start).abs() < (rocker(0.0)[0] - start).abs());
    let off = apart(&run, "psi", "phi", |phi| rocker(phi)[root]);
    let turns = column(&run, "phi").last().unwrap() / TAU;
    println!("spatial four-bar: rocker off by {off:.1e} in {turns:.1} turns, energy {:.1e}", run.energy_balance);
    assert!(off < 1e-12 && turns > 1.0 && run.energy_balance < 1e-9, "{off:e}");
}
