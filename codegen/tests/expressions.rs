//! Precedence and meaning of expressions, against values computed by hand.

#![allow(missing_docs, clippy::unwrap_used)]

use codegen::symbolic::evaluate;

/// The SI value of a parameter's default.
fn value(expression: &str) -> f64 {
    let text = format!("M; coordinates {{ x; }} parameters {{ p = {expression}; }} bodies {{ b: mass 1 at [x, 0]; }}");
    let model = codegen::model::resolve(&codegen::dsl::parse(text.parse().unwrap()).unwrap()).unwrap();
    evaluate(&model.graph, &[model.parameters[0].default], |_| f64::NAN)[0]
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
