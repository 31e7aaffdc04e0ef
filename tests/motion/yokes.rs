//! Scotch yoke, Whitworth's quick return and the spring-loaded follower in closed form.

use models::{ScotchYoke, SpringFollower, Whitworth};
use sim::{Compiled, Mechanism, Method, Run, Settings, Table};
use std::f64::consts::{PI, TAU};
use tests::any_model::{AnyModel, run_with};

/// Relative to the largest of a column. Steps of a thousandth of a period and less leave DOP853 with (h w)^8 = 1e-17.
const TOLERANCE: f64 = 1e-9;

fn precise<M: Compiled>(mechanism: M, end: f64) -> Run<AnyModel> {
    let run = run_with(mechanism, &Settings::equal_steps(Method::Dop853, end, 4000)).unwrap();
    assert_eq!(run.trajectory.failure, None);
    run
}

/// Every row of a column is what a function of the time and the row's first coordinate says.
fn compare<M: Mechanism>(run: &Run<M>, column: &str, exact: impl Fn(f64, f64) -> f64) {
    let table = Table::of(&run.mechanism, &run.trajectory);
    let values = &table.column(column).unwrap().values;
    let largest = values.iter().fold(0.0f64, |largest, value| largest.max(value.abs()));
    let mut worst = 0.0f64;
    for (value, sample) in values.iter().zip(&run.trajectory.samples) {
        worst = worst.max((value - exact(sample.state.time, sample.state.positions[0])).abs() / largest);
    }
    println!("{:<16} {column:<16} {worst:.1e}", run.mechanism.description().name);
    assert!(worst < TOLERANCE, "{column}: {worst:e}");
}

/// Gauss's arithmetic-geometric mean with the sum that gives E(m)/K(m) (Abramowitz and Stegun, 17.6.3 and 17.6.4).
fn complete_elliptic_e(m: f64) -> f64 {
    let (mut a, mut b, mut c) = (1.0, (1.0 - m).sqrt(), m.abs().sqrt());
    // c_0^2 = m, which may be negative.
    let (mut sum, mut power) = (m / 2.0, 0.5);
    while c.abs() > 1e-16 {
        (a, b, c) = ((a + b) / 2.0, f64::sqrt(a * b), (a - b) / 2.0);
        power *= 2.0;
        sum += power * c * c;
    }
    PI / (2.0 * a) * (1.0 - sum)
}

/// (J + m r^2 sin^2 alpha) alpha'^2 is constant, so the period is 4 E(-m r^2/J)/w0; the slot feels m x''.
#[test]
fn a_scotch_yoke_turns_freely() {
    let yoke: ScotchYoke = ScotchYoke::default();
    let run = precise(yoke, 1.0);
    let w0 = 120.0 * TAU / 60.0;
    let k = yoke.m * yoke.r * yoke.r / yoke.J;
    let speed = |a: f64| w0 / (1.0 + k * a.sin().powi(2)).sqrt();
    // alpha'' = d(alpha'^2/2)/d alpha
    let acceleration = |a: f64| -w0 * w0 * k * a.sin() * a.cos() / (1.0 + k * a.sin().powi(2)).powi(2);
    let x_acceleration = |a: f64| -yoke.r * (acceleration(a) * a.sin() + speed(a).powi(2) * a.cos());
    compare(&run, "alpha_dot", |_, a| speed(a));
    compare(&run, "x", |_, a| yoke.r * a.cos());
    compare(&run, "x_dot", |_, a| -yoke.r * a.sin() * speed(a));
    compare(&run, "force", |_, a| yoke.m * x_acceleration(a));
    let period = 4.0 * complete_elliptic_e(-k) / w0;
    assert!((run.period().unwrap() - period).abs() < 1e-10, "{:?} {period}", run.period());
}

