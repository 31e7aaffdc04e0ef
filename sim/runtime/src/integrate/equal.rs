//! Equal steps. Their times are computed from the start each time, so that they do not accumulate rounding.

use super::corners::check_equal_step;
use super::crossing::{Crossing, Way};
use super::switching::note_change;
use super::target::{Aim, Target};
use super::{Course, Steps};
use crate::motion::Motion;
use crate::state::failure::Failure;
use crate::state::settings::Tolerance;
use crate::state::trajectory::Sample;
use sim_kernel::Mechanism;

/// The tolerance of steps over singular positions between equal steps.
const EXACT: Tolerance = Tolerance::new(1e-12);

/// Aims at the end of the next of so many equal steps.
#[inline]
pub(super) fn aim_equally<M: Mechanism>(
    motion: &Motion<M>,
    course: &Course,
    (count, step): (usize, &mut usize),
    [from, to]: [&mut Sample<M>; 2],
    (crossing, target): (&mut Crossing<M>, &mut Target),
    steps: &mut Steps,
) -> Result<Aim, Failure> {
    let Some(goal) = next_goal(course, count, step, from.state.time) else { return Ok(Aim::End) };
    let length = (course.end - course.begin) / count as f64;
    let is_near = crossing.may_be_ahead(motion);
    let way = match is_near {
        true => crossing.lead(motion, [from, to], [length, course.end], &EXACT, steps)?,
        false => Way::On,
    };
    let time = match way {
        Way::Crossed => {
            crossing.ended(motion.least_sine());
            return Ok(Aim::Made);
        }
        Way::UpTo(time) => goal.min(time),
        Way::On => goal,
    };
    note_change(motion, from, time, &mut steps.sudden_changes);
    check_equal_step(motion, &from.state, [from.state.time, time])?;
    *target = Target { time, wanted: goal, tolerance: None, notes: is_near };
    Ok(Aim::Attempt)
}

/// The first of so many equal steps that may end later than now, or the one before it.
pub(super) fn first_step(course: &Course, count: usize, now: f64) -> usize {
    let passed = count as f64 * (now - course.begin) / (course.end - course.begin);
    (passed as usize).max(1)
}

/// The end of the next of so many equal steps.
fn next_goal(course: &Course, count: usize, step: &mut usize, now: f64) -> Option<f64> {
    let Course { begin, end, .. } = *course;
    let length = (end - begin) / count as f64;
    while *step <= count {
        // From the start each time, so that times do not accumulate rounding.
        let goal = if *step == count { end } else { begin + (end - begin) * (*step as f64 / count as f64) };
        // A step over a singular position may end near one of these times or beyond it; that time is then skipped.
        let rest = if *step < count { 0.1 * length } else { 4.0 * f64::EPSILON * goal.abs() };
        if goal - now > rest {
            return Some(goal);
        }
        *step += 1;
    }
    None
}
