//! Tops and pendulums in space against closed forms.

use models::Top;
use sim::{Mechanism, Method, Run, Settings, Table};
use tests::run_with;

fn column<M: Mechanism>(run: &Run<M>, name: &str) -> Vec<f64> {
    assert_eq!(run.trajectory.failure, None);
    Table::of(&run.mechanism, &run.trajectory).column(name).unwrap().values.clone()
}

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
    let top = Top::default();
    let [slow, _] = steady(&top);
    let run = run_with(top, &Settings::adaptive(Method::Dop853, 10.0, 1e-13)).unwrap();
    let (times, psi) = (column(&run, "t"), column(&run, "psi"));
    let worst = times.iter().zip(&psi).skip(1).map(|(t, psi)| (psi / (slow * t) - 1.0).abs()).fold(0.0, f64::max);
    let nutation = column(&run, "nutation");
    let nods = nutation.iter().map(|theta| (theta - 30.0).abs()).fold(0.0, f64::max);
    println!("top: rate of precession {slow:.12} rad/s, off by {worst:.1e}; nutation stays to {nods:.1e} deg");
    assert!(worst < 1e-10 && nods < 1e-8, "{worst:e} {nods:e}");
}
