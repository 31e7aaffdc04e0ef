//! Steps in which loads change their form.
//!
//! A load that begins and ends within a step, as a push at a certain angle of a wheel, may lie between all places at which the
//! method evaluates it. And what an estimate of the error says of a single change depends on where in the step it is: for some
//! places it is nothing. So a step with a change in it is repeated up to there. One that begins beside a change is repeated if
//! there is another one, up to between both: all methods with an estimate evaluate at the end, and see it.

use super::Step;
use super::better_end::better_end;
use super::change_of_load::{Change, merge};
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
        self.search_parts(|search| {
            let changes = search.changes_found()?;
            better_end(search.step, changes, tolerance)
        })
    }

    #[cold]
    fn changes(mut self) -> Result<Vec<Change>, Failure> {
        self.search_parts(|_| Ok(None::<()>))?;
        let mut changes = self.changes_found()?;
        merge(&mut changes, self.step.length());
        Ok(changes)
    }

    /// The changes found, in order. One stays found: what comes after it in the step is looked at beside it.
    fn changes_found(&mut self) -> Result<Vec<Change>, Failure> {
        let found = std::mem::take(&mut self.found);
        let mut changes = found.iter().map(|between| self.change(between)).collect::<Result<Vec<Change>, Failure>>()?;
        self.found.extend(found.into_iter().take(1));
        changes.sort_by(|a, b| a.time.total_cmp(&b.time));
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
