//! Steps in which loads change their form.
//!
//! A load that begins and ends within a step, as a push at a certain angle of a wheel, may lie between all places at which the
//! method evaluates it. And what an estimate of the error says of a single change depends on where in the step it is: for some
//! places it is nothing. So a step with a change in it is repeated up to there. One that begins beside a change is repeated if
//! there is another one, up to between both: all methods with an estimate evaluate at the end, and see it.
//!
//! Where accelerations jump at the change, an estimate is too small there too: where a jump lies before the second stage of dopri5,
//! by a factor of 75. But no method is wrong by more than the jump of the accelerations times the length of the step. So a step
//! over a jump is so short that this is a part of the tolerance, and steps come up to the jump until one that goes as far beyond
//! it is.
//!
//! The middle of a smooth pulse by positions is the end of a step, which sees it.

use super::Step;
use super::jump::{difference, is_pole, jump};
use super::step::{MOST_CHANGE, MOST_PARTS};
use super::table_rows::{is_gentle, levels};
use crate::numerics::root::{find_minimum, find_root};
use crate::numerics::signs::{crosses, is_foretold, may_reach_zero, turns_back};
use crate::state::failure::Failure;
use crate::state::settings::Tolerance;
use crate::state::trajectory::Sample;
use sim_kernel::{Array, Mechanism, Switching, SwitchingKind};

/// Rates are differences over this part of the interval that is searched.
const BESIDE: f64 = 1e-4;
/// The most parts of a step for conditions of the first degree in positions and speeds, which may be of a coordinate that goes to
/// infinity.
const MOST_AFFINE_PARTS: f64 = 1e3;
/// The number of halvings of a part of a step.
const MOST_HALVINGS: usize = 8;
/// A change of a coordinate, in its scale, that is rounding.
const NOISE: f64 = 1e-12;
/// Changes within this part of a step are one.
const SAME: f64 = 1e-9;
/// A step begins beside a change that is within this part of its length, and one that is to come up to a change ends before it by
/// this part.
const NEAR: f64 = 0.01;
/// The middle of a pulse is seen from an end of a step within this part of its length.
const SEEN: f64 = 1e-6;
/// The most that a step over a jump may be wrong by, in units of the tolerance: the jumps of a motion mostly go the same way.
const SLIGHT: f64 = 0.1;
/// A step of so many roundings of its time is not made shorter.
const SHORTEST: f64 = 64.0;

/// Where a step ends better in which loads change their form; nothing if they do not, or at its beginning alone.
///
/// # Errors
/// As the dense output.
#[inline]
pub(super) fn before_change<M: Mechanism>(step: &mut Step<M>, tolerance: &Tolerance) -> Result<Option<f64>, Failure> {
    let description = step.motion.mechanism().description();
    if !description.has_load_conditions() {
        return Ok(None);
    }
    Search::new(step, description.load_conditions).before_change(tolerance)
}

/// A change of form of a load within a step.
#[derive(Clone, Copy, Debug)]
pub(super) struct Change {
    /// Its time, in seconds.
    pub(super) time: f64,
    /// Whether it is a row of a table: there the load is continuous.
    pub(super) is_row: bool,
    /// Whether second derivatives are continuous too: what a step over one such row leads through, its ends have seen.
    is_gentle: bool,
    /// What is there.
    pub(super) kind: SwitchingKind,
}

/// The changes of form of loads within a step, and the middles of smooth pulses, in order; those at one time are one.
///
/// # Errors
/// As the dense output.
pub(super) fn changes<M: Mechanism>(step: &mut Step<M>) -> Result<Vec<Change>, Failure> {
    Search::new(step, step.motion.mechanism().description().load_conditions).changes()
}

/// A condition at both ends of an interval of time.
#[derive(Clone, Copy)]
struct Between {
    condition: usize,
    /// The value at which its load changes its form: 0, or a row of its table.
    level: f64,
    ends: [f64; 2],
    /// Its values less that.
    values: [f64; 2],
    /// Rates times the interval.
    changes: [f64; 2],
    /// Halves of their rates times its square.
    bends: [f64; 2],
}

impl Between {
    /// Whether the condition may be zero between the ends, by how it changes at both, and how its rate does: it may go to and fro.
    fn may_reach_zero(&self) -> bool {
        let most = |i: usize| self.changes[i].abs().max(self.bends[i].abs());
        may_reach_zero(self.values, [most(0), most(1)])
    }
}

struct Search<'a, 's, M: Mechanism> {
    step: &'a mut Step<'s, M>,
    conditions: &'static [Switching],
    /// Where conditions change their signs, each once.
    found: Vec<Between>,
}

