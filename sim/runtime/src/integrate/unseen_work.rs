//! Long steps whose work is wrong, though their motion is right.
//!
//! The error of a step is estimated from its positions and speeds. Where loads are polynomials of time, these may be
//! polynomials that the method integrates without error; the estimate is then nothing, whatever the length of the step. But the
//! power is a polynomial of twice the degree, and the work neither integrated nor interpolated without error. So the work of a
//! long step without an estimated error is compared with a quadrature. Its absolute tolerance is the kinetic energy at speeds of
//! one scale each, since that of speeds is a part of their scales.

use super::{Course, Step};
use crate::state::failure::Failure;
use crate::state::settings::Tolerance;
use crate::state::trajectory::State;
use sim_kernel::Mechanism;

/// An estimate of the error, in units of the tolerance, that is nothing: steps that it bounds have one near 1.
const NOTHING: f64 = 1e-3;
/// A step is long if it is more than one of so many equal ones: in shorter ones the error, of order 5 or more, is small enough.
const EQUAL_STEPS: f64 = 64.0;
/// Lobatto's quadrature between -1 and 1, of degree 7, inside: places and weights.
const LOBATTO: [(f64, f64); 3] =
    [(-0.654_653_670_707_977_1, 49.0 / 90.0), (0.0, 32.0 / 45.0), (0.654_653_670_707_977_1, 49.0 / 90.0)];
/// Its weight at both ends.
const LOBATTO_AT_ENDS: f64 = 0.1;

/// Where a step with this estimated error ends better, for its work.
///
/// # Errors
/// As the dense output.
#[inline]
pub(super) fn before_wrong_work<M: Mechanism>(
    step: &mut Step<M>,
    course: &Course,
    error: f64,
    tolerance: &Tolerance,
) -> Result<Option<f64>, Failure> {
    let is_long = step.length() > (course.end - course.begin) / EQUAL_STEPS;
    if error < NOTHING && is_long { middle_if_wrong(step, tolerance) } else { Ok(None) }
}

/// The middle, if the work until there is not that of the power.
#[cold]
fn middle_if_wrong<M: Mechanism>(step: &mut Step<M>, tolerance: &Tolerance) -> Result<Option<f64>, Failure> {
    let (from, to) = (step.from, step.to);
    let quarter = step.length() / 4.0;
    let middle = step.sample(from.state.time + 2.0 * quarter)?;
    let mut mean = LOBATTO_AT_ENDS * (from.power + middle.power);
    for (place, weight) in LOBATTO {
        mean += weight * step.sample(from.state.time + quarter * (1.0 + place))?.power;
    }
    let works = [from, &middle, to].map(|sample| sample.state.work);
    let largest = works.iter().fold(0.0, |largest: f64, work| largest.max(work.abs()));
    let wrong = (works[0] + quarter * mean - works[1]).abs();
    let State { time, positions, .. } = &from.state;
    let scale = step.motion.mechanism().kinetic_energy(*time, positions, step.motion.measures().coordinates());
    Ok((wrong > tolerance.relative * largest + tolerance.absolute * scale).then_some(middle.state.time))
}
