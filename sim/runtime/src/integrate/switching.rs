//! Times at which what acts on a mechanism changes its form, known before the motion is: conditions of `if`, `min`, `max`,
//! `abs` and `sign` that depend on time alone, and rows of tables of it.
//!
//! An adaptive step over a force that begins and ends within it might see nothing of it, and one over a jump is refused
//! many times. So steps end before such a time, and a step as short as rounding allows leads over it. A table is
//! continuous: its row itself is the end of a step, and so is the middle of a smooth pulse. But where a table moves a mass, its
//! second derivative acts, which may jump at a row. Equal steps stay equal; those that lead over such times are counted, as are
//! those over changes by positions and speeds and over short pulses ([`super::jumps_of_loads`]).

use super::changes_in_time::{ASIDE, FARTHER, First, What, first_change, stays, tick};
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

/// The end that the first change of form after this puts to a step until this time. All rows may be known to be jumps; otherwise
/// those are, at which accelerations or the power jump.
#[inline]
pub(super) fn next_stop<M: Mechanism>(
    motion: &Motion<M>,
    from: &Sample<M>,
    interval: [f64; 2],
    rows_jump: bool,
) -> Option<Stop> {
    let functions = motion.mechanism().description().switching;
    if functions.is_empty() { None } else { first_stop(motion, functions, (from, interval), rows_jump) }
}

#[cold]
fn first_stop<M: Mechanism>(
    motion: &Motion<M>,
    functions: &[Switching],
    (from, [now, until]): (&Sample<M>, [f64; 2]),
    rows_jump: bool,
) -> Option<Stop> {
    let tick = tick(now, until);
    let First { time, what } = first_change(motion.mechanism(), functions, now, until)?;
    Some(match what {
        What::Row if !rows_jump && !is_jump(motion, from, time, [now, until]) => Stop::Before(time),
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
        What::Row if is_jump(motion, from, time, [now, until]) => Some(time),
        What::Row => known(time).map(|_| time),
        What::Zero | What::Middle | What::Flank | What::Unknown => Some(time),
    }
}

/// A difference of accelerations that is rounding, as a part of them; and of the power.
const ROUNDING: f64 = 1e-9;

/// Whether accelerations at a sample are others so little later: they may be of the side behind a change already.
fn accelerations_jump<M: Mechanism>(motion: &Motion<M>, from: &Sample<M>, time: f64) -> bool {
    let Some(later) = at_time(motion, from, time) else { return true };
    let (before, after) = (&from.accelerations, &later.accelerations);
    let size = motion.size(before).max(motion.size(after));
    motion.size(&after.like(|j| after[j] - before[j])) > ROUNDING * size
}

/// A jump of accelerations that changes coordinates by less than this part of their scales within a step is rounding; so is one of
/// the power by as small a part of the kinetic energy with which they go so far.
const NOISE: f64 = 1e-12;

/// Whether accelerations or the power jump at a time in a step, as where a table moves a mass, in a state near it.
fn is_jump<M: Mechanism>(motion: &Motion<M>, from: &Sample<M>, time: f64, [now, until]: [f64; 2]) -> bool {
    let (aside, length) = (ASIDE * tick(now, until), until - now);
    let State { positions, .. } = &from.state;
    let energy = motion.mechanism().kinetic_energy(time, positions, motion.measures().coordinates());
    let floors = [NOISE / length.powi(2), NOISE * energy / length.powi(3)];
    let across = |aside: f64| -> Option<[[f64; 2]; 2]> {
        let [before, after] = [at_time(motion, from, time - aside)?, at_time(motion, from, time + aside)?];
        let power = [(after.power - before.power).abs(), before.power.abs().max(after.power.abs())];
        let (a, b) = (&before.accelerations, &after.accelerations);
        Some([[motion.size(&b.like(|j| b[j] - a[j])), motion.size(a).max(motion.size(b))], power])
    };
    let Some(near) = across(aside) else { return false };
    let differs = |k: usize| near[k][0] > ROUNDING * near[k][1] && near[k][0] > floors[k];
    if !(differs(0) || differs(1)) {
        return false;
    }
    let Some(far) = across(FARTHER * aside) else { return false };
    (0..2).any(|k| differs(k) && stays(near[k][0], far[k][0]))
}

/// Whether accelerations or the power jump at a row of a table within a step from a sample until a time.
pub(crate) fn leads_over_row_that_jumps<M: Mechanism>(motion: &Motion<M>, from: &Sample<M>, until: f64) -> bool {
    let (mechanism, begin) = (motion.mechanism(), from.state.time);
    let functions = mechanism.description().switching;
    let mut now = begin;
    while let Some(First { time, what }) = first_known_change(mechanism, functions, now, until) {
        if what == What::Row && is_jump(motion, from, time, [begin, until]) {
            return true;
        }
        now = time;
    }
    false
}

/// A sample with the same state at another time, if there is one.
fn at_time<M: Mechanism>(motion: &Motion<M>, from: &Sample<M>, time: f64) -> Option<Sample<M>> {
    motion.aside(|| motion.sample(State { time, ..from.state.clone() })).ok()
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
