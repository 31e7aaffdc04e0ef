//! A disc that rolls, against the closed form of steady rolling.

use crate::common::apart;
use models::{RollingDisc, Rover};
use sim::{Method, Settings};
use tests::any_model::run_with;

#[test]
fn a_leaning_disc_rolls_in_a_circle() {
    let disc: RollingDisc = RollingDisc { nod: 0.0, ..Default::default() };
    let RollingDisc { m, r, g, lean0, turning, .. } = disc;
    let (a, c) = (m * r * r / 4.0, m * r * r / 2.0);
    let (sine, cosine) = lean0.sin_cos();
    let axial = (a * turning * turning * sine * cosine - m * g * r * sine) / ((c + m * r * r) * turning * cosine);
    let speed = r * axial;
    let run = run_with(disc, &Settings::adaptive(Method::Dop853, 10.0, 1e-12)).unwrap();
    let worst = [
        apart(&run, "lean", "t", |_| lean0),
        apart(&run, "psi", "t", |t| turning * t),
        apart(&run, "x", "t", |t| speed / turning * (turning * t).sin()),
        apart(&run, "y", "t", |t| speed / turning * (1.0 - (turning * t).cos())),
        apart(&run, "z", "t", |_| r * cosine),
    ];
    let weight = apart(&run, "normal_force", "t", |_| m * g) / (m * g);
    println!(
        "rolling disc: lean, turn and place off by {worst:?}, weight by {weight:.1e}, energy {:.1e}",
        run.energy_balance
    );
    // Rolling slowly such a disc falls: disturbances grow as exp(t sqrt(..)), in ten seconds by some thousands.
    assert!(worst.iter().all(|x| *x < 1e-8) && run.energy_balance < 1e-10, "{worst:?}");
}

/// Torques of motors with friction bring the wheels to constant speeds; with both scaled masses the equations of sum and
/// difference of the wheels are linear, and their solutions exponentials.
#[test]
fn a_cart_on_two_wheels_does_not_slip() {
    let cart: Rover = Rover::default();
    let Rover { M, J, m, r, b, c, .. } = cart;
    let run = run_with(cart, &Settings::adaptive(Method::Dop853, 10.0, 1e-11)).unwrap();
    let wheel = m * r * r / 2.0;
    // s = s1 + s2: ((M + 2 m) r^2/4 + I/2) s' = (tau1 + tau2)/2 - c s/2; d = s2 - s1 likewise, about the vertical.
    let along = (M + 2.0 * m) * r * r / 2.0 + wheel;
    let about = (J + 2.0 * m * b * b + 2.0 * m * r * r / 4.0) * r * r / (2.0 * b * b) + wheel;
    let approach = |torque: f64, inertia: f64, t: f64| torque / c * (1.0 - (-c * t / inertia).exp());
    let speed = apart(&run, "speed", "t", |t| r * approach(0.5, along, t) / 2.0);
    let turning = apart(&run, "turning", "t", |t| r * approach(0.1, about, t) / (2.0 * b));
    println!("cart: speed off by {speed:.1e}, turning by {turning:.1e}, energy {:.1e}", run.energy_balance);
    assert!(speed < 1e-9 && turning < 1e-9 && run.energy_balance < 1e-9, "{speed:e} {turning:e}");
}
