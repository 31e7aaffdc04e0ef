//! Linkages declared as bodies and joints, against the references and closed forms.

use crate::linkages::compare;
use sim::{Mechanism, Method, Rows, Run, Settings, Table, mechanism};
use tests::any_model::run_with;
use tests::reference;

mechanism! {
    /// The four-bar of the models: three free rods and four pins, each named "body, then what it is pinned to".
    FourBarJoints;
    parameters { a [m] = 0.2; b [m] = 0.6; c [m] = 0.5; d [m] = 0.6; m2 [kg] = 2; m3 [kg] = 4; m4 [kg] = 3; g [m/s^2] = 9.81; }
    bodies {
        crank: free, mass m2, inertia m2*a^2/12;
        coupler: free, mass m3, inertia m3*b^2/12;
        rocker: free, mass m4, inertia m4*c^2/12;
    }
    loads { gravity [0, -g]; }
    joints {
        O2: pin on(crank, [-a/2, 0]) to [0, 0];
        A: pin on(coupler, [-b/2, 0]) to on(crank, [a/2, 0]);
        B: pin on(coupler, [b/2, 0]) to on(rocker, [c/2, 0]);
        O4: pin on(rocker, [-c/2, 0]) to [d, 0];
    }
    initial {
        crank_phi = 0; dot(crank_phi) = 10; guess coupler_phi = 1; guess rocker_phi = 1.7;
        guess crank_x = 0.1; guess coupler_x = 0.35; guess coupler_y = 0.25; guess rocker_x = 0.57; guess rocker_y = 0.25;
    }
    drawing { line [0, 0], on(crank, [a/2, 0]), on(rocker, [c/2, 0]), [d, 0]; }
}

#[test]
fn the_pins_of_a_four_bar_of_bodies_and_joints() {
    let settings = Settings { rows: Rows::Even(20), ..Settings::adaptive(Method::Dop853, 2.0, 1e-12) };
    let run = run_with(FourBarJoints::default(), &settings).unwrap();
    let joints = ["O2", "A", "B", "O4"].iter().flat_map(|joint| ["x", "y"].map(|axis| (*joint, axis)));
    let names: Vec<(String, String)> = joints
        .map(|(joint, axis)| {
            (format!("lambda_{joint}_{axis}"), format!("multiplier {joint}{axis} (M a + C^T lam = F)"))
        })
        .collect();
    let columns: Vec<_> = names.iter().map(|(name, quantity)| (name.as_str(), quantity.as_str(), 1.0)).collect();
    compare(&run, &reference("fourbar_free.json"), &columns);
}

mechanism! {
    /// The slider-crank of the models.
    SliderCrankJoints;
    parameters { r [m] = 0.15; l [m] = 0.45; offset [m] = 0.03; m1 [kg] = 1; m2 [kg] = 2; m3 [kg] = 1.5; g [m/s^2] = 9.81; }
    bodies {
        crank: free, mass m1, inertia m1*r^2/12;
        rod: free, mass m2, inertia m2*l^2/12;
        piston: free, mass m3, inertia 1 [kg*m^2];
    }
    loads { gravity [0, -g]; }
    joints {
        O: pin on(crank, [-r/2, 0]) to [0, 0];
        A: pin on(rod, [-l/2, 0]) to on(crank, [r/2, 0]);
        C: pin on(piston, [0, 0]) to on(rod, [l/2, 0]);
        guide: slide piston through [0, offset] along 0;
    }
    initial {
        crank_phi = 0; dot(crank_phi) = 20; guess rod_phi = 0.07; guess crank_x = 0.075; guess rod_x = 0.37; guess piston_x = 0.6;
    }
    outputs { wall_force [N] = -reaction(guide); turning [N*m] = reaction(guide_turn); }
}

/// The wall turns nothing, as the rod acts on the piston's centre.
#[test]
fn a_slider_crank_of_bodies_and_joints() {
    let settings = Settings { rows: Rows::Even(100), ..Settings::adaptive(Method::Dop853, 1.0, 1e-12) };
    let run = run_with(SliderCrankJoints::default(), &settings).unwrap();
    let columns = [
        ("crank_phi", "theta", 1.0),
        ("rod_phi", "phi", 1.0),
        ("piston_x", "x", 1.0),
        ("wall_force", "wall force on the piston, +y", 1.0),
    ];
    compare(&run, &reference("slider_crank_free.json"), &columns);
    let largest = column(&run, "turning").iter().fold(0.0f64, |largest, moment| largest.max(moment.abs()));
    assert!(largest < 1e-9, "{largest:e}");
}

fn column<M: Mechanism>(run: &Run<M>, name: &str) -> Vec<f64> {
    assert_eq!(run.trajectory.failure, None);
    Table::of(&run.mechanism, &run.trajectory).column(name).unwrap().values.clone()
}

/// A column is `expected` at each sample, to 1e-10 of the largest: some times the tolerance of the integration.
fn check<M: Mechanism>(run: &Run<M>, name: &str, expected: impl Fn(usize) -> f64) {
    let values = column(run, name);
    let largest = values.iter().fold(0.0f64, |largest, value| largest.max(value.abs()));
    for (i, value) in values.iter().enumerate() {
        assert!((value - expected(i)).abs() <= 1e-10 * largest, "{name}: {value} instead of {}", expected(i));
    }
}

