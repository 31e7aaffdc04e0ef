//! Least and greatest values of sweeps, whatever is recorded, against closed forms.

use crate::sweeps::{driven, output};
use models::{QuickReturn, SliderCrank};
use sim::{Compiled, mechanism};
use std::f64::consts::{PI, TAU};

/// One row or 720, a turn or three of them (318 in `figures -- numbers`): a quarter of what is asked for, 1e-9 of the range, where
/// the tolerance of the search is 1e-10 of it.
#[test]
fn extremes_do_not_depend_on_rows_or_turns() {
    for (what, value, bound) in tests::extremes::beside_a_turn([(TAU, 1), (TAU, 8), (TAU, 36), (20.0, 5)]) {
        println!("{what}: {value:.1e}");
        assert!(value <= bound / 4.0, "{what}: {value:e}");
    }
}

/// The difference between the speeds of crank pin and rocker has a corner where the rocker turns back: |v| of what stops. There
/// it is the speed of the pin, O2A omega.
#[test]
fn corners_are_found_between_rows() {
    for steps in [1, 7] {
        let found = driven(QuickReturn::default(), "alpha", [0.0, TAU], 2.5 * PI, steps);
        let greatest = found.extremes.outputs[output::<QuickReturn>("speed_difference")].unwrap().greatest;
        // A search by comparison narrows an interval of 1e-3 to 1e-11, and the corner is as steep as 10 m/s.
        assert!((greatest.value - 0.2 * 2.5 * PI).abs() < 1e-9, "{greatest:?}");
    }
}

/// Derivatives of w = sqrt(l^2 - u^2), u = r sin theta - e, by w^2 = l^2 - u^2: the piston is at r cos theta + w.
fn third_derivative(theta: f64) -> f64 {
    let (r, l, e) = (0.15, 0.45, 0.03);
    let (sin, cos) = theta.sin_cos();
    let [u, u1, u2, u3] = [r * sin - e, r * cos, -r * sin, -r * cos];
    let w = (l * l - u * u).sqrt();
    let w1 = -u * u1 / w;
    let w2 = (-u1 * u1 - u * u2 - w1 * w1) / w;
    let w3 = (-3.0 * u1 * u2 - u * u3 - 3.0 * w1 * w2) / w;
    r * sin + w3
}

/// The piston's acceleration is least and greatest where the third derivative of its position vanishes.
#[test]
fn places_of_peaks_of_accelerations() {
    let found = driven(SliderCrank::default(), "theta", [-1.0, TAU - 1.0], 20.0, 5);
    let range = found.extremes.outputs[output::<SliderCrank>("x_acceleration")].unwrap();
    for extreme in [range.least, range.greatest] {
        let [mut low, mut high] = [extreme.at - 0.01, extreme.at + 0.01];
        assert!(third_derivative(low) * third_derivative(high) < 0.0, "{extreme:?}");
        while high - low > 1e-15 {
            let middle = (low + high) / 2.0;
            if middle == low || middle == high {
                break;
            }
            *(if third_derivative(middle) * third_derivative(low) > 0.0 { &mut low } else { &mut high }) = middle;
        }
        println!("off by {:.1e}", extreme.at - low);
        // Rounding of the acceleration, 1e-16 of it, over its derivatives between the nodes of a polynomial.
        assert!((extreme.at - low).abs() < 1e-11, "{extreme:?} {low}");
    }
}

/// A turn may begin just before a peak or just after one: the last row is the first one again, and either may be the greater.
#[test]
fn peaks_beside_the_seam_of_a_turn_are_found() {
    let (r, l, e) = (0.15f64, 0.45f64, 0.03f64);
    let (outer, stretched) = ((e / (l + r)).asin(), ((l + r).powi(2) - e * e).sqrt());
    for away in [-0.02, -1e-3, -1e-7, 1e-7, 1e-3, 0.02] {
        for steps in [3, 8, 100] {
            let from = outer + away;
            let found = driven(SliderCrank::default(), "theta", [from, from + TAU], 20.0, steps);
            let greatest = found.extremes.outputs[output::<SliderCrank>("x")].unwrap().greatest;
            assert!((greatest.value - stretched).abs() < 1e-15, "{away} {steps}: {greatest:?}");
            let turns = (greatest.at - outer) / TAU;
            assert!((turns - turns.round()).abs() < 1e-14, "{away} {steps}: {greatest:?}");
        }
    }
}

