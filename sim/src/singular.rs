//! Singular positions, where constraints that are independent elsewhere depend on each other, and how a motion passes them.
//!
//! Branches of the configuration space cross there. Speeds do not jump, so the motion goes straight on along its own; but
//! with s the sine of the angle between a row of C_q and those before it, rounding of positions is amplified by 1/s and
//! that of speeds by 1/s^2. Steps are therefore laid so that such a position falls between stages and far from all of them.

use crate::failure::{Failure, constraint_name};
use crate::motion::Motion;
use crate::project::inner;
use crate::root::find_root;
use crate::trajectory::{Sample, State};
use sim_kernel::{Array, Mechanism};

/// A singular position that a run has passed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Singularity {
    /// The constraint that depends on those before it there.
    pub constraint: &'static str,
    /// When, in seconds.
    pub time: f64,
    /// What is left there of the sine of its angle to them; its row of C_q counts relative to the longest that it has been.
    pub sine: f64,
}

/// Below this sine a projection would spoil what a step knows better: rounding of 1e-16 times 1/s^2 is 1e-12.
pub(crate) const AT: f64 = 0.01;
/// A row of C_q that vanishes within this part of its length does so but for the error of what it was foretold from.
const FORETOLD: f64 = 0.1;
/// The same where it was found inside a step that was made.
const FOUND: f64 = 0.01;
/// A row this near to the space of those before it, as a sine, depends on them everywhere.
const DEPENDENT: f64 = 1e-9;
/// How near before a singular position the step over it may start, in units of the longest.
const APPROACH: f64 = 0.9;

/// How far the sines at the ends of steps are foretold, in steps as long as the last.
const FORESIGHT: f64 = 3.0;
/// Below this sine, foretold, the way ahead is looked at.
const LOOK: f64 = 0.06;

/// Whether a singular position may lie within the next steps, after two that ended at these sines.
#[inline]
pub(crate) fn may_be_ahead([before, now]: [f64; 2]) -> bool {
    now - FORESIGHT * (before - now) < LOOK
}

/// How a step is laid.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Lie {
    /// Where it would end were there no singular position.
    pub(crate) goal: f64,
    /// The longest that it may be, in seconds.
    pub(crate) longest: f64,
    /// The place in a step that is farthest from its stages.
    pub(crate) gap: f64,
    /// Whether its stages may be brought onto the constraints.
    pub(crate) keeps_stages: bool,
    /// Below this sine it does not start, but at the end of one that leads over a singular position, which may be longer.
    pub(crate) least_sine: f64,
}

/// Where a step from a sample should end, so that its stages keep away from the singular position ahead, if there is one:
/// before it, or beyond it.
///
/// Explicit stages of a step that leads over it are evaluated on the constraints, so that what they are off is not divided by s.
pub(crate) fn end_of_step<M: Mechanism>(motion: &Motion<M>, from: &Sample<M>, lie: &Lie) -> f64 {
    let now = from.state.time;
    let ahead = singularity_ahead(motion, from, lie);
    motion.keep_stages(lie.keeps_stages && ahead.is_some_and(|(ahead, h)| ahead <= lie.gap * h));
    match ahead {
        Some((ahead, h)) if ahead <= lie.gap * h => now + ahead / lie.gap,
        Some((ahead, h)) => lie.goal.min(now + ahead - APPROACH * lie.gap * h),
        None => lie.goal,
    }
}

/// The time to the first singular position within about a step, foretold from positions, speeds and accelerations, and how
/// long a step over it may be.
fn singularity_ahead<M: Mechanism>(motion: &Motion<M>, from: &Sample<M>, lie: &Lie) -> Option<(f64, f64)> {
    let state = &from.state;
    let rows = |ahead: f64| {
        let position = |i: usize| state.positions[i] + ahead * (state.speeds[i] + ahead / 2.0 * from.accelerations[i]);
        independent_parts::<M>(&motion.mechanism().constraint_jacobian(state.time + ahead, &M::Q::from_fn(position)))
    };
    let (here, next) = (rows(0.0), rows(lie.longest));
    let of_row = |row: usize| {
        let along = |rows: &M::LQ| inner(&rows[row], &here[row]);
        let slope = sine(motion, row, &here) * (1.0 - along(&next) / along(&here)) / lie.longest;
        let needed = lie.least_sine / (APPROACH * lie.gap * slope);
        let h = if needed > lie.longest { needed } else { lie.longest };
        let reach = 1.5 * h;
        let root =
            root_between(along(&here), along(&rows(reach)), 1e-4, &mut |s| Ok(along(&rows(s * reach)))).ok()??;
        (sine(motion, row, &rows(root * reach)) < FORETOLD).then_some((root * reach, h))
    };
    (0..M::L::LEN).filter_map(of_row).min_by(|(a, _), (b, _)| a.total_cmp(b))
}

