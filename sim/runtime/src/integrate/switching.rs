//! Times at which what acts on a mechanism changes its form, known before the motion is: conditions of `if`, `min`, `max`,
//! `abs` and `sign` that depend on time alone, and rows of tables of it.
//!
//! An adaptive step over a force that begins and ends within it might see nothing of it, and one over a jump is refused
//! many times. So steps end before such a time, and a step as short as rounding allows leads over it. A table is
//! continuous: its row itself is the end of a step, and so is the middle of a smooth pulse. Equal steps stay equal; those that lead over such times are counted, as are
//! those over changes by positions and speeds and over short pulses ([`super::jumps_of_loads`]).

use super::changes_in_time::{ASIDE, First, What, first_change, tick};
use crate::motion::Motion;
use crate::state::saved::{Bytes, Damaged};
use crate::state::trajectory::{Sample, State};
use sim_kernel::{Array, Mechanism, Switching};

/// Where the next step ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Stop {
    /// At this time, before something changes or where a table has a row.
    Before(f64),
    /// At this time, after what changes between it and now.
    Across(f64),
}

/// The end that the first change of form after now puts to a step until this time. Accelerations may jump at rows too.
#[inline]
pub(super) fn next_stop<M: Mechanism>(motion: &Motion<M>, now: f64, until: f64, rows_jump: bool) -> Option<Stop> {
    let functions = motion.mechanism().description().switching;
    if functions.is_empty() { None } else { first_stop(motion, functions, [now, until], rows_jump) }
}

#[cold]
fn first_stop<M: Mechanism>(
    motion: &Motion<M>,
    functions: &[Switching],
    [now, until]: [f64; 2],
    rows_jump: bool,
) -> Option<Stop> {
    let tick = tick(now, until);
    let First { time, what } = first_change(motion.mechanism(), functions, now, until)?;
    Some(match what {
        What::Row if !rows_jump => Stop::Before(time),
        What::Middle | What::Flank | What::Unknown => Stop::Before(time),
        What::Row | What::Zero => match time - ASIDE * tick {
            before if before > now + tick => Stop::Before(before),
            _ => Stop::Across(time + ASIDE * tick),
        },
    })
}

/// Equal steps that led over sudden changes, or short pulses, of what acts on the mechanism: they are less accurate, and do not see what begins
/// and ends within them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SuddenChanges {
    /// The number of these steps.
    pub steps: u64,
    /// The time of the first change, in seconds.
    pub first: f64,
    /// The end of the last of these steps.
    until: f64,
}

impl SuddenChanges {
    /// Counts a step until a time, whose first sudden change this is.
    pub(super) fn count(changes: &mut Option<SuddenChanges>, first: f64, until: f64) {
        let changes = changes.get_or_insert(SuddenChanges { steps: 0, first, until: f64::NEG_INFINITY });
        // An event within a step ends it, and another begins.
        if changes.until < until {
            *changes = SuddenChanges { steps: changes.steps + 1, until, ..*changes };
        }
    }

    pub(super) fn transfer(changes: &mut Option<SuddenChanges>, bytes: &mut Bytes) -> Result<(), Damaged> {
        let none = || SuddenChanges { steps: 0, first: 0.0, until: 0.0 };
        bytes.option(changes, none, |bytes, SuddenChanges { steps, first, until }| {
            bytes.tally(steps)?;
            bytes.number(first)?;
            bytes.number(until)
        })
    }
}

/// Counts an equal step from a sample until a time, if it leads over a sudden change.
#[inline]
pub(super) fn note_change<M: Mechanism>(
    motion: &Motion<M>,
    from: &Sample<M>,
    until: f64,
    changes: &mut Option<SuddenChanges>,
) {
    let functions = motion.mechanism().description().switching;
    if functions.iter().all(|function| function.kind.is_smooth()) {
        return;
    }
    if let Some(first) = sudden_change(motion, functions, from, until) {
        SuddenChanges::count(changes, first, until);
    }
}

/// The time of the first change within a step that may not see it. Tables are continuous: of these what lies between two rows
/// may not be seen.
#[cold]
fn sudden_change<M: Mechanism>(
    motion: &Motion<M>,
    functions: &[Switching],
    from: &Sample<M>,
    until: f64,
) -> Option<f64> {
    let (known, now) = (|from: f64| first_known_change(motion.mechanism(), functions, from, until), from.state.time);
    let First { time, what } = known(now).and_then(|first| {
        let is_over = first.time <= now + tick(now, until) && !accelerations_jump(motion, from, first.time);
        if is_over { known(first.time) } else { Some(first) }
    })?;
    match what {
        What::Row => known(time).map(|_| time),
        What::Zero | What::Middle | What::Flank | What::Unknown => Some(time),
    }
}

/// A difference of accelerations that is rounding, as a part of them.
const ROUNDING: f64 = 1e-9;

/// Whether accelerations at a sample are others so little later: they may be of the side behind a change already.
fn accelerations_jump<M: Mechanism>(motion: &Motion<M>, from: &Sample<M>, time: f64) -> bool {
    let later = State { time, ..from.state.clone() };
    let Ok(later) = motion.aside(|| motion.sample(later)) else { return true };
    let (before, after) = (&from.accelerations, &later.accelerations);
    let size = motion.size(before).max(motion.size(after));
    motion.size(&after.like(|j| after[j] - before[j])) > ROUNDING * size
}

/// The first change of form, however long the search for it is.
pub(super) fn first_known_change<M: Mechanism>(
    mechanism: &M,
    functions: &[Switching],
    now: f64,
    until: f64,
) -> Option<First> {
    let mut from = now;
    loop {
        match first_change(mechanism, functions, from, until)? {
            First { time, what: What::Middle | What::Flank | What::Unknown } => from = time,
            known => return Some(known),
        }
    }
}
