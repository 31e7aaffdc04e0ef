//! Whether constraints are met.

use crate::motion::measures::Measures;
use crate::motion::rows::{Linear, Rows};
use crate::numerics::numbers::{all, smaller};
use sim_kernel::{Array, Mask, Mechanism, Scalar};

/// A constraint with a residual below this fraction of its terms is met.
pub(crate) const TOLERANCE: f64 = 1e-12;
/// A residual above this fraction of a constraint's terms is never attributed to rounding. The tolerance of the
/// projection grows with the terms of a constraint, so a run whose coordinates explode would otherwise pass.
const LARGEST_ROUNDING: f64 = 1e-6;

/// Where all of these residuals are at most this fraction of the scales of the constraints.
#[inline(always)]
pub(crate) fn is_within<S: Scalar, M: Mechanism<S>>(measures: &Measures<M, S>, values: &M::L, part: f64) -> S::Mask {
    all::<S>(values.len(), |row| values[row].abs().at_most(S::from_f64(part) * measures.constraints()[row]))
}

/// Where every residual is at the level of its own rounding.
#[inline]
pub(crate) fn is_met<S: Scalar, M: Mechanism<S>, R: Rows<S, M>>(
    mechanism: &M,
    measures: &Measures<M, S>,
    time: S,
    q: &M::Q,
    linear: &Linear<S, M, R>,
) -> S::Mask {
    let is_within = is_within(measures, &linear.values, TOLERANCE);
    match S::not(is_within).any() {
        false => is_within,
        true => is_within | is_met_by_rounding::<S, M, R>(mechanism, measures, time, q, linear),
    }
}

#[cold]
fn is_met_by_rounding<S: Scalar, M: Mechanism<S>, R: Rows<S, M>>(
    mechanism: &M,
    measures: &Measures<M, S>,
    time: S,
    q: &M::Q,
    linear: &Linear<S, M, R>,
) -> S::Mask {
    let number = S::from_f64;
    let magnitudes = mechanism.constraint_magnitudes(time, q);
    all::<S>(mechanism.m(), |i| {
        let moved = R::terms(mechanism, &linear.jacobian, i, q);
        let rounding = number(8.0 * f64::EPSILON) * (magnitudes[i] + moved);
        let size = measures.constraints()[i];
        let most = smaller(rounding + number(TOLERANCE) * size, number(LARGEST_ROUNDING) * size);
        linear.values[i].abs().at_most(most)
    })
}
