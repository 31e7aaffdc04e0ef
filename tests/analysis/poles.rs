//! Quantities of sweeps that grow without bound have no peak; those that are steep have one.

use sim::{Driven, Sweep, declared_start, kinematics};
use tests::any_model::interpreted;

/// The greatest size of an output over a turn, if it has one; beside another, which has a corner where tangents have a pole.
fn peak(output: &str, steps: usize) -> Option<f64> {
    let text = format!(
        "pub Turns; coordinates {{ a [rad]; }} bodies {{ wheel: inertia 1 [kg*m^2], angle a; }}
         initial {{ a = -1.2; dot(a) = 2; }} outputs {{ corner = abs(sin(a) - 1); o = {output}; }}"
    );
    let model = interpreted(&text).unwrap();
    let start = declared_start(&model);
    let end = std::f64::consts::TAU - 1.2;
    let sweep = Sweep { driven: Driven::Coordinate(0), from: -1.2, to: end, speed: 2.0, steps, held: vec![] };
    kinematics(model, &start, &sweep).unwrap().extremes.outputs[1].map(|range| range.peak().value.abs())
}

/// Poles of the first and the second order, of roots and of logarithms, in the middle of steps and where intervals end.
#[test]
fn poles_are_no_peaks() {
    let poles = [
        "tan(a)",
        "if tan(a) > 1 then 0 else tan(a)",
        "1/(1 + cos(a))",
        "1/(1 - cos(a - 1.349))^2",
        "1/(sin(a) - 0.5)^2",
        "1/sqrt(1 - cos(a - 0.87))",
        "1/sqrt(abs(sin(a) - 0.3))",
        "ln(abs(sin(a)))",
        "ln(1 - cos(a - 0.4))",
    ];
    for (output, steps) in poles.into_iter().flat_map(|output| [1, 100, 720].map(|steps| (output, steps))) {
        assert_eq!(peak(output, steps), None, "{output}, {steps} steps");
    }
}

/// Peaks that are a million times as high as what is around them, and a thousandth or less wide.
#[test]
fn steep_peaks_are_no_poles() {
    let peaks = [
        ("1/(1 + 1e10*(sin(a) - 0.5)^2)", 1.0),
        ("1/(1.000001 - cos(a))", 1e6),
        ("ln(1.000001 - cos(a))", 1e-6f64.ln().abs()),
        ("sqrt(abs(sin(a) - 0.3))", 1.3f64.sqrt()),
        ("if a < 2 then 1 else 3e7", 3e7),
        ("exp(-1e6*sin(a)^2)", 1.0),
        ("ln(1e8*abs(sin(a)) + 1)", (1e8f64 + 1.0).ln()),
        ("1/(1e-13 + (sin(a) - 0.5)^2)", 1e13),
    ];
    for ((output, expected), steps) in peaks.into_iter().flat_map(|of| [1, 100, 720].map(|steps| (of, steps))) {
        let found = peak(output, steps).unwrap_or_else(|| panic!("{output}, {steps} steps"));
        // What is found from values alone, as at a step, is known to 1e-9 of the range; 1 - cos(a) near its zero to 1e-16 of 1e-6.
        assert!((found - expected).abs() < 1e-8 * expected, "{output}, {steps} steps: {found:e} for {expected:e}");
    }
}
