//! Precedence and meaning of expressions, against values computed by hand.

#![allow(missing_docs, clippy::unwrap_used)]

use codegen::model::Resolved;
use codegen::symbolic::evaluate;

/// The SI value of a parameter's default.
fn value(expression: &str) -> f64 {
    let text = format!("M; coordinates {{ x; }} parameters {{ p = {expression}; }} bodies {{ b: mass 1 at [x, 0]; }}");
    let Resolved { model, graph, .. } =
        codegen::model::resolve(&codegen::parse(text.parse().unwrap()).unwrap()).unwrap();
    evaluate(&graph, &[model.parameters[0].default], |_| f64::NAN)[0]
}

/// A power of a sum with a number of many digits stays within the range of numbers, and so do its derivatives.
#[test]
fn powers_of_sums_with_many_digits() {
    let text = "M; coordinates { x; } bodies { b: mass 1 at [(x/3 + 1.9000000000000001)^40/1e11, 0]; }";
    let equations = codegen::equations(text.parse().unwrap()).unwrap();
    let values = evaluate(&equations.graph, &[equations.tmt.mass_matrix[0][0]], |_| 0.3);
    let expected = (40.0 / 3.0 * 2f64.powi(39) / 1e11).powi(2);
    // 80 factors, each with the rounding of the sum.
    assert!((values[0] / expected - 1.0).abs() < 1e-13, "{} {expected}", values[0]);
}

/// What has no value where a constraint is released counts for nothing there.
#[test]
fn released_constraints_need_no_value() {
    let text = "M; coordinates { x; } bodies { b: mass 1 at [x, 0]; } events { on: x = 2 { activate c; } }
        constraints { c: sqrt(x - 1) = ln(x)/(x - 0.5) initially released; }";
    let equations = codegen::equations(text.parse().unwrap()).unwrap();
    let (model, constraints) = (&equations.model, &equations.constraints);
    let all = [constraints.values[0], constraints.jacobian[0][0], constraints.convective[0], constraints.magnitudes[0]];
    let at = |x: f64, activity: f64| {
        evaluate(&equations.graph, &all, |symbol| if symbol == model.conditionals[0].symbol { activity } else { x })
    };
    assert_eq!(at(0.5, 0.0), [0.0; 4]);
    assert!(at(0.5, 1.0).iter().all(|value| !value.is_finite()));
    assert!(at(2.0, 1.0).iter().all(|value| value.is_finite() && *value != 0.0));
}

#[test]
fn precedence_and_functions() {
    let rows = [
        ("2 - 1", 1.0),
        ("2-1-0.5", 0.5),
        ("-2^2", -4.0),
        ("(-2)^2", 4.0),
        ("2^3^2", 512.0),
        ("2^-1", 0.5),
        ("2*3 - 4*-5", 26.0),
        ("6/2*3", 9.0),
        ("6/(2*3)", 1.0),
        ("1 - -1", 2.0),
        ("-(1 - 3)*2", 4.0),
        ("8^(1/3)", 2.0),
        ("norm([3, 4])", 5.0),
        ("inner([1, 2], [3, -4])", -5.0),
        ("([1, 2] - 2*[3, 4]/4).y", 0.0),
        ("atan2(1, -1)*4", 3.0 * std::f64::consts::PI),
        ("abs(-3) + sqrt(16) + e^0", 8.0),
        ("90 [deg] - pi/2", 0.0),
        ("1_000*1.5e-3", 1.5),
    ];
    for (text, expected) in rows {
        // Exact up to the roundings of the functions.
        assert!(
            (value(text) - expected).abs() <= 4.0 * f64::EPSILON * expected.abs().max(1.0),
            "{text}: {}",
            value(text)
        );
    }
}