/// The singular position that a step has passed, if any: the part of a row of C_q that is independent of those before it
/// has turned round. `inside` gives the state at a fraction of the step.
pub(crate) fn passed<M: Mechanism>(
    motion: &Motion<M>,
    [from, to]: [&State<M>; 2],
    [before, after]: [&M::LQ; 2],
    inside: &mut dyn FnMut(f64) -> Result<State<M>, Failure>,
) -> Result<Option<Singularity>, Failure> {
    for row in 0..M::L::LEN {
        let along = |parts: &M::LQ| inner(&parts[row], &before[row]);
        let found =
            root_between(along(before), along(after), 1e-12, &mut |s| Ok(along(&parts_at(motion, &inside(s)?))))?;
        let Some(fraction) = found else { continue };
        let sine = sine(motion, row, &parts_at(motion, &inside(fraction)?));
        if sine < FOUND {
            let time = from.time + fraction * (to.time - from.time);
            return Ok(Some(Singularity { constraint: constraint_name::<M>(row), time, sine }));
        }
    }
    Ok(None)
}

/// The part of each row of C_q at a state that is orthogonal to those before it.
#[inline]
pub(crate) fn parts_at<M: Mechanism>(motion: &Motion<M>, state: &State<M>) -> M::LQ {
    independent_parts::<M>(&motion.mechanism().constraint_jacobian(state.time, &state.positions))
}

/// A root in (0, 1) of a function that falls from a positive value to a negative one, if it does.
fn root_between(
    first: f64,
    last: f64,
    tolerance: f64,
    f: &mut dyn FnMut(f64) -> Result<f64, Failure>,
) -> Result<Option<f64>, Failure> {
    if first > 0.0 && last < 0.0 { find_root(first, last, tolerance, f).map(Some) } else { Ok(None) }
}

/// The constraint that is nearest to depending on those before it, of those that do not everywhere, with its sine.
pub(crate) fn weakest_constraint<M: Mechanism>(motion: &Motion<M>, state: &State<M>) -> Option<(&'static str, f64)> {
    let jacobian = motion.mechanism().constraint_jacobian(state.time, &state.positions);
    motion.lengthen(|row| inner(&jacobian[row], &jacobian[row]));
    let rows = independent_parts::<M>(&jacobian);
    let sines = (0..M::L::LEN).map(|row| (row, sine(motion, row, &rows))).filter(|(_, sine)| *sine > 0.0);
    sines.min_by(|(_, a), (_, b)| a.total_cmp(b)).map(|(row, sine)| (constraint_name::<M>(row), sine))
}

/// The length of the independent part of a row, relative to the longest that the row has been.
fn sine<M: Mechanism>(motion: &Motion<M>, row: usize, parts: &M::LQ) -> f64 {
    (inner(&parts[row], &parts[row]) / motion.longest()[row]).sqrt()
}

/// The part of each row that is orthogonal to those before it; zero for one that depends on them everywhere.
fn independent_parts<M: Mechanism>(jacobian: &M::LQ) -> M::LQ {
    let mut parts = *jacobian;
    for i in 0..M::L::LEN {
        let mut part = parts[i];
        // Twice, so that rounding leaves nothing of what was taken.
        for j in (0..i).chain(0..i) {
            let square = inner(&parts[j], &parts[j]);
            if square > 0.0 {
                let share = inner(&parts[j], &part) / square;
                part = M::Q::from_fn(|k| part[k] - share * parts[j][k]);
            }
        }
        let is_dependent = inner(&part, &part) <= DEPENDENT * DEPENDENT * inner(&jacobian[i], &jacobian[i]);
        parts[i] = if is_dependent { M::Q::filled(0.0) } else { part };
    }
    parts
}
