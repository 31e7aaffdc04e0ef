//! The six-bar linkage by complex numbers: each loop is closed by intersecting two circles.

use models::SixBar;
use sim::{Method, Settings, Table};
use std::f64::consts::TAU;
use std::ops::{Add, Mul, Sub};
use tests::any_model::run_with;

/// A point of the plane.
#[derive(Clone, Copy)]
struct Complex(f64, f64);

impl Add for Complex {
    type Output = Complex;
    fn add(self, b: Complex) -> Complex {
        Complex(self.0 + b.0, self.1 + b.1)
    }
}

impl Sub for Complex {
    type Output = Complex;
    fn sub(self, b: Complex) -> Complex {
        Complex(self.0 - b.0, self.1 - b.1)
    }
}

impl Mul for Complex {
    type Output = Complex;
    fn mul(self, b: Complex) -> Complex {
        Complex(self.0 * b.0 - self.1 * b.1, self.0 * b.1 + self.1 * b.0)
    }
}

fn polar(length: f64, angle: f64) -> Complex {
    Complex(length * angle.cos(), length * angle.sin())
}

/// Angles of two links of lengths b and c from P and from Q, joined on the given side of the line from P to Q.
fn join(p: Complex, b: f64, q: Complex, c: f64, side: f64) -> [f64; 2] {
    let line = q - p;
    let length = line.0.hypot(line.1);
    let cosine = (b * b + length * length - c * c) / (2.0 * b * length);
    let unit = Complex(line.0 / length, line.1 / length);
    let first = unit * Complex(cosine, side * (1.0 - cosine * cosine).sqrt());
    let joint = p + Complex(b, 0.0) * first;
    let second = joint - q;
    [first.1.atan2(first.0), second.1.atan2(second.0)]
}

/// theta3 to theta6 at an angle of the crank.
fn angles(m: &SixBar, theta2: f64) -> [f64; 4] {
    let a = polar(m.a, theta2);
    let [theta3, theta4] = join(a, m.b, Complex(m.d, 0.0), m.c, 1.0);
    let p = a + polar(m.p, theta3 + m.delta);
    let [theta5, theta6] = join(p, m.f, Complex(m.O6x, m.O6y), m.h, 1.0);
    // Rocker 6 swings about pi, where an angle between -pi and pi would jump.
    [theta3, theta4, theta5, theta6.rem_euclid(TAU)]
}

/// Central differences of order 8, in the angle of the crank.
fn derivative<const N: usize>(f: &dyn Fn(f64) -> [f64; N], x: f64) -> [f64; N] {
    let h = 1e-2;
    let weights = [4.0 / 5.0, -1.0 / 5.0, 4.0 / 105.0, -1.0 / 280.0];
    std::array::from_fn(|i| {
        let pair = |k: usize| f(x + h * (k + 1) as f64)[i] - f(x - h * (k + 1) as f64)[i];
        weights.iter().enumerate().map(|(k, weight)| weight * pair(k)).sum::<f64>() / h
    })
}

/// Kinetic and potential energy at an angle of the crank that turns with speed w.
fn energy(m: &SixBar, theta2: f64, w: f64) -> f64 {
    let centres = |theta2: f64| -> [f64; 8] {
        let [t3, t4, t5, t6] = angles(m, theta2);
        let a = polar(m.a, theta2);
        let p = a + polar(m.p, t3 + m.delta);
        let coupler = Complex(1.0 / 3.0, 0.0) * (a + a + polar(m.b, t3) + p);
        let rocker4 = Complex(m.d, 0.0) + polar(m.c / 2.0, t4);
        let link5 = p + polar(m.f / 2.0, t5);
        let rocker6 = Complex(m.O6x, m.O6y) + polar(m.h / 2.0, t6);
        [coupler.0, coupler.1, rocker4.0, rocker4.1, link5.0, link5.1, rocker6.0, rocker6.1]
    };
    let masses = [m.m3, m.m4, m.m5, m.m6];
    let inertias = [m.J3, m.m4 * m.c.powi(2) / 12.0, m.m5 * m.f.powi(2) / 12.0, m.m6 * m.h.powi(2) / 12.0];
    let (at, rates, turns) =
        (centres(theta2), derivative(&centres, theta2), derivative(&|theta| angles(m, theta), theta2));
    (0..4)
        .map(|i| {
            let speed_squared = rates[2 * i].powi(2) + rates[2 * i + 1].powi(2);
            let kinetic = 0.5 * w * w * (masses[i] * speed_squared + inertias[i] * turns[i].powi(2));
            kinetic + masses[i] * m.g * at[2 * i + 1]
        })
        .sum()
}

/// Positions to 1e-10; speeds by differences of order 8, which leave 1e-10; the torque of the crank is the rate of the
/// energy, by differences of differences.
#[test]
fn loops_close_as_complex_numbers_say() {
    let six_bar: SixBar = SixBar::default();
    let w = TAU;
    let run = run_with(six_bar, &Settings::equal_steps(Method::Dop853, 2.0, 2000)).unwrap();
    assert_eq!(run.trajectory.failure, None);
    assert!((run.period().unwrap() - 1.0).abs() < 1e-11);
    let table = Table::of(&run.mechanism, &run.trajectory);
    let torque = &table.column("T").unwrap().values;
    let largest = torque.iter().fold(0.0f64, |largest, value| largest.max(value.abs()));
    let (mut position, mut speed, mut power) = (0.0f64, 0.0f64, 0.0f64);
    for (i, sample) in run.trajectory.samples.iter().enumerate() {
        let theta2 = w * sample.state.time;
        assert!((sample.state.positions[0] - theta2).abs() < 1e-11);
        let exact = angles(&six_bar, theta2);
        let rates = derivative(&|theta| angles(&six_bar, theta), theta2);
        for k in 0..4 {
            let turns = (sample.state.positions[k + 1] - exact[k]) / TAU;
            position = position.max((turns - turns.round()).abs() * TAU);
            speed = speed.max((sample.state.speeds[k + 1] - w * rates[k]).abs());
        }
        let [expected] = derivative(&|theta| [energy(&six_bar, theta, w)], theta2);
        power = power.max((torque[i] - expected).abs() / largest);
    }
    println!("positions {position:.1e}, speeds {speed:.1e}, torque {power:.1e}");
    assert!(position < 1e-10 && speed < 1e-8 && power < 1e-8);
}
