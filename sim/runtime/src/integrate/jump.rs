//! Jumps of accelerations within a step.

use super::Step;
use crate::numerics::root::find_root;
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

/// How exactly a change is located, and how near to it accelerations are compared at least, as parts of the step.
const EXACTLY: f64 = 1e-12;
const LEAST: f64 = 1e-3;
/// In a short step coordinates change by less than this part of their scales; places in it differ by little more than rounding, so
/// that its ends are compared with places outside it, so many lengths away.
const SHORT: f64 = 1e-6;
const FARTHER: f64 = 2.0;

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

/// The samples before and after a jump where a condition of loads changes its sign, as it does between the ends of a step; none
/// if loads are continuous there.
///
/// # Errors
/// As the dense output and the right-hand side.
pub(crate) fn jump_by<M: Mechanism>(step: &mut Step<M>, condition: usize) -> Result<Option<[Sample<M>; 2]>, Failure> {
    if is_short(step) {
        return jump_over(step);
    }
    let (mechanism, from, length) = (step.motion.mechanism(), step.from.state.time, step.length());
    let mut value = |fraction: f64| -> Result<f64, Failure> {
        let state = step.at(from + fraction * length)?;
        Ok(mechanism.load_conditions(state.time, &state.positions, &state.speeds)[condition])
    };
    let fraction = find_root(value(0.0)?, value(1.0)?, EXACTLY, &mut value)?;
    let beside = (fraction.min(1.0 - fraction) / 2.0).max(LEAST);
    jump(step, from + fraction * length, beside * length)
}

/// Whether nothing but a jump is seen in a step.
fn is_short<M: Mechanism>(step: &Step<M>) -> bool {
    let (motion, length) = (step.motion, step.length());
    let rates = motion.size(&step.from.state.speeds) + motion.size(&step.from.accelerations) * length;
    rates * length < SHORT
}

/// The ends of a short step over a jump, which are themselves the near places.
fn jump_over<M: Mechanism>(step: &Step<M>) -> Result<Option<[Sample<M>; 2]>, Failure> {
    let near = [step.from.clone(), step.to.clone()];
    let moved = |sample: &Sample<M>, by: f64| {
        step.motion.sample(sample.state.changed(sample.state.time + by, by, &sample.rates()))
    };
    let aside = FARTHER * step.length();
    let far = [moved(step.from, -aside)?, moved(step.to, aside)?];
    Ok(is_jump(step, &far, &near).then_some(near))
}

/// How near to a pole accelerations are compared, as parts of the distance from it, and how much larger they are there at least.
const TOWARDS: [f64; 4] = [1e-2, 1e-4, 1e-6, 1e-8];
const GROWN: f64 = 50.0;

/// Whether accelerations grow without end towards a time in a step, which is so far from its beginning: no motion passes there, but a
/// long step would. They are infinite where they have no value.
pub(super) fn is_pole<M: Mechanism>(step: &mut Step<M>, time: f64, distance: f64) -> bool {
    let sizes = TOWARDS.map(|part| {
        let there = step.sample(time - part * distance);
        there.map_or(f64::INFINITY, |there| step.motion.size(&there.accelerations))
    });
    let farther = step.motion.size(&step.from.accelerations);
    sizes.windows(2).any(|pair| pair[1] > GROWN * pair[0].max(farther))
}
