//! A disc that rolls, against the closed form of steady rolling.

use crate::common::{apart, column};
use models::{RollingDisc, Rover};
use sim::{Method, Settings};
use tests::any_model::{interpreted, run_with};

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

/// A disc rolls on a plate that is pulled, or on a belt, as on them: a' = F/(M + m/3) of the plate, and a third of it of the disc.
#[test]
fn a_disc_rolls_on_a_plane_that_moves() {
    let text = |place: &str, pull: &str| {
        format!(
            "pub Plate; parameters {{ m [kg] = 1; r [m] = 0.3; M [kg] = 3; v [m/s] = 0.5; }} coordinates {{ s [m]; }}
             bodies {{ plate: mass M at [s, 0, 0]; disc: free, mass m, inertia [m*r^2/4, m*r^2/2, m*r^2/4]; }}
             joints {{ c: roll disc radius r axis [0, 1, 0] on {place} normal [0, 0, 1]; }}
             loads {{ gravity [0, 0, -9.81 [m/s^2]]; force {pull} on s; }}
             initial {{ s = 0; dot(s) = 0; dot(disc_x) = 0; guess disc_z = 0.3; }}
             outputs {{ plate [m/s^2] = ddot(s); disc [m/s^2] = ddot(disc_x); speed [m/s] = dot(disc_x); turning [rad/s] = omega(disc).y; }}"
        )
    };
    let ends = |place: &str, pull: &str| -> Vec<f64> {
        let settings = Settings::adaptive(Method::Dop853, 0.5, 1e-11);
        let run = tests::run_with(interpreted(&text(place, pull)).unwrap(), &settings).unwrap();
        let last = |name: &str| *column(&run, name).last().unwrap();
        ["plate", "disc", "speed", "turning"].map(last).to_vec()
    };
    let near = |found: &[f64], exact: [f64; 4]| {
        assert!(found.iter().zip(exact).all(|(a, b)| (a - b).abs() < 1e-8), "{found:?}, not {exact:?}");
    };
    // The plate is at 0.3 m/s then, and the disc at 0.1 m/s, which turns by the difference.
    near(&ends("[s, 0, 0]", "2 [N]"), [0.6, 0.2, 0.1, -0.2 / 0.3]);
    // On a belt the disc starts at rest and turns.
    near(&ends("[v*t, 0, 0]", "0 [N]"), [0.0, 0.0, 0.0, -0.5 / 0.3]);
}