/// Positions by trigonometry at alpha = w t, rates by differences of these; stroke and return by the angle between the
/// dead points, at which the slotted link lies along the guide.
#[test]
fn whitworth_by_trigonometry() {
    let w: Whitworth = Whitworth::default();
    let speed = TAU;
    let run = precise(w, 2.0);
    let beta = |t: f64| {
        let a = speed * t;
        let turns = (a / TAU).round();
        (w.r * (a - turns * TAU).sin()).atan2(w.d + w.r * (a - turns * TAU).cos()) + turns * TAU
    };
    let ram = |t: f64| {
        let (bx, by) = (w.c * beta(t).sin(), -w.c * beta(t).cos());
        bx + (w.l * w.l - by * by).sqrt()
    };
    compare(&run, "alpha", |t, _| speed * t);
    compare(&run, "beta", |t, _| beta(t));
    compare(&run, "x", |t, _| 1e3 * ram(t));
    compare(&run, "beta_dot", |t, _| derivative(&beta, t));
    compare(&run, "v", |t, _| derivative(&ram, t));
    // T w = d/dt of the kinetic energy, which is that of link, ram and rod.
    let energy = |t: f64| {
        let rod_angle = |t: f64| (w.c * beta(t).cos() / w.l).asin();
        let middle = |t: f64| (w.c * beta(t).sin() + w.l / 2.0 * rod_angle(t).cos(), -w.c * beta(t).cos() / 2.0);
        let speed_squared = derivative(&|t| middle(t).0, t).powi(2) + derivative(&|t| middle(t).1, t).powi(2);
        let turning = w.J4 * derivative(&beta, t).powi(2) + w.m5 * w.l * w.l / 12.0 * derivative(&rod_angle, t).powi(2);
        0.5 * (turning + w.m5 * speed_squared + w.m6 * derivative(&ram, t).powi(2))
    };
    let table = Table::of(&run.mechanism, &run.trajectory);
    let torques = &table.column("T").unwrap().values;
    let largest = torques.iter().fold(0.0f64, |largest, value| largest.max(value.abs()));
    for (time, torque) in table.times().iter().zip(torques).step_by(50) {
        // Differences of differences: steps of 1e-3 s leave 1e-16/1e-6 of roundings and (1e-3 w)^8.
        let error = (torque - derivative(&energy, *time) / speed).abs() / largest;
        assert!(error < 1e-7, "{time}: {error:e}");
    }
    // With both pivots above each other and the guide through the lower one, the dead points are at beta = +-90 deg.
    let dead: Vec<f64> = run.events.iter().filter(|e| e.name == "dead_point").map(|e| e.state.time).collect();
    let ratio = (dead[1] - dead[0]) / (dead[2] - dead[1]);
    let half = (w.d / w.r).acos();
    let expected = (PI - half) / half;
    assert!((ratio - expected).abs() < 1e-9 || (ratio - 1.0 / expected).abs() < 1e-9, "{ratio} {expected}");
}

/// Central differences of order 8.
fn derivative(f: &dyn Fn(f64) -> f64, t: f64) -> f64 {
    let h = 2e-3;
    let pair = |i: f64| f(t + i * h) - f(t - i * h);
    (pair(1.0) * 4.0 / 5.0 - pair(2.0) / 5.0 + pair(3.0) * 4.0 / 105.0 - pair(4.0) / 280.0) / h
}

/// m y'' + c y' + k y = k (l0 + s) + c s' - m g with s = r sin w t: a decaying and a steady oscillation.
#[test]
fn a_follower_on_a_spring_above_a_crank() {
    let f: SpringFollower = SpringFollower::default();
    let run = precise(f, 1.5);
    let (w, m, k, c) = (f.w, f.m, f.k, f.c);
    // Steady part: Im(Y e^(iwt)) with Y = r (k + i c w)/(k - m w^2 + i c w).
    let (nr, ni, dr, di) = (k, c * w, k - m * w * w, c * w);
    let size = f.r / (dr * dr + di * di);
    let (yr, yi) = (size * (nr * dr + ni * di), size * (ni * dr - nr * di));
    let rest = f.l0 - m * f.g / k;
    let steady = |t: f64| rest + yr * (w * t).sin() + yi * (w * t).cos();
    let steady_rate = |t: f64| w * (yr * (w * t).cos() - yi * (w * t).sin());
    let decay = c / (2.0 * m);
    let wd = (k / m - decay * decay).sqrt();
    let (a, b) = (f.l0 - steady(0.0), (-steady_rate(0.0) + decay * (f.l0 - steady(0.0))) / wd);
    let free = |t: f64| (-decay * t).exp() * (a * (wd * t).cos() + b * (wd * t).sin());
    let free_rate =
        |t: f64| (-decay * t).exp() * ((b * wd - decay * a) * (wd * t).cos() - (a * wd + decay * b) * (wd * t).sin());
    compare(&run, "y", |t, _| steady(t) + free(t));
    compare(&run, "y_dot", |t, _| steady_rate(t) + free_rate(t));
    compare(&run, "spring_force", |t, y| k * (f.l0 - y + f.r * (w * t).sin()));
}
