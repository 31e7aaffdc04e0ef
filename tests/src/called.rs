//! Numbers of kernels beside those of a reference.

use serde_json::Value;
use sim::{At, Kernel, Model};

/// All numbers that a kernel gives at a state that it accepts.
pub fn called(model: &dyn Model, kernel: Kernel, at: At<f64>) -> Vec<f64> {
    let mut found = Vec::new();
    assert!(!model.call(kernel, at, &mut |_, row| found.extend_from_slice(row)), "{kernel:?} is refused");
    found
}

/// The numbers of an array; NaN for what is none.
pub fn numbers(value: &Value) -> Vec<f64> {
    value.as_array().into_iter().flatten().map(|number| number.as_f64().unwrap_or(f64::NAN)).collect()
}

/// The greatest difference, relative to the greatest number expected; infinite where the numbers are not as many.
pub fn difference(found: &[f64], expected: &[f64]) -> f64 {
    if found.len() != expected.len() {
        return f64::INFINITY;
    }
    let largest = expected.iter().fold(0.0, |largest: f64, number| largest.max(number.abs()));
    // A NaN is a difference, which `max` would pass over.
    let worst = found
        .iter()
        .zip(expected)
        .map(|(a, b)| (a - b).abs())
        .fold(0.0, |worst, x| if x > worst || x.is_nan() { x } else { worst });
    worst / largest
}
