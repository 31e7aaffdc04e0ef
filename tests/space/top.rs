//! Tops and pendulums in space against closed forms.

use crate::common::{apart, column};
use crate::elliptic::jacobi;
use models::{SphericalPendulum, Top};
use sim::{Method, Settings};
use tests::any_model::run_with;

/// The roots of A cos(theta) p^2 - C w p + m g l = 0, slow and fast.
fn steady(top: &Top) -> [f64; 2] {
    let a = (top.A + top.m * top.l * top.l) * top.theta0.cos();
    let (b, c) = (top.C * top.spin, top.m * top.g * top.l);
    let root = (b * b - 4.0 * a * c).sqrt();
    // The small root from the large one, without cancellation.
    let fast = (b + root) / (2.0 * a);
    [c / (a * fast), fast]
}

#[test]
fn a_top_precesses_steadily() {
    let top = Top { nod: 0.0, ..Top::default() };
    let [slow, _] = steady(&top);
    let run = run_with(top, &Settings::adaptive(Method::Dop853, 10.0, 1e-13)).unwrap();
    let (times, psi) = (column(&run, "t"), column(&run, "psi"));
    let worst = times.iter().zip(&psi).skip(1).map(|(t, psi)| (psi / (slow * t) - 1.0).abs()).fold(0.0, f64::max);
    let nutation = column(&run, "nutation");
    let nods = nutation.iter().map(|theta| (theta - 30.0).abs()).fold(0.0, f64::max);
    println!("top: rate of precession {slow:.12} rad/s, off by {worst:.1e}; nutation stays to {nods:.1e} deg");
    assert!(worst < 1e-10 && nods < 1e-8, "{worst:e} {nods:e}");
}

/// A top that sleeps upright stands where its angles fail.
#[test]
fn gimbal_lock_is_explained() {
    let upright = Top { theta0: 0.0, nod: 0.0, ..Top::default() };
    let settings = Settings::adaptive(Method::Dop853, 1.0, 1e-10);
    let failure = match run_with(upright, &settings) {
        Ok(run) => run.trajectory.failure.unwrap(),
        Err(failure) => failure,
    };
    println!("{failure}");
    let text = failure.to_string();
    assert!(
        text.contains("gimbal lock: `psi` and `phi` turn about the same axis") && text.contains("quaternion"),
        "{text}"
    );
}

/// z = z1 + (z2 - z1) sn^2, from the lowest point.
#[test]
fn a_spherical_pendulum_follows_elliptic_functions() {
    let pendulum: SphericalPendulum = SphericalPendulum::default();
    let SphericalPendulum { l, g, theta0, turning, .. } = pendulum;
    let z1 = -l * theta0.cos();
    let h = l * l * theta0.sin().powi(2) * turning;
    let energy = z1 + (h / (l * theta0.sin())).powi(2) / (2.0 * g);
    // (E - z)(l^2 - z^2) - h^2/(2 g) over z - z1 is z^2 + p z + q.
    let p = z1 - energy;
    let q = -l * l + z1 * p;
    let root = (p * p - 4.0 * q).sqrt();
    let (z2, z3) = ((-p - root) / 2.0, (-p + root) / 2.0);
    assert!(z1 < z2 && z2 < z3);
    let (modulus, rate) = (((z2 - z1) / (z3 - z1)).sqrt(), (g * (z3 - z1) / (2.0 * l * l)).sqrt());
    let run = run_with(pendulum, &Settings::adaptive(Method::Dop853, 20.0, 1e-13)).unwrap();
    let off = apart(&run, "height", "t", |t| z1 + (z2 - z1) * jacobi(rate * t, modulus)[0].powi(2));
    let momentum = column(&run, "momentum");
    let drift = momentum.iter().map(|x| (x / momentum[0] - 1.0).abs()).fold(0.0, f64::max);
    println!("spherical pendulum: k = {modulus:.3}, height off by {off:.1e} m, angular momentum by {drift:.1e}");
    assert!(off < 1e-9 && drift < 1e-11, "{off:e} {drift:e}");
}

/// What parameters make of an inertia is looked at before a run.
#[test]
fn an_inertia_that_no_body_has_is_refused() {
    let settings = Settings::adaptive(Method::Dop853, 1.0, 1e-10);
    let flat: Top = Top { C: 7e-4, ..Top::default() };
    let failure = run_with(flat, &settings).unwrap_err().to_string();
    println!("{failure}");
    assert!(failure.contains("the inertia of body `top` is impossible with these parameters"), "{failure}");
    assert!(
        failure.contains("a principal moment is at most the sum of the other two: 0.0007 is more than 0.0003 + 0.0003")
    );
    let negative = run_with(Top { A: -1e-4, C: -1e-5, ..Top::default() }, &settings).unwrap_err().to_string();
    assert!(
        negative.contains("must not be negative") || negative.contains("about some axis this inertia is negative"),
        "{negative}"
    );
}
