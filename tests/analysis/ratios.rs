//! Ratios of outputs to the drive.

use crate::sweeps::{driven, output};
use sim::{Compiled, Kinematics, mechanism};
use std::f64::consts::{PI, TAU};

mechanism! {
    /// A crank whose support is moved by time, directly and by a constraint, with a slider below its pin.
    Led;
    coordinates { p [rad]; s [m]; u [m]; }
    parameters { l [m] = 0.2; m [kg] = 1; F [N] = 0; }
    let O = [u + 0.05 [m]*sin(5 [rad/s]*t), 0];
    let B = O + l*[cos(p), sin(p)];
    bodies { bob: mass m at B; slider: mass m at [s, 0]; support: mass m at [u, 0]; }
    loads { gravity [0, -9.81 [m/s^2]]; force F on s; }
    constraints { below: B.x = s; led: u = 0.02 [m]*sin(3 [rad/s]*t + 0.3); }
    outputs { S [m] = s; shifted [m] = s + 0.1 [m]*sin(9 [rad/s]*t); angle [rad] = p; waves [m] = 0.1 [m]*sin(9 [rad/s]*t); }
    initial { p = 0.5; guess s = 0.2; guess u = 0; }
}

/// dy/ds of an output at each sample.
fn ratios<M: Compiled>(found: &Kinematics<M>, name: &str) -> Vec<f64> {
    let place = M::DESCRIPTION.rated_outputs.iter().position(|rated| *rated == output::<M>(name)).unwrap();
    found.ratios.iter().map(|ratios| ratios[place]).collect()
}

/// By virtual work a force on the slider changes the drive's torque by it times ds/dp = -l sin(p), however fast the support moves.
#[test]
fn ratios_are_those_of_virtual_work() {
    let [free, loaded] =
        [0.0, 1000.0].map(|force| driven(Led { F: force, ..Led::default() }, "p", [0.5, 1.9], 1.5, 40));
    let ([slider, shifted], waves) = (["S", "shifted"].map(|name| ratios(&loaded, name)), ratios(&loaded, "waves"));
    for (k, p) in loaded.values.iter().enumerate() {
        let torque = loaded.forces[0][k] - free.forces[0][k];
        // Rounding of 200 N*m.
        assert!((torque + 1000.0 * slider[k]).abs() < 1e-11, "{k}: {torque} {}", slider[k]);
        assert!((slider[k] + 0.2 * p.sin()).abs() < 1e-14 && (shifted[k] - slider[k]).abs() < 1e-14, "{k}");
        assert!(waves[k].abs() < 1e-15, "{k}: {}", waves[k]);
    }
    let peak = loaded.extremes.ratios[output::<Led>("S")].unwrap().peak();
    assert!((peak.value + 0.2).abs() < 1e-14 && (peak.at - PI / 2.0).abs() < 1e-6, "{peak:?}");
    // The other way round, and where what is driven depends on time itself.
    for name in ["S", "shifted"] {
        let found = driven(Led::default(), name, [0.17, 0.08], 0.2, 20);
        for (sample, ratio) in found.trajectory.samples.iter().zip(ratios(&found, "angle")) {
            let expected = -1.0 / (0.2 * sample.state.positions[0].sin());
            assert!((ratio - expected).abs() < 1e-12, "{name}: {ratio} {expected}");
        }
    }
}

/// The extremes of the slider are where it stands still in space, with what time moves.
#[test]
fn extremes_are_those_of_the_whole_motion() {
    let found = driven(Led::default(), "p", [0.5, 0.5 + TAU], 4.0, 40);
    let range = found.extremes.outputs[output::<Led>("S")].unwrap();
    for extreme in [range.least, range.greatest] {
        let (p, t) = (extreme.at, (extreme.at - 0.5) / 4.0);
        let place = 0.2 * p.cos() + 0.05 * (5.0 * t).sin() + 0.02 * (3.0 * t + 0.3).sin();
        let speed = -0.8 * p.sin() + 0.25 * (5.0 * t).cos() + 0.06 * (3.0 * t + 0.3).cos();
        assert!((extreme.value - place).abs() < 1e-15 && speed.abs() < 1e-13, "{extreme:?} {speed}");
    }
}
