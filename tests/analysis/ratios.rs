//! Ratios of outputs to the drive, and time ratios: what they are, and which outputs have none.

use crate::limits::Arm;
use crate::sweeps::{driven, output, sweep};
use models::SliderCrank;
use sim::{Compiled, Driven, Kinematics, Sweep, declared_start, kinematics, mechanism};
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
    assert_eq!(loaded.extremes.ratios[output::<Led>("waves")], None);
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

mechanism! {
    /// A four-bar linkage with outputs that do not move.
    Rigid;
    coordinates { a [rad]; b [rad]; c [rad]; }
    parameters { d [m] = 0.2; r [m] = 0.05; l [m] = 0.17; s [m] = 0.12; }
    let A = r*[cos(a), sin(a)];
    let B = A + l*[cos(b), sin(b)];
    let C = [d, 0] + s*[cos(c), sin(c)];
    bodies { crank: inertia 1 [kg*m^2], angle a; coupler: inertia 1 [kg*m^2], angle b; rocker: inertia 1 [kg*m^2], angle c; }
    constraints { loop: B = C; }
    initial { a = 0.6; guess b = 0.5; guess c = 1.5; }
    outputs { swing [rad] = c; length [m] = norm(B - A); gap [m] = B.x - C.x; }
}

/// A length that stays, and a difference that is zero, change by rounding: it has no ratios.
#[test]
fn rounding_has_no_ratios() {
    let found = driven(Rigid::default(), "a", [0.6, 0.6 + TAU], 1.0, 100).extremes;
    for name in ["length", "gap"] {
        let i = output::<Rigid>(name);
        assert!(found.outputs[i].unwrap().stroke() < 1e-15, "{name}");
        assert_eq!((found.ratios[i], found.time_ratios[i]), (None, None), "{name}");
    }
    // A stretched arm turns: the slope of its reach is nothing but rounding.
    let arm = Arm::default();
    let held = vec![(Driven::find(&<Arm as Compiled>::DESCRIPTION, "b").unwrap(), 0.0)];
    let turn = Sweep { held, ..sweep::<Arm>("a", [0.5, 0.5 + TAU], 1.0, 100) };
    let turned = kinematics(arm, &declared_start(&arm), &turn).unwrap().extremes;
    assert_eq!((turned.ratios[0], turned.time_ratios[0]), (None, None));
    let swing = output::<Rigid>("swing");
    assert!(found.ratios[swing].is_some() && found.time_ratios[swing].is_some());
}

/// Next to a dead centre the piston hardly moves, but not by rounding: dx/dtheta = -r (1 + r/l) theta.
#[test]
fn a_small_stroke_has_a_ratio() {
    let crank = SliderCrank { offset: 0.0, ..SliderCrank::default() };
    let sweep = sweep::<SliderCrank>("theta", [1e-6, 1e-5], 1.0, 4);
    let x = output::<SliderCrank>("x");
    let found = kinematics(crank, &declared_start(&crank), &sweep).unwrap().extremes;
    assert!(found.outputs[x].unwrap().stroke() < 1e-11);
    let ratio = found.ratios[x].unwrap().peak();
    assert!((ratio.value / (-0.15 * (1.0 + 0.15 / 0.45) * 1e-5) - 1.0).abs() < 1e-6, "{ratio:?}");
}

mechanism! {
    /// A scotch yoke on a spring, with a slide that is driven three times as fast.
    Yoke;
    coordinates { a [rad]; x [m]; }
    parameters { r [m] = 0.05; k [N/m] = 100; }
    bodies { crank: inertia 1 [kg*m^2], angle a; yoke: mass 1 [kg] at [x, 0]; }
    constraints { slot: x = r*cos(a); }
    initial { a = 0; guess x = 0.05; }
    outputs { place [m] = x; energy [J] = k*x^2/2; thrice [m] = r*sin(3*a); twice_low [m] = r*(cos(2*a) + cos(a)); }
}

/// What is as far out in two places of a turn has no one way there and back. The end of a turn is where it began.
#[test]
fn repeated_extremes_have_no_time_ratio() {
    for from in [0.0, 0.3, PI / 2.0, PI, -1.0] {
        let found = driven(Yoke::default(), "a", [from, from + TAU], 1.0, 36).extremes;
        let ratio = |name: &str| found.time_ratios[output::<Yoke>(name)];
        assert!((ratio("place").unwrap().ratio - 1.0).abs() < 1e-9, "{from}: {:?}", ratio("place"));
        assert_eq!(["energy", "thrice", "twice_low"].map(ratio), [None; 3], "{from}");
    }
}
