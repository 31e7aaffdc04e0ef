//! Jumps of accelerations within a step.

use super::Step;
use crate::state::failure::Failure;
use crate::state::trajectory::Sample;
use sim_kernel::{Array, Mechanism};

/// How much nearer accelerations are compared once more.
const NEARER: f64 = 0.25;
/// As much of a difference as stays at the nearer places is a jump: a continuous one becomes less, a smooth one in proportion, and
/// that of a root by half.
const STAYS: f64 = 0.75;
/// A difference of accelerations that is rounding, as a part of them.
const ROUNDING: f64 = 1e-9;

/// The samples so near before and after a time at which accelerations jump, if they do, as seen from those so many seconds before
/// and after it.
///
/// # Errors
/// As the dense output and the right-hand side.
pub(super) fn jump<M: Mechanism>(
    step: &mut Step<M>,
    time: f64,
    beside: f64,
) -> Result<Option<[Sample<M>; 2]>, Failure> {
    let mut around = |beside: f64| -> Result<[Sample<M>; 2], Failure> {
        Ok([step.sample(time - beside)?, step.sample(time + beside)?])
    };
    let (far, near) = (around(beside)?, around(NEARER * beside)?);
    Ok(is_jump(step, &far, &near).then_some(near))
}

/// Whether accelerations at nearer places differ as much as at those farther apart.
fn is_jump<M: Mechanism>(step: &Step<M>, far: &[Sample<M>; 2], near: &[Sample<M>; 2]) -> bool {
    let size = |rates: &M::Q| step.motion.size(rates);
    let largest = size(&far[0].accelerations).max(size(&far[1].accelerations));
    let [of_far, of_near] = [far, near].map(|samples| size(&difference(samples)));
    of_far > ROUNDING * largest && of_near > STAYS * of_far
}

/// By how much accelerations differ.
pub(super) fn difference<M: Mechanism>([before, after]: &[Sample<M>; 2]) -> M::Q {
    after.accelerations.like(|i| after.accelerations[i] - before.accelerations[i])
}
