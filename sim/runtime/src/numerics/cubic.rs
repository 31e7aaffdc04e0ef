//! The cubic between two places.

/// The cubic with these values and rates at 0 and 1.
pub(crate) fn cubic(value: [f64; 2], rate: [f64; 2], s: f64) -> f64 {
    let r = 1.0 - s;
    value[0] * (1.0 + 2.0 * s) * r * r + value[1] * (3.0 - 2.0 * s) * s * s + s * r * (r * rate[0] - s * rate[1])
}
