//! The first change of form of functions of time alone: of the sign of a condition, or of the row of a table.
//!
//! Their bounds over an interval of time show where none changes, and those of their rates where each changes at most once; an
//! interval of which neither is known is halved (Moore, Kearfott, Cloud: Introduction to Interval Analysis, 2009, chapter 8).
//! So no change is missed, however short the time is until it is taken back.

use crate::model::exactly;
use sim_kernel::{Dual, Interval, Mechanism, Switching, SwitchingKind};

/// The most intervals of a search, and the least part of the whole that is then enough for a step: conditions that are zero
/// but for rounding keep none.
const MOST_INTERVALS: usize = 4096;
const LEAST_PART: f64 = 1e-6;
/// The number of parts of what is left, in each of which such a condition is taken to change at most once.
const PARTS: usize = 32;

/// The least time that counts as later, near these times.
pub(super) fn tick(now: f64, until: f64) -> f64 {
    4.0 * f64::EPSILON * now.abs().max(until.abs())
}

/// The distance from a time at which a function has the sign that it has on that side, in [`tick`]s: more than its
/// rounding.
pub(super) const ASIDE: f64 = 4.0;

/// How much farther from a time a difference is looked at once more, to tell a jump.
pub(crate) const FARTHER: f64 = 16.0;

/// Whether a difference near a time is that of a jump, beside the one so much farther away: one that is continuous becomes less in
/// proportion.
pub(crate) fn stays(near: f64, far: f64) -> bool {
    near > 0.5 * far
}

/// Whether a step between two times, in a motion until this end, is one of those that lead over a sudden change and nothing else.
pub(crate) fn leads_over_change([from, to]: [f64; 2], end: f64) -> bool {
    to - from <= 3.0 * ASIDE * tick(from, end)
}

/// Within this distance of its end a change counts as falling on the end of a step.
pub(crate) fn around_end([from, to]: [f64; 2]) -> f64 {
    // Steps look for changes farther ahead than they go.
    0.5 * ASIDE * tick(to, to + 4.0 * (to - from))
}

/// The first thing that is found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct First {
    pub(super) time: f64,
    pub(super) what: What,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum What {
    /// A function changes its sign.
    Zero,
    /// The argument of a table reaches the next row.
    Row,
    /// The middle of a smooth pulse is just passed.
    Middle,
    /// A flank of one is.
    Flank,
    /// Nothing changes before, and what comes then has not been searched.
    Unknown,
}

/// The first change of form after now: of a condition that is zero now too, as at a start at `t = 0`, or where an event has noted the
/// time.
pub(super) fn first_change<M: Mechanism>(
    mechanism: &M,
    functions: &[Switching],
    now: f64,
    until: f64,
) -> Option<First> {
    let tick = tick(now, until);
    let begin = now + tick;
    if changes_at_once(mechanism, functions, [now, begin]) {
        return Some(First { time: begin, what: What::Zero });
    }
    let search = Search { mechanism, functions, tick };
    match functions.iter().all(|function| function.is_affine) {
        true => search.change_between([begin, until]),
        false => search.halves([begin, until]),
    }
}

/// Whether a condition that may jump is zero at the first of these times and not at the second.
fn changes_at_once<M: Mechanism>(mechanism: &M, functions: &[Switching], times: [f64; 2]) -> bool {
    let [now, soon] = times.map(|time| mechanism.switching_functions(time));
    let jumps = |function: &Switching| function.table.is_none() && !function.kind.is_smooth();
    functions.iter().enumerate().any(|(k, function)| jumps(function) && now[k] == 0.0 && soon[k] != 0.0)
}

struct Search<'a, M> {
    mechanism: &'a M,
    functions: &'a [Switching],
    tick: f64,
}