fn settings(end: f64) -> Settings {
    Settings::adaptive(Method::Dop853, end, 1e-12)
}

mechanism! {
    /// A motor with a gear that drives a pinion on whose shaft another moves a rack.
    Drive;
    coordinates { a [rad]; b [rad]; s [m]; }
    parameters { J1 [kg*m^2] = 0.02; J2 [kg*m^2] = 0.3; m [kg] = 4; r1 [m] = 0.05; r2 [m] = 0.2; r [m] = 0.08; T [N*m] = 2; }
    bodies { motor: inertia J1, angle a; shaft: inertia J2, angle b; rod: mass m at s*[cos(0.4), sin(0.4)]; }
    loads { torque T on motor; }
    joints {
        mesh: gear motor radius r1 to shaft radius r2;
        teeth: rack s*[cos(0.4), sin(0.4)] through [0, 0] along 0.4 on shaft radius r;
    }
    outputs { tooth_force [N] = reaction(mesh); push [N] = reaction(teeth); }
}

/// T = (J1 + (J2 + m r^2) (r1/r2)^2) a'', the wheels turn against each other, and the rack moves by r b.
#[test]
fn gears_and_a_rack_drive_evenly() {
    let run = run_with(Drive::default(), &settings(2.0)).unwrap();
    let times = column(&run, "t");
    let ratio = 0.05 / 0.2;
    let acceleration = 2.0 / (0.02 + (0.3 + 4.0 * 0.08 * 0.08) * ratio * ratio);
    check(&run, "a", |i| acceleration * times[i] * times[i] / 2.0);
    check(&run, "b", |i| -ratio * acceleration * times[i] * times[i] / 2.0);
    check(&run, "s", |i| -0.08 * ratio * acceleration * times[i] * times[i] / 2.0);
    check(&run, "tooth_force", |_| (2.0 - 0.02 * acceleration) / 0.05);
    check(&run, "push", |_| 4.0 * 0.08 * ratio * acceleration);
}

mechanism! {
    /// A uniform disc that rolls down a slope.
    Wheel;
    parameters { m [kg] = 3; r [m] = 0.2; down [rad] = -0.2; g [m/s^2] = 9.81; }
    bodies { disc: free, mass m, inertia m*r^2/2; }
    loads { gravity [0, -g]; }
    joints {
        ground: slot on(disc, [0, 0]) through r*[-sin(down), cos(down)] along down;
        contact: roll disc radius r along down;
    }
    initial { disc_x = -r*sin(down); guess disc_y = 0.2; disc_phi = 0; }
    outputs { way [m] = inner(on(disc, [0, 0]), [cos(down), sin(down)]); grip [N] = reaction(contact); load [N] = reaction(ground); }
}

/// Two thirds of g sin(slope); a third of the weight's part along the slope is taken by the ground, which is pushed downhill.
#[test]
fn a_disc_rolls_down_a_slope() {
    let run = run_with(Wheel::default(), &settings(2.0)).unwrap();
    let times = column(&run, "t");
    let g = 9.81 * 0.2f64.sin();
    check(&run, "way", |i| g / 3.0 * times[i] * times[i]);
    check(&run, "disc_phi", |i| -g / 3.0 * times[i] * times[i] / 0.2);
    check(&run, "grip", |_| 3.0 * g / 3.0);
    check(&run, "load", |_| -3.0 * 9.81 * 0.2f64.cos());
}

mechanism! {
    /// A Scotch yoke that coasts.
    Yoke;
    coordinates { phi [rad]; x [m]; }
    parameters { J [kg*m^2] = 0.05; m [kg] = 2; R [m] = 0.1; }
    bodies { crank: inertia J, angle phi; yoke: mass m at [x, 0]; }
    joints { slot: slot R*[cos(phi), sin(phi)] through [x, 0] along pi/2; }
    initial { phi = 0; dot(phi) = 5; guess x = 0.1; }
}

/// J phi'^2 + m (R sin(phi) phi')^2 is constant.
#[test]
fn a_scotch_yoke_coasts() {
    let run = run_with(Yoke::default(), &settings(3.0)).unwrap();
    let phi = column(&run, "phi");
    check(&run, "x", |i| 0.1 * phi[i].cos());
    check(&run, "phi_dot", |i| 5.0 * (0.05 / (0.05 + 2.0 * (0.1 * phi[i].sin()).powi(2))).sqrt());
}

mechanism! {
    /// A mass on a link without mass.
    Linked;
    coordinates { x [m]; y [m]; }
    parameters { l [m] = 0.8; m [kg] = 0.5; g [m/s^2] = 9.81; }
    bodies { bob: mass m at [x, y]; }
    loads { gravity [0, -g]; }
    joints { rod: link [x, y] to [0, 0], length l; }
    initial { x = 0.8; guess y = 0; }
    outputs { tension [N] = reaction(rod); }
}

/// Let go from the horizontal: v^2 = -2 g y, and the link pulls with m (v^2 - g y)/l = -3 m g y/l.
#[test]
fn a_link_pulls() {
    let run = run_with(Linked::default(), &settings(2.0)).unwrap();
    let y = column(&run, "y");
    check(&run, "tension", |i| -3.0 * 0.5 * 9.81 * y[i] / 0.8);
}
