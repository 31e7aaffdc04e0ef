//! Forces conjugate to auxiliary displacements: the pins of a four-bar against the reference, cut and not cut, and closed
//! forms.

use crate::linkages::{compare, history};
use sim::{Method, Settings, Table, mechanism};
use tests::any_model::{run, run_with};
use tests::reference;

mechanism! {
    /// The four-bar of the models with an auxiliary displacement in each pin: in O2 of the crank from the ground, in A of the
    /// coupler from the crank, in B of the coupler's tip, in O4 of the rocker from the ground.
    FourBarPins;
    coordinates { theta2 [rad]; theta3 [rad]; theta4 [rad]; }
    parameters { a [m] = 0.2; b [m] = 0.6; c [m] = 0.5; d [m] = 0.6; m2 [kg] = 2; m3 [kg] = 4; m4 [kg] = 3; g [m/s^2] = 9.81; }
    auxiliary { o2x [m]; o2y [m]; ax [m]; ay [m]; bx [m]; by [m]; o4x [m]; o4y [m]; }
    let u2 = [cos(theta2), sin(theta2)];
    let u3 = [cos(theta3), sin(theta3)];
    let u4 = [cos(theta4), sin(theta4)];
    let O2 = [o2x, o2y];
    let O4 = [d, 0] + [o4x, o4y];
    let A = O2 + a*u2;
    let A3 = A + [ax, ay];
    let B = O4 + c*u4;
    bodies {
        crank2: mass m2 at O2 + a/2*u2, inertia m2*a^2/12, angle theta2;
        coupler3: mass m3 at A3 + b/2*u3, inertia m3*b^2/12, angle theta3;
        rocker4: mass m4 at O4 + c/2*u4, inertia m4*c^2/12, angle theta4;
    }
    loads { gravity [0, -g]; }
    constraints { closure: A3 + b*u3 + [bx, by] = B; }
    initial { theta2 = 0; dot(theta2) = 10; guess theta3 = 1; guess theta4 = 1.7; }
    outputs {
        O2x [N] = reaction(o2x); O2y [N] = reaction(o2y); Ax [N] = reaction(ax); Ay [N] = reaction(ay);
        Bx [N] = reaction(bx); By [N] = reaction(by); O4x [N] = reaction(o4x); O4y [N] = reaction(o4y);
    }
}

mechanism! {
    /// The same in absolute coordinates, each pin a constraint.
    FourBarBodies;
    coordinates { x2 [m]; y2 [m]; theta2 [rad]; x3 [m]; y3 [m]; theta3 [rad]; x4 [m]; y4 [m]; theta4 [rad]; }
    parameters { a [m] = 0.2; b [m] = 0.6; c [m] = 0.5; d [m] = 0.6; m2 [kg] = 2; m3 [kg] = 4; m4 [kg] = 3; g [m/s^2] = 9.81; }
    let G2 = [x2, y2];
    let G3 = [x3, y3];
    let G4 = [x4, y4];
    let u2 = [cos(theta2), sin(theta2)];
    let u3 = [cos(theta3), sin(theta3)];
    let u4 = [cos(theta4), sin(theta4)];
    bodies {
        crank2: mass m2 at G2, inertia m2*a^2/12, angle theta2;
        coupler3: mass m3 at G3, inertia m3*b^2/12, angle theta3;
        rocker4: mass m4 at G4, inertia m4*c^2/12, angle theta4;
    }
    loads { gravity [0, -g]; }
    constraints {
        O2: G2 - a/2*u2 = [0, 0];
        A: G3 - b/2*u3 = G2 + a/2*u2;
        B: G3 + b/2*u3 = G4 + c/2*u4;
        O4: G4 - c/2*u4 = [d, 0];
    }
    initial {
        theta2 = 0; dot(theta2) = 10; guess theta3 = 1; guess theta4 = 1.7;
        guess x2 = 0.1; guess x3 = 0.35; guess y3 = 0.25; guess x4 = 0.57; guess y4 = 0.25;
    }
}

const JOINTS: [&str; 8] = ["O2x", "O2y", "Ax", "Ay", "Bx", "By", "O4x", "O4y"];

fn multiplier(joint: &str) -> String {
    format!("multiplier {joint} (M a + C^T lam = F)")
}