/// The conditions at a time, their rates, and the rates of these.
struct Look<M: Mechanism> {
    time: f64,
    values: M::LoadConditions,
    rates: M::LoadConditions,
    seconds: M::LoadConditions,
}

impl<'a, 's, M: Mechanism> Search<'a, 's, M> {
    fn new(step: &'a mut Step<'s, M>, conditions: &'static [Switching]) -> Search<'a, 's, M> {
        Search { step, conditions, found: Vec::new() }
    }

    #[cold]
    fn before_change(mut self, tolerance: &Tolerance) -> Result<Option<f64>, Failure> {
        self.search_parts(|search| search.better_end(tolerance))
    }

    #[cold]
    fn changes(mut self) -> Result<Vec<Change>, Failure> {
        self.search_parts(|_| Ok(None::<()>))?;
        let found = std::mem::take(&mut self.found);
        let mut changes = found.iter().map(|between| self.change(between)).collect::<Result<Vec<Change>, Failure>>()?;
        changes.sort_by(|a, b| a.time.total_cmp(&b.time));
        let least = SAME * self.step.length();
        changes.dedup_by(|next, kept| {
            let is_same = next.time - kept.time <= least && next.kind == kept.kind;
            kept.is_row &= next.is_row || !is_same;
            is_same
        });
        Ok(changes)
    }

    /// Into how many parts a step is divided at most. Turns count where conditions are periodic in them.
    fn most_parts(&self) -> f64 {
        let searched = || self.conditions.iter().filter(|condition| condition.kind.is_of_loads());
        match () {
            // A pole is not passed to and fro.
            _ if searched().all(|condition| condition.kind == SwitchingKind::Pole) => 1.0,
            _ if searched().all(|condition| condition.is_affine) => MOST_AFFINE_PARTS,
            _ => f64::INFINITY,
        }
    }

    /// Into how many parts it is divided for the phases of its conditions, by their changes and by their rates at both ends.
    fn parts_by_phases(&self) -> f64 {
        let phases = || (0..self.conditions.len()).filter(|k| self.conditions[*k].kind == SwitchingKind::Phase);
        if phases().next().is_none() {
            return 1.0;
        }
        let length = self.step.length();
        let [from, to] = [self.step.from, self.step.to].map(|sample| self.look(sample, length));
        let change = |k: usize| {
            let by_rates = [&from, &to].map(|look| (length * look.rates[k]).abs());
            (to.values[k] - from.values[k]).abs().max(by_rates[0]).max(by_rates[1])
        };
        let parts = (phases().map(change).fold(0.0, f64::max) / MOST_CHANGE).ceil();
        if parts >= 1.0 { parts.min(MOST_PARTS) } else { 1.0 }
    }

    /// Searches all parts of the step in turn; where changes have been found, until something comes of them.
    fn search_parts<T>(
        &mut self,
        mut come_of: impl FnMut(&mut Self) -> Result<Option<T>, Failure>,
    ) -> Result<Option<T>, Failure> {
        let [begin, end] = [self.step.from, self.step.to].map(|sample| sample.state.time);
        let parts = self.step.parts_by_angles().max(self.parts_by_phases()).min(self.most_parts());
        let length = (end - begin) / parts;
        let mut from = self.look(self.step.from, length);
        for part in 1..=parts as usize {
            let is_last = part == parts as usize;
            let time = if is_last { end } else { begin + part as f64 * length };
            let sample = self.step.sample(time)?;
            let to = self.look(&sample, length);
            for condition in (0..self.conditions.len()).filter(|k| self.conditions[*k].kind.is_of_loads()) {
                self.search_part(condition, [&from, &to])?;
            }
            if !self.found.is_empty()
                && let Some(found) = come_of(self)?
            {
                return Ok(Some(found));
            }
            from = to;
        }
        Ok(None)
    }

    /// Searches a part of the step for the changes by one condition.
    fn search_part(&mut self, condition: usize, [from, to]: [&Look<M>; 2]) -> Result<(), Failure> {
        let values = [from, to].map(|look| look.values[condition]);
        let h = to.time - from.time;
        for level in levels(&self.conditions[condition], values) {
            let between = Between {
                condition,
                level,
                ends: [from.time, to.time],
                values: values.map(|value| value - level),
                changes: [from, to].map(|look| h * look.rates[condition]),
                bends: [from, to].map(|look| h * h / 2.0 * look.seconds[condition]),
            };
            // A condition that is rounding, as a speed that dry friction holds at zero, tells nothing.
            if between.may_reach_zero() && !self.is_noise(&between) {
                self.search(between, MOST_HALVINGS)?;
            }
        }
        Ok(())
    }

