//! Equal steps over sudden changes of loads by positions and speeds, and over short pulses.
//!
//! Over a jump of a load the error of a step is in proportion to its length, by any method; over a kink to its square or higher, and
//! most motions with contacts or friction have kinks. So a step counts where accelerations jump, and where loads begin and end within
//! it.

use super::Step;
use super::change_of_load::Change;
use super::changes_of_loads::changes;
use super::jump::jump;
use super::short_pulses::short_pulse;
use super::switching::SuddenChanges;
use crate::state::failure::Failure;
use sim_kernel::{Array, Mechanism, SwitchingKind};

/// How far beside a change accelerations are compared, as a part of the step, and of the distance of another change.
const BESIDE: f64 = 1e-4;
const NEARER: f64 = 0.25;
/// By which part of themselves accelerations go beyond those of both ends of a step, where a load begins and ends within it: those
/// of a harmonic motion go so far in steps of a sixteenth of its period.
const BEYOND: f64 = 0.02;

/// Counts an equal step, if it leads over a sudden change of loads by positions or speeds.
#[inline]
pub(super) fn note_jump<M: Mechanism>(step: &mut Step<M>, noted: &mut Option<SuddenChanges>) {
    let description = step.motion.mechanism().description();
    if description.has_load_conditions() || description.switching.iter().any(|function| function.kind.is_smooth()) {
        note(step, noted);
    }
}

#[cold]
fn note<M: Mechanism>(step: &mut Step<M>, noted: &mut Option<SuddenChanges>) {
    let motion = step.motion;
    // The step itself has been made: where it cannot be looked into, nothing is known.
    if let Ok(Some(time)) = motion.aside(|| sudden_change(step)) {
        SuddenChanges::count(noted, time, step.to.state.time);
    }
}

/// The time of the first pulse within a step that is too short for it, or of the first change that is sudden.
fn sudden_change<M: Mechanism>(step: &mut Step<M>) -> Result<Option<f64>, Failure> {
    let (middles, changes): (Vec<Change>, Vec<Change>) =
        changes(step)?.into_iter().partition(|change| change.kind.is_smooth());
    if let Some(middle) = short_pulse(
        step,
        middles.iter().filter(|middle| middle.kind != SwitchingKind::Flank).map(|middle| middle.time),
    )? {
        return Ok(Some(middle));
    }
    for (place, Change { time, is_row, .. }) in changes.iter().enumerate() {
        let neighbours = [place.checked_sub(1), Some(place + 1)].into_iter().flatten();
        let gaps = neighbours.filter_map(|other| changes.get(other)).map(|other| (other.time - time).abs());
        let beside = gaps.fold(BESIDE * step.length(), |beside, gap| beside.min(NEARER * gap));
        if !is_row && jump(step, *time, beside)?.is_some() {
            return Ok(Some(*time));
        }
    }
    begins_and_ends(step, &changes)
}

/// The time of the first of several changes between which accelerations are beyond those of both ends.
fn begins_and_ends<M: Mechanism>(step: &mut Step<M>, changes: &[Change]) -> Result<Option<f64>, Failure> {
    let (motion, [from, to]) = (step.motion, [step.from, step.to].map(|sample| &sample.accelerations));
    let mut largest = motion.size(from).max(motion.size(to));
    let mut farthest = (changes.first().map_or(0.0, |first| first.time), 0.0);
    for pair in changes.windows(2) {
        let [first, second] = [pair[0].time, pair[1].time];
        for time in [first, first + (second - first) / 2.0, second] {
            let inside = step.sample(time)?.accelerations;
            let beyond = inside.like(|i| inside[i] - inside[i].max(from[i].min(to[i])).min(from[i].max(to[i])));
            largest = largest.max(motion.size(&inside));
            let far = motion.size(&beyond);
            if far > farthest.1 {
                farthest = (first, far);
            }
        }
    }
    Ok((farthest.1 > BEYOND * largest).then_some(farthest.0))
}
