//! Times at which what acts on a mechanism changes its form, known before the motion is: conditions of `if`, `min`, `max`,
//! `abs` and `sign` that depend on time alone, and rows of tables of it.
//!
//! An adaptive step over a force that begins and ends within it might see nothing of it, and one over a jump is refused
//! many times. So steps end before such a time, and a step as short as rounding allows leads over it. A table is
//! continuous: its row itself is the end of a step. Equal steps stay equal; those that lead over such times are counted.

use crate::motion::Motion;
use crate::state::saved::{Bytes, Damaged};
use sim_kernel::{Mechanism, Switching};

/// Parts of a step in each of which a function of time is taken to change its sign at most once. One whose rate is
/// constant needs no parts.
const PARTS: usize = 32;

/// The distance from a time at which a function has the sign that it has on that side, in [`tick`]s: more than its
/// rounding.
const ASIDE: f64 = 4.0;

/// The least time that counts as later, near these times.
fn tick(now: f64, until: f64) -> f64 {
    4.0 * f64::EPSILON * now.abs().max(until.abs())
}

/// Where the next step ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Stop {
    /// At this time, before something changes or where a table has a row.
    Before(f64),
    /// At this time, after what changes between it and now.
    Across(f64),
}

/// The end that the first change of form after now puts to a step until this time.
#[inline]
pub(super) fn next_stop<M: Mechanism>(motion: &Motion<M>, now: f64, until: f64) -> Option<Stop> {
    let functions = motion.mechanism().description().switching;
    if functions.is_empty() { None } else { first_stop(motion, functions, now, until) }
}

#[cold]
fn first_stop<M: Mechanism>(motion: &Motion<M>, functions: &[Switching], now: f64, until: f64) -> Option<Stop> {
    let (time, is_row) = first_change(motion, functions, now, until)?;
    Some(stop(now, time, is_row, tick(now, until)))
}

/// The time of the first change of form after now, and whether it is the row of a table.
fn first_change<M: Mechanism>(
    motion: &Motion<M>,
    functions: &[Switching],
    now: f64,
    until: f64,
) -> Option<(f64, bool)> {
    let tick = tick(now, until);
    let (begin, values) = (now + tick, |time: f64| motion.mechanism().switching_functions(time));
    let parts = if functions.iter().all(|function| function.is_affine) { 1 } else { PARTS };
    let (mut from, mut before) = (begin, values(begin));
    for part in 1..=parts {
        let to = if part == parts { until } else { begin + (until - begin) * (part as f64 / parts as f64) };
        let after = values(to);
        let changes = functions.iter().enumerate().filter_map(|(k, function)| {
            let change = Change { function, ends: [from, to], values: [before[k], after[k]] };
            change.time(|time| values(time)[k], tick).map(|time| (time, function.table.is_some()))
        });
        if let Some(first) = changes.min_by(|a, b| a.0.total_cmp(&b.0)) {
            return Some(first);
        }
        (from, before) = (to, after);
    }
    None
}

/// The stop that a change at a time asks for.
fn stop(now: f64, time: f64, is_row: bool, tick: f64) -> Stop {
    match time - ASIDE * tick {
        _ if is_row => Stop::Before(time),
        before if before > now + tick => Stop::Before(before),
        _ => Stop::Across(time + ASIDE * tick),
    }
}

/// What may change between two times.
struct Change<'a> {
    function: &'a Switching,
    ends: [f64; 2],
    values: [f64; 2],
}

impl Change<'_> {
    /// What a value has in common with those up to the next change: its sign, or the next row.
    fn form(&self, value: f64) -> f64 {
        match self.function.table {
            Some(table) => table.next_row(value),
            None => f64::from(i8::from(value > 0.0) - i8::from(value < 0.0)),
        }
    }

    /// The time of the first change, if there is one.
    fn time(&self, value: impl Fn(f64) -> f64, tick: f64) -> Option<f64> {
        let ([mut from, mut to], [first, last]) = (self.ends, self.values);
        let form = self.form(first);
        if form == self.form(last) || !(to > from) {
            return None;
        }
        let level = if self.function.table.is_some() { form } else { 0.0 };
        if self.function.is_affine && (first - level) * (last - level) <= 0.0 {
            return Some(from + (to - from) * ((level - first) / (last - first)));
        }
        while to - from > tick {
            let middle = from + (to - from) / 2.0;
            let is_before = self.form(value(middle)) == form;
            (from, to) = if is_before { (middle, to) } else { (from, middle) };
        }
        Some(to)
    }
}

/// Equal steps that led over sudden changes of what acts on the mechanism: they are less accurate, and do not see what begins
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
    pub(super) fn transfer(changes: &mut Option<SuddenChanges>, bytes: &mut Bytes) -> Result<(), Damaged> {
        let none = || SuddenChanges { steps: 0, first: 0.0, until: 0.0 };
        bytes.option(changes, none, |bytes, SuddenChanges { steps, first, until }| {
            bytes.tally(steps)?;
            bytes.number(first)?;
            bytes.number(until)
        })
    }
}

/// Counts an equal step from now until a time, if it leads over a sudden change.
#[inline]
pub(super) fn note_change<M: Mechanism>(
    motion: &Motion<M>,
    [now, until]: [f64; 2],
    changes: &mut Option<SuddenChanges>,
) {
    let functions = motion.mechanism().description().switching;
    if functions.is_empty() {
        return;
    }
    let Some(first) = sudden_change(motion, functions, now, until) else { return };
    let changes = changes.get_or_insert(SuddenChanges { steps: 0, first, until: f64::NEG_INFINITY });
    // An event within a step ends it, and another begins.
    if changes.until < until {
        *changes = SuddenChanges { steps: changes.steps + 1, until, ..*changes };
    }
}

/// The time of the first change within a step that may not see it. Tables are continuous: of these what lies between two rows
/// may not be seen.
#[cold]
fn sudden_change<M: Mechanism>(motion: &Motion<M>, functions: &[Switching], now: f64, until: f64) -> Option<f64> {
    let (time, is_row) = first_change(motion, functions, now, until)?;
    match is_row {
        true => first_change(motion, functions, time, until).map(|_| time),
        false => Some(time),
    }
}