    fn look(&self, sample: &Sample<M>, interval: f64) -> Look<M> {
        let (state, rates, d) = (&sample.state, sample.rates(), BESIDE * interval);
        let conditions = |d: f64| {
            let moved = state.changed(state.time + d, d, &rates);
            self.step.motion.mechanism().load_conditions(moved.time, &moved.positions, &moved.speeds)
        };
        let [behind, values, ahead] = [-d, 0.0, d].map(conditions);
        Look {
            time: state.time,
            rates: values.like(|i| (ahead[i] - behind[i]) / (2.0 * d)),
            seconds: values.like(|i| (ahead[i] - 2.0 * values[i] + behind[i]) / (d * d)),
            values,
        }
    }

    /// The value of a condition at a fraction of an interval, less its level.
    fn value(&mut self, between: &Between, fraction: f64) -> Result<f64, Failure> {
        let [from, to] = between.ends;
        let state = self.step.at(from + fraction * (to - from))?;
        let mechanism = self.step.motion.mechanism();
        Ok(mechanism.load_conditions(state.time, &state.positions, &state.speeds)[between.condition] - between.level)
    }

    /// Finds changes of sign in an interval; where the cubic of its ends does not foretell the condition, in both halves.
    fn search(&mut self, between: Between, halvings: usize) -> Result<(), Failure> {
        let Between { values, changes, .. } = between;
        match () {
            _ if !between.may_reach_zero() => Ok(()),
            _ if halvings > 0
                && !is_foretold(values, changes, 0.0, &mut |fraction| self.value(&between, fraction))? =>
            {
                let halves = self.halves(&between)?;
                halves.into_iter().try_for_each(|half| self.search(half, halvings - 1))
            }
            _ if crosses(values) => {
                self.note(between);
                Ok(())
            }
            _ if turns_back(values, changes) => self.turn(between),
            _ => Ok(()),
        }
    }

    /// Both halves of an interval.
    fn halves(&mut self, between: &Between) -> Result<[Between; 2], Failure> {
        let Between { condition, level, ends: [from, to], values, changes, bends } = *between;
        let half = (to - from) / 2.0;
        let sample = self.step.sample(from + half)?;
        let look = self.look(&sample, half);
        let (value, change) = (look.values[condition] - level, half * look.rates[condition]);
        let bend = half * half / 2.0 * look.seconds[condition];
        let part = |ends, values, changes, bends| Between { condition, level, ends, values, changes, bends };
        Ok([
            part([from, look.time], [values[0], value], [changes[0] / 2.0, change], [bends[0] / 4.0, bend]),
            part([look.time, to], [value, values[1]], [change, changes[1] / 2.0], [bend, bends[1] / 4.0]),
        ])
    }

    /// A condition that heads for zero at both ends: twice through it, or not at all.
    fn turn(&mut self, between: Between) -> Result<(), Failure> {
        let Between { ends: [from, to], values, .. } = between;
        let sign = values[0].signum();
        let (fraction, least) = find_minimum(&mut |fraction| Ok(sign * self.value(&between, fraction)?))?;
        if least < 0.0 {
            let (turn, value) = (from + fraction * (to - from), sign * least);
            self.note(Between { ends: [from, turn], values: [values[0], value], ..between });
            self.note(Between { ends: [turn, to], values: [value, values[1]], ..between });
        }
        Ok(())
    }

    /// Notes a change of sign, unless it is rounding.
    fn note(&mut self, between: Between) {
        if !self.is_noise(&between) {
            self.found.push(between);
        }
    }

    fn is_noise(&self, between: &Between) -> bool {
        let noise = self.noise(between.condition);
        between.values.iter().all(|value| value.abs() <= noise)
    }

    /// How much rounding of the state may change a condition: of positions, and of speeds that change these as much in the step.
    fn noise(&self, condition: usize) -> f64 {
        let (motion, state) = (self.step.motion, &self.step.to.state);
        let scales = motion.measures().coordinates();
        let value = |positions: &M::Q, speeds: &M::Q| {
            motion.mechanism().load_conditions(state.time, positions, speeds)[condition]
        };
        let (now, length) = (value(&state.positions, &state.speeds), self.step.length());
        let of = |j: usize| {
            let beside = |of: &M::Q, by: f64| of.like(|i| if i == j { of[i] + by } else { of[i] });
            let by = NOISE * scales[j];
            let moved = value(&beside(&state.positions, by), &state.speeds) - now;
            let faster = value(&state.positions, &beside(&state.speeds, by / length)) - now;
            moved.abs() + faster.abs()
        };
        (0..scales.len()).map(of).sum()
    }