/// The index of the slider-crank is |cos phi| over its greatest value, 1 where the rod lies along the rail, in whatever rows.
#[test]
fn the_transmission_index_is_that_of_the_whole_range() {
    for steps in [1, 3, 50] {
        let found = driven(SliderCrank::default(), "theta", [1.0, 1.0 + TAU], 20.0, steps);
        assert!((found.extremes.transmission.unwrap().greatest.value - 1.0).abs() < 1e-15);
        for (sample, index) in found.trajectory.samples.iter().zip(&found.transmission) {
            assert!((index - sample.state.positions[1].cos().abs()).abs() < 1e-13, "{index}");
        }
    }
}

mechanism! {
    /// A crank driven by a constraint, as one declares it for runs, and its slider.
    Prescribed;
    coordinates { theta [rad]; phi [rad]; }
    parameters { r [m] = 0.15; l [m] = 0.45; e0 [m] = 0.03; n [rad/s] = 20; g [m/s^2] = 9.81; }
    let A = r*[cos(theta), sin(theta)];
    let C = A + l*[cos(phi), sin(phi)];
    bodies {
        crank: mass 1 [kg] at A/2, inertia r^2/12 * 1 [kg], angle theta;
        rod: mass 2 [kg] at (A + C)/2, inertia l^2/6 * 1 [kg], angle phi;
        piston: mass 1.5 [kg] at C;
    }
    loads { gravity [0, -g]; }
    constraints { rail: C.y = e0; drive: 2*theta = 2*n*t; }
    initial { guess phi = 0.2; }
    outputs { torque [N*m] = -2*reaction(drive); }
}

/// A drive that is a constraint gives way to that of the sweep, and its reaction is what the drive exerts.
#[test]
fn a_drive_that_is_a_constraint_is_swept() {
    for speed in [20.0, 7.0] {
        let found = driven(Prescribed::default(), "theta", [0.3, 2.0], speed, 20);
        let crank = SliderCrank { offset: 0.03, ..SliderCrank::default() };
        let free = driven(crank, "theta", [0.3, 2.0], speed, 20);
        assert_eq!((&found.trajectory.failure, found.values.len()), (&None, 21));
        for (k, (sample, force)) in found.trajectory.samples.iter().zip(&found.forces[0]).enumerate() {
            assert!((sample.state.positions[0] - found.values[k]).abs() < 1e-15);
            assert!((force - free.forces[0][k]).abs() < 1e-11, "{force} {}", free.forces[0][k]);
            assert!((-2.0 * sample.multipliers[1] - force).abs() < 1e-12 && sample.power.is_finite());
        }
    }
    let declared = &<Prescribed as Compiled>::DESCRIPTION;
    assert_eq!(declared.constraints.len(), 2);
}

mechanism! {
    /// Outputs that are different from zero, or from a wave, in windows of some milliradians alone, and pulses as narrow.
    Windows;
    coordinates { phi [rad]; }
    parameters { J [kg*m^2] = 0.1; a = 2.345; w = 0.003; }
    bodies { wheel: inertia J, angle phi; }
    initial { phi = 0; dot(phi) = 6; }
    outputs {
        roof = max(0, 1 - abs(phi - a)/w);
        gate = sin(7*phi) + (if abs(phi - a) < w then 2 else 0);
        cap = sin(phi) + 3*max(0, 1 - ((phi - a)/w)^2);
        pulse = exp(-((phi - a)/w)^2);
        step = if dot(phi) > 1 [rad/s] then tanh((phi - a)/w) else 0;
    }
}

/// Their peaks are found whatever is recorded: between ten rows a window is a hundredth.
#[test]
fn peaks_in_narrow_windows_do_not_depend_on_rows() {
    let (a, w) = (2.345f64, 0.003);
    // Within the gate sin(7 phi) falls.
    let expected = [
        ("roof", 1.0),
        ("gate", 2.0 + (7.0 * (a - w)).sin().max((7.0 * (a + w)).sin())),
        ("cap", 3.0 + a.sin()),
        ("pulse", 1.0),
        ("step", 1.0),
    ];
    for steps in [1, 10, 720, 5000] {
        let found = driven(Windows::default(), "phi", [0.0, TAU], 6.0, steps);
        for (name, peak) in expected {
            let greatest = found.extremes.outputs[output::<Windows>(name)].unwrap().greatest;
            // The cap is steep beside sin(phi): it moves the peak by w^2 cos(a)/6, which is worth (w cos(a))^2/12, below 1e-6.
            let tolerance = if name == "cap" { 1e-6 } else { 1e-8 };
            assert!((greatest.value - peak).abs() < tolerance, "{name}, {steps} steps: {greatest:?} for {peak}");
        }
    }
}