/// The reference does not say which body comes first in A and B. Newton's law of the crank and of the coupler, of its own
/// numbers, does: m2 a2 = F2 - lambda_O2 + lambda_A, so A's constraint is coupler minus crank, and the coupler feels
/// -lambda_A and, as m3 a3 = F3 - lambda_A - lambda_B, B's constraint is coupler minus rocker.
#[test]
fn the_signs_of_the_reference_follow_from_newtons_law() {
    let reference = reference("fourbar_free.json");
    let of =
        |quantity: &str| -> Vec<f64> { history(&reference, quantity).into_iter().map(|(_, value)| value).collect() };
    let lambda = |joint: &str| of(&multiplier(joint));
    let arm = |length: f64, body: &str| -> Vec<f64> {
        let (theta, omega, alpha) =
            (of(&format!("theta{body}")), of(&format!("omega{body}")), of(&format!("alpha{body}")));
        (0..theta.len()).map(|i| -length * (omega[i].powi(2) * theta[i].cos() + alpha[i] * theta[i].sin())).collect()
    };
    let (crank, coupler) = (arm(0.2, "2"), arm(0.6, "3"));
    let (o2, a, b) = (lambda("O2x"), lambda("Ax"), lambda("Bx"));
    for i in 0..crank.len() {
        let of_crank = 2.0 * crank[i] / 2.0 - (a[i] - o2[i]);
        let of_coupler = 4.0 * (crank[i] + coupler[i] / 2.0) - (-a[i] - b[i]);
        // The reference has 18 digits; these sums are of numbers below 300.
        assert!(of_crank.abs() < 1e-10 && of_coupler.abs() < 1e-10, "{of_crank:e} {of_coupler:e}");
    }
}

/// Each displacement takes along what comes after its pin, so that its force is that on the crank, the coupler and the
/// rocker in O2, A and O4, which feel -lambda; the tip's is that on the piece between it and the rocker, lambda.
#[test]
fn the_pins_of_a_four_bar_by_auxiliary_displacements() {
    let run = run(FourBarPins::default(), 2.0, 20_000).unwrap();
    let signs = JOINTS.map(|joint| if joint.starts_with('B') { 1.0 } else { -1.0 });
    let quantities = JOINTS.map(multiplier);
    let columns: Vec<_> = (0..8).map(|i| (JOINTS[i], quantities[i].as_str(), signs[i])).collect();
    compare(&run, &reference("fourbar_free.json"), &columns);
}

#[test]
fn the_pins_of_a_four_bar_in_absolute_coordinates() {
    let settings = Settings { rows: sim::Rows::Even(20), ..Settings::adaptive(Method::Dop853, 2.0, 1e-12) };
    let run = run_with(FourBarBodies::default(), &settings).unwrap();
    let (names, quantities) = (
        JOINTS.map(|joint| format!("lambda_{}_{}", &joint[..joint.len() - 1], &joint[joint.len() - 1..])),
        JOINTS.map(multiplier),
    );
    let columns: Vec<_> = (0..8).map(|i| (names[i].as_str(), quantities[i].as_str(), 1.0)).collect();
    compare(&run, &reference("fourbar_free.json"), &columns);
}

mechanism! {
    /// A cart that is pushed, with a mast clamped on it that carries a mass and a sail.
    Mast;
    coordinates { x [m]; }
    parameters { M [kg] = 3; m [kg] = 0.5; l [m] = 1.2; push [N/s] = 7; wind [N] = 2; g [m/s^2] = 9.81; }
    auxiliary { lean [rad]; lift [mm]; }
    let tip = [x, lift] + l*[sin(lean), cos(lean)];
    bodies { cart: mass M at [x, 0]; top: mass m at tip; }
    loads { gravity [0, -g]; force [push*t, 0] at [x, 0]; force [-wind, 0] at tip; }
    outputs { moment [N*m] = reaction(lean); support [N] = reaction(lift); }
}

/// The clamp turns the mast towards +x with l (m x'' + wind), and carries m g.
#[test]
fn a_clamp_has_a_moment() {
    let run = run_with(Mast::default(), &Settings::adaptive(Method::Dopri5, 1.0, 1e-9)).unwrap();
    let table = Table::of(&run.mechanism, &run.trajectory);
    let [moment, support] = ["moment", "support"].map(|name| &table.column(name).unwrap().values);
    for ((t, moment), support) in table.times().iter().zip(moment).zip(support) {
        let acceleration = (7.0 * t - 2.0) / 3.5;
        let expected = 1.2 * (0.5 * acceleration + 2.0);
        // Rounding of a few operations.
        assert!((moment - expected).abs() < 1e-13 && (support - 0.5 * 9.81).abs() < 1e-13, "{moment} {support}");
    }
}
