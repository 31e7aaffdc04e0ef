//! What a drive exerts, against energy and against the motion under that torque.

use crate::sweeps::driven;
use models::{FourBar, QuickReturn, SliderCrank};
use sim::{Compiled, Driven, accelerate, assemble, declared_start, inverse_dynamics};
use std::f64::consts::{PI, TAU};

/// The derivative of a function, by central differences of order 6 (Fornberg, 1988).
fn derivative(f: impl Fn(f64) -> f64, x: f64) -> f64 {
    let h = 1e-2;
    let pair = |k: f64| f(x + k * h) - f(x - k * h);
    (45.0 * pair(1.0) - 9.0 * pair(2.0) + pair(3.0)) / (60.0 * h)
}

/// Kinetic and potential energy of the slider-crank at 20 rad/s, from its geometry alone.
fn energy_of_slider_crank(theta: f64) -> f64 {
    let (r, l, e, omega, g) = (0.15, 0.45, 0.03, 20.0, 9.81);
    let phi = ((e - r * theta.sin()) / l).asin();
    let turning = -r * theta.cos() * omega / (l * phi.cos());
    let crank = [-r * theta.sin() * omega, r * theta.cos() * omega];
    let centre = [crank[0] - l / 2.0 * phi.sin() * turning, crank[1] + l / 2.0 * phi.cos() * turning];
    let piston = crank[0] - l * phi.sin() * turning;
    let kinetic = (1.0 * r * r / 3.0) * omega * omega / 2.0
        + 0.5 * 2.0 * (centre[0] * centre[0] + centre[1] * centre[1])
        + 2.0 * l * l / 12.0 * turning * turning / 2.0
        + 1.5 / 2.0 * piston * piston;
    let height = 1.0 * r / 2.0 * theta.sin() + 2.0 * (r * theta.sin() + l / 2.0 * phi.sin()) + 1.5 * e;
    kinetic + g * height
}

/// Torque times speed is the rate of the energy.
#[test]
fn the_torque_on_a_slider_crank_balances_its_energy() {
    let found = driven(SliderCrank::default(), "theta", [0.0, TAU], 20.0, 90);
    let largest = found.forces[0].iter().fold(0.0f64, |most, force| most.max(force.abs()));
    let mut worst = 0.0f64;
    for (value, force) in found.values.iter().zip(&found.forces[0]) {
        worst = worst.max((force - derivative(energy_of_slider_crank, *value)).abs() / largest);
    }
    println!("torque on the slider-crank: {worst:.1e}");
    // The sixth-order quotient at 1e-2 is good to about 1e-11 (140 h^6 / 7!) times the ratio of derivatives.
    assert!(worst < 1e-9, "{worst}");
}

/// Kinetic energy of quick-return at 75 rpm less the work of F, from its geometry alone.
fn energy_of_quick_return(alpha: f64) -> f64 {
    let omega = 2.5 * PI;
    let angles = |alpha: f64| {
        let beta = (0.3 + 0.2 * alpha.sin()).atan2(0.2 * alpha.cos());
        [beta, PI - ((0.9 - 0.7 * beta.sin()) / 0.6).asin()]
    };
    let [beta, gamma] = angles(alpha);
    let square = 0.04 + 0.09 + 0.12 * alpha.sin();
    let turning = omega * (0.04 + 0.06 * alpha.sin()) / square;
    let bar = -0.7 * beta.cos() * turning / (0.6 * gamma.cos());
    let tip = [-0.7 * beta.sin() * turning, 0.7 * beta.cos() * turning];
    let middle = [tip[0] - 0.3 * gamma.sin() * bar, tip[1] + 0.3 * gamma.cos() * bar];
    let slider = tip[0] - 0.6 * gamma.sin() * bar;
    let kinetic = 0.5 / 2.0 * 0.04 * omega * omega
        + 100.0 / 2.0 * omega * omega
        + (6.0 * 0.16 + 10.0) / 2.0 * turning * turning
        + 4.0 / 2.0 * (middle[0] * middle[0] + middle[1] * middle[1])
        + 6.0 / 2.0 * bar * bar
        + 0.5 * 2.0 * slider * slider;
    kinetic - 1000.0 * (0.7 * beta.cos() + 0.6 * gamma.cos())
}

#[test]
fn the_torque_on_crank_2_balances_the_energy_of_quick_return() {
    let found = driven(QuickReturn::default(), "alpha", [0.0, TAU], 2.5 * PI, 360);
    let largest = found.forces[0].iter().fold(0.0f64, |most, force| most.max(force.abs()));
    let mut worst = 0.0f64;
    for (value, force) in found.values.iter().zip(&found.forces[0]) {
        worst = worst.max((force - derivative(energy_of_quick_return, *value)).abs() / largest);
    }
    println!("torque on quick-return: {worst:.1e}");
    // As above; the return stroke is some ten times as fast as the crank, and derivatives of order 7 grow with that.
    assert!(worst < 1e-6, "{worst}");
    // Over a whole turn the work of the drive is none: the energy returns. The trapezoidal rule is exact for
    // periodic functions but for harmonics beyond the 360th.
    let mean = found.forces[0][1..].iter().sum::<f64>() / 360.0;
    assert!((mean / largest).abs() < 1e-12, "{mean}");
}

/// Under the torque that was found, as a load, the mechanism moves as it was driven.
fn moves_as_driven<M: Compiled>(mechanism: M, drive: &str, rate: f64, second: f64, with_torque: impl Fn(f64) -> M) {
    let state = assemble(&mechanism, &declared_start(&mechanism)).unwrap();
    let driven = Driven::find(&M::DESCRIPTION, drive).unwrap();
    let found = inverse_dynamics(&mechanism, 0.0, &state.positions, &[driven], &[rate], &[second]).unwrap();
    let sample = &found.sample;
    let freed = with_torque(found.forces[0]);
    let dynamics = accelerate(&freed, 0.0, &state.positions, &sample.state.speeds).unwrap();
    let pairs = sample.accelerations.as_ref().iter().zip(dynamics.accelerations.as_ref());
    for (a, b) in pairs.chain(sample.multipliers.as_ref().iter().zip(dynamics.multipliers.as_ref())) {
        assert!((a - b).abs() < 1e-10 * a.abs().max(1.0), "{a} {b}");
    }
    assert!((sample.power - dynamics.power).abs() < 1e-10 * sample.power.abs().max(1.0));
    let index = M::DESCRIPTION.coordinates.iter().position(|c| c.position.name == drive).unwrap();
    assert!((dynamics.accelerations[index] - second).abs() < 1e-10);
}

#[test]
fn forward_dynamics_under_the_torque_gives_the_prescribed_motion() {
    let fast = 7.0;
    moves_as_driven(FourBar::default(), "theta2", fast, 3.0, |torque| FourBar { T: torque, ..FourBar::default() });
    moves_as_driven(SliderCrank::default(), "theta", fast, -11.0, |torque| SliderCrank {
        T: torque,
        ..SliderCrank::default()
    });
    moves_as_driven(QuickReturn::default(), "alpha", fast, 0.5, |torque| QuickReturn {
        T: torque,
        ..QuickReturn::default()
    });
}
