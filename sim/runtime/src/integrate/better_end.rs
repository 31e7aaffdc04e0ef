//! Where a step ends better in which loads change their form.
//!
//! Where accelerations jump at the change, an estimate is too small there too: where a jump lies before the second stage of dopri5,
//! by a factor of 75. But no method is wrong by more than the jump of the accelerations times the length of the step. So a step
//! over a jump is so short that this is a part of the tolerance, and steps come up to the jump until one that goes as far beyond
//! it is.
//!
//! The middle of a smooth pulse by positions is the end of a step, which sees it.

use super::Step;
use super::change_of_load::{Change, SAME};
use super::jump::{difference, is_pole, jump};
use crate::state::failure::Failure;
use crate::state::settings::Tolerance;
use sim_kernel::{Array, Mechanism, SwitchingKind};

/// A step begins beside a change that is within this part of its length, and one that is to come up to a change ends before it by
/// this part.
const NEAR: f64 = 0.01;
/// The middle of a pulse is seen from an end of a step within this part of its length.
const SEEN: f64 = 1e-6;
/// The most that a step over a jump may be wrong by, in units of the tolerance: the jumps of a motion mostly go the same way.
const SLIGHT: f64 = 0.1;
/// A step of so many roundings of its time is not made shorter.
const SHORTEST: f64 = 64.0;

/// Up to the first change, or between that and the next one, of changes in order; nothing if the end is right.
///
/// # Errors
/// As the dense output.
pub(super) fn better_end<M: Mechanism>(
    step: &mut Step<M>,
    mut changes: Vec<Change>,
    tolerance: &Tolerance,
) -> Result<Option<f64>, Failure> {
    let (begin, length) = (step.from.state.time, step.length());
    let unseen = (begin + SEEN * length)..(step.to.state.time - SEEN * length);
    changes.retain(|change| !change.kind.is_smooth() || unseen.contains(&change.time));
    let is_long = length > SHORTEST * f64::EPSILON * begin.abs();
    let middle = changes.iter().find(|change| change.kind.is_smooth() && is_long).map(|change| change.time);
    changes.retain(|change| !change.kind.is_smooth());
    if matches!(changes.as_slice(), [only] if only.is_gentle) {
        return Ok(middle);
    }
    match changes.first().copied() {
        Some(first) if middle.is_none_or(|middle| first.time < middle) => {
            Ok(end_before(step, first, &changes, tolerance)?.or(middle))
        }
        _ => Ok(middle),
    }
}

/// The better end of a step in which loads change their form, at first here. Several conditions may say the same.
fn end_before<M: Mechanism>(
    step: &mut Step<M>,
    first: Change,
    changes: &[Change],
    tolerance: &Tolerance,
) -> Result<Option<f64>, Failure> {
    let (begin, length) = (step.from.state.time, step.length());
    let apart = SAME * length;
    let second = changes.iter().find(|change| change.time - first.time > apart).map(|change| change.time);
    let between = second.map(|second| first.time + (second - first.time) / 2.0);
    let distance = first.time - begin;
    let before = first.time - NEAR * distance;
    let jump = match changes.iter().all(|change| change.is_row || change.time - first.time > apart) {
        true => None,
        false => jump_at(step, first.time, between.unwrap_or(step.to.state.time))?,
    };
    let error = |length: f64| jump.as_ref().map_or(0.0, |jump| error_over(step, jump, length, tolerance));
    let [bound, of_crossing] = [length, 2.0 * distance].map(error);
    let is_there = |change: &Change| change.time - first.time <= apart;
    let is_at_pole = changes.iter().any(|change| change.kind == SwitchingKind::Pole && is_there(change));
    Ok(match () {
        _ if length <= SHORTEST * f64::EPSILON * begin.abs() => None,
        _ if is_at_pole && is_pole(step, first.time, distance) => Some(before),
        _ if jump.is_some() && between.is_none() && bound <= SLIGHT => None,
        _ if distance > NEAR * length => Some(before),
        _ if jump.is_none() => between,
        _ if of_crossing <= SLIGHT => Some(between.unwrap_or(f64::INFINITY).min(first.time + distance)),
        _ => Some(before),
    })
}

/// The jump of accelerations at a change, before which nothing else changes in the step, and after it nothing until a time.
fn jump_at<M: Mechanism>(step: &mut Step<M>, time: f64, until: f64) -> Result<Option<M::Q>, Failure> {
    let beside = (time - step.from.state.time).min(until - time) / 2.0;
    if beside > 0.0 { Ok(jump(step, time, beside)?.as_ref().map(difference)) } else { Ok(None) }
}

/// The most that a step of a length over a jump is wrong by, in units of the tolerance.
fn error_over<M: Mechanism>(step: &Step<M>, jump: &M::Q, length: f64, tolerance: &Tolerance) -> f64 {
    let [from, to] = [step.from, step.to].map(|sample| &sample.state);
    let [of_positions, of_speeds] = [length * length / 2.0, length].map(|factor| jump.like(|i| factor * jump[i]));
    tolerance.norm(step.motion.measures(), from, to, [&of_positions, &of_speeds])
}