    /// Up to the first change, or between that and the next one.
    fn better_end(&mut self, tolerance: &Tolerance) -> Result<Option<f64>, Failure> {
        let (begin, length) = (self.step.from.state.time, self.step.length());
        let found = std::mem::take(&mut self.found);
        let mut changes = found.iter().map(|between| self.change(between)).collect::<Result<Vec<Change>, Failure>>()?;
        self.found.extend(found.into_iter().take(1));
        changes.sort_by(|a, b| a.time.total_cmp(&b.time));
        let unseen = (begin + SEEN * length)..(self.step.to.state.time - SEEN * length);
        changes.retain(|change| !change.kind.is_smooth() || unseen.contains(&change.time));
        let is_long = length > SHORTEST * f64::EPSILON * begin.abs();
        let middle = changes.iter().find(|change| change.kind.is_smooth() && is_long).map(|change| change.time);
        changes.retain(|change| !change.kind.is_smooth());
        if matches!(changes.as_slice(), [only] if only.is_gentle) {
            return Ok(middle);
        }
        match changes.first().copied() {
            Some(first) if middle.is_none_or(|middle| first.time < middle) => {
                Ok(self.end_before(first, &changes, tolerance)?.or(middle))
            }
            _ => Ok(middle),
        }
    }

    /// The better end of a step in which loads change their form, at first here. Several conditions may say the same.
    fn end_before(&mut self, first: Change, changes: &[Change], tolerance: &Tolerance) -> Result<Option<f64>, Failure> {
        let (begin, length) = (self.step.from.state.time, self.step.length());
        let apart = SAME * length;
        let second = changes.iter().find(|change| change.time - first.time > apart).map(|change| change.time);
        let between = second.map(|second| first.time + (second - first.time) / 2.0);
        let distance = first.time - begin;
        let before = first.time - NEAR * distance;
        let jump = match changes.iter().all(|change| change.is_row || change.time - first.time > apart) {
            true => None,
            false => self.jump_at(first.time, between.unwrap_or(self.step.to.state.time))?,
        };
        let error = |length: f64| jump.as_ref().map_or(0.0, |jump| self.error_over(jump, length, tolerance));
        let [bound, of_crossing] = [length, 2.0 * distance].map(error);
        let is_there = |change: &Change| change.time - first.time <= apart;
        let is_at_pole = changes.iter().any(|change| change.kind == SwitchingKind::Pole && is_there(change));
        Ok(match () {
            _ if length <= SHORTEST * f64::EPSILON * begin.abs() => None,
            _ if is_at_pole && is_pole(self.step, first.time, distance) => Some(before),
            _ if jump.is_some() && between.is_none() && bound <= SLIGHT => None,
            _ if distance > NEAR * length => Some(before),
            _ if jump.is_none() => between,
            _ if of_crossing <= SLIGHT => Some(between.unwrap_or(f64::INFINITY).min(first.time + distance)),
            _ => Some(before),
        })
    }

    /// The jump of accelerations at a change, before which nothing else changes in the step, and after it nothing until a time.
    fn jump_at(&mut self, time: f64, until: f64) -> Result<Option<M::Q>, Failure> {
        let beside = (time - self.step.from.state.time).min(until - time) / 2.0;
        if beside > 0.0 { Ok(jump(self.step, time, beside)?.as_ref().map(difference)) } else { Ok(None) }
    }

    /// The most that a step of a length over a jump is wrong by, in units of the tolerance.
    fn error_over(&self, jump: &M::Q, length: f64, tolerance: &Tolerance) -> f64 {
        let [from, to] = [self.step.from, self.step.to].map(|sample| &sample.state);
        let [of_positions, of_speeds] = [length * length / 2.0, length].map(|factor| jump.like(|i| factor * jump[i]));
        tolerance.norm(self.step.motion.measures(), from, to, [&of_positions, &of_speeds])
    }

    fn change(&mut self, between: &Between) -> Result<Change, Failure> {
        let Switching { table, kind, .. } = self.conditions[between.condition];
        let is_gentle = table.is_some_and(|table| is_gentle(table, between.level));
        Ok(Change { time: self.locate(between)?, is_row: table.is_some(), is_gentle, kind })
    }

    /// The time of a change, to a small part of the step.
    fn locate(&mut self, between: &Between) -> Result<f64, Failure> {
        let Between { ends: [from, to], values, .. } = *between;
        let tolerance = NOISE * self.step.length() / (to - from);
        let fraction = find_root(values[0], values[1], tolerance, &mut |fraction| self.value(between, fraction))?;
        Ok(from + fraction * (to - from))
    }
}
