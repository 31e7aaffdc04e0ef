//! Whether constraints are met.

use crate::motion::measures::Measures;
use crate::motion::rows::{Linear, Rows};
use sim_kernel::{Array, Mechanism};

/// A constraint with a residual below this fraction of its terms is met.
pub(crate) const TOLERANCE: f64 = 1e-12;
/// A residual above this fraction of a constraint's terms is never attributed to rounding. The tolerance of the
/// projection grows with the terms of a constraint, so a run whose coordinates explode would otherwise pass.
const LARGEST_ROUNDING: f64 = 1e-6;

/// Whether all of these residuals are at most this fraction of the scales of the constraints.
#[inline(always)]
pub(crate) fn is_within<M: Mechanism>(measures: &Measures<M>, values: &M::L, part: f64) -> bool {
    (0..values.len()).all(|row| values[row].abs() <= part * measures.constraints()[row])
}

/// Whether every residual is at the level of its own rounding.
#[inline]
pub(crate) fn is_met<M: Mechanism, R: Rows<M>>(
    mechanism: &M,
    measures: &Measures<M>,
    time: f64,
    q: &M::Q,
    linear: &Linear<M, R>,
) -> bool {
    is_within(measures, &linear.values, TOLERANCE) || is_met_by_rounding::<M, R>(mechanism, measures, time, q, linear)
}

#[cold]
fn is_met_by_rounding<M: Mechanism, R: Rows<M>>(
    mechanism: &M,
    measures: &Measures<M>,
    time: f64,
    q: &M::Q,
    linear: &Linear<M, R>,
) -> bool {
    let magnitudes = mechanism.constraint_magnitudes(time, q);
    (0..mechanism.m()).all(|i| {
        let moved = R::terms(mechanism, &linear.jacobian, i, q);
        let rounding = 8.0 * f64::EPSILON * (magnitudes[i] + moved);
        let size = measures.constraints()[i];
        linear.values[i].abs() <= (rounding + TOLERANCE * size).min(LARGEST_ROUNDING * size)
    })
}