impl<M: Mechanism> Search<'_, M> {
    /// The first change in an interval, by the bounds of its halves.
    fn halves(&self, [begin, until]: [f64; 2]) -> Option<First> {
        let bounded = self.mechanism.on(exactly);
        let is_doubtful = |from: f64, to: f64| {
            let bounds = bounded.switching_functions(Dual::variable(Interval::between(from, to)));
            self.functions.iter().zip(bounds.as_ref()).any(|(function, bounds)| is_doubtful(function, bounds))
        };
        let (mut from, mut ends, mut spent) = (begin, vec![until], 0);
        while let Some(to) = ends.pop() {
            if spent < MOST_INTERVALS && to - from > 2.0 * self.tick {
                spent += 1;
                if is_doubtful(from, to) {
                    ends.extend([to, from + (to - from) / 2.0]);
                    continue;
                }
            }
            if let Some(first) = self.change_between([from, to]) {
                return Some(first);
            }
            from = to;
            if spent == MOST_INTERVALS && !ends.is_empty() {
                return self.rest([begin, from, until]);
            }
        }
        None
    }

    /// What is known where the search has become too long.
    fn rest(&self, [begin, from, until]: [f64; 3]) -> Option<First> {
        if from - begin > LEAST_PART * (until - begin) {
            return Some(First { time: from, what: What::Unknown });
        }
        let end =
            |part: usize| if part == PARTS { until } else { from + (until - from) * (part as f64 / PARTS as f64) };
        (0..PARTS).find_map(|part| self.change_between([end(part), end(part + 1)]))
    }

    /// The first change between two times, of functions that change at most once.
    fn change_between(&self, ends: [f64; 2]) -> Option<First> {
        let values = |time: f64| self.mechanism.switching_functions(time);
        let [before, after] = ends.map(values);
        let changes = self.functions.iter().enumerate().filter_map(|(k, function)| {
            let change = Change { function, ends, values: [before[k], after[k]] };
            let time = change.time(|time| values(time)[k], self.tick)?;
            Some(match function.table {
                Some(_) => First { time, what: What::Row },
                None if function.kind == SwitchingKind::Flank => {
                    First { time: time + ASIDE * self.tick, what: What::Flank }
                }
                None if function.kind.is_smooth() => First { time: time + ASIDE * self.tick, what: What::Middle },
                None => First { time, what: What::Zero },
            })
        });
        changes.min_by(|a, b| a.time.total_cmp(&b.time))
    }
}

/// Whether a function with these bounds may change its form more than once.
fn is_doubtful(function: &Switching, bounds: &Dual<Interval>) -> bool {
    let Dual { value, derivative } = bounds;
    form(function, value.least()) != form(function, value.greatest()) && (value.jumps() || derivative.holds(0.0))
}

/// What a value has in common with those up to the next change: its sign, or the next row.
pub(crate) fn form(function: &Switching, value: f64) -> f64 {
    match function.table {
        Some(table) => table.next_row(value),
        None => f64::from(i8::from(value > 0.0) - i8::from(value < 0.0)),
    }
}

/// What may change between two times.
struct Change<'a> {
    function: &'a Switching,
    ends: [f64; 2],
    values: [f64; 2],
}

impl Change<'_> {
    /// The time of the first change, if there is one.
    fn time(&self, value: impl Fn(f64) -> f64, tick: f64) -> Option<f64> {
        let ([mut from, mut to], [first, last]) = (self.ends, self.values);
        let form = |value: f64| form(self.function, value);
        let begun = form(first);
        if begun == form(last) || !(to > from) {
            return None;
        }
        let level = if self.function.table.is_some() { begun } else { 0.0 };
        if self.function.is_affine && (first - level) * (last - level) <= 0.0 {
            return Some(from + (to - from) * ((level - first) / (last - first)));
        }
        while to - from > tick {
            let middle = from + (to - from) / 2.0;
            let is_before = form(value(middle)) == begun;
            (from, to) = if is_before { (middle, to) } else { (from, middle) };
        }
        Some(to)
    }
}
