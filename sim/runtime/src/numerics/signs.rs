//! Changes of sign of a function between two places, by its values and its changes, rate times distance, at both.

use super::cubic::cubic;

/// How well a cubic foretells a function, relative to its size, where it need not be searched further.
const FORETOLD: f64 = 0.01;

/// A change of sign between numbers; reaching zero counts, leaving it does not.
pub(crate) fn crosses([before, after]: [f64; 2]) -> bool {
    let finite = before.is_finite() && after.is_finite();
    finite && before != 0.0 && (after == 0.0 || (before < 0.0) != (after < 0.0))
}

/// Whether a function may be zero between two places: it changes its sign, or its distance from zero is small relative to its
/// change.
#[inline]
pub(crate) fn may_reach_zero(values: [f64; 2], changes: [f64; 2]) -> bool {
    let least = values[0].abs().min(values[1].abs());
    let is_finite = (values[0] + values[1]).is_finite();
    crosses(values) || (is_finite && !(least > changes[0].abs().max(changes[1].abs())))
}

/// Whether a function that keeps its sign heads for zero at both places.
pub(crate) fn turns_back(values: [f64; 2], changes: [f64; 2]) -> bool {
    let sign = values[0].signum();
    values[0] * values[1] > 0.0 && sign * changes[0] < 0.0 && sign * changes[1] > 0.0
}

/// Whether the cubic of both places predicts the function at two fractions between them, or misses by rounding.
///
/// # Errors
/// The first error of the function.
pub(crate) fn is_foretold<E>(
    values: [f64; 2],
    changes: [f64; 2],
    rounding: f64,
    value: &mut dyn FnMut(f64) -> Result<f64, E>,
) -> Result<bool, E> {
    for fraction in [0.5, 0.29] {
        let found = value(fraction)?;
        let size = values[0].abs().max(values[1].abs()).max(found.abs());
        if !((found - cubic(values, changes, fraction)).abs() <= FORETOLD * size + rounding) {
            return Ok(false);
        }
    }
    Ok(true)
}
