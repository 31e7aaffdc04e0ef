//! Where a condition is zero in a part of a step.

use super::conditions::{Point, conditions, ends, tolerance, value};
use super::described::releases;
use super::onset::sizes;
use super::{Crossing, EventSearch, Occurrence};
use crate::integrate::Step;
use crate::numerics::root::{find_minimum, find_root};
use crate::numerics::signs::{crosses, is_foretold, turns_back};
use crate::state::failure::Failure;
use crate::state::trajectory::State;
use sim_kernel::Mechanism;
use sim_kernel::event::Direction;

/// How close to zero, relative to its largest value, a condition has to turn to touch it.
const TOUCH: f64 = 1e-9;

/// How far beyond zero, relative to its terms there, a condition is through it.
const THROUGH: f64 = 1e-10;
/// Touches within this part of an interval in which a condition touches zero once, or of a second, are the same.
const SAME_TOUCH: f64 = 1e-3;
const SAME_TIME: f64 = 1e-7;

/// Whether a condition touches zero at the end of a part, to rounding: it is larger on both sides.
fn touches_at_end<M: Mechanism>(event: usize, from: &Point<M>, to: &Point<M>) -> bool {
    let (sign, value, beside) = (from.values[event].signum(), to.values[event], to.beside(event));
    let is_beyond = |change: f64| sign * change > 0.0 && value.abs() <= TOUCH * change.abs();
    from.values[event] != 0.0 && beside.into_iter().all(is_beyond)
}

impl<M: Mechanism> EventSearch<M> {
    /// Searches a part for one event; where the cubic of its ends does not foretell the condition, both halves of it, so often.
    pub(super) fn search_one(
        &mut self,
        step: &mut Step<M>,
        event: usize,
        from: &Point<M>,
        to: &Point<M>,
        halvings: usize,
    ) -> Result<(), Failure> {
        let h = to.time - from.time;
        let (values, rates) = ends(event, from, to);
        let mut inside = |fraction: f64| value(step, from.time + fraction * h, event);
        if halvings > 0 && !is_foretold(values, rates, TOUCH * self.largest[event], &mut inside)? {
            let middle = step.sample(from.time + h / 2.0)?;
            let middle = Point::of(step.motion, &middle, h / 2.0)?;
            self.search_defined(step, event, from, &middle, halvings - 1)?;
            return self.search_defined(step, event, &middle, to, halvings - 1);
        }
        match () {
            _ if touches_at_end(event, from, to) => {
                let state = step.at(to.time)?;
                self.push_touch(step, event, state, h);
                Ok(())
            }
            _ if crosses(values) => self.locate(step, event, [from.time, to.time], values),
            _ if turns_back(values, rates) => self.touch(step, event, [from.time, to.time], values),
            _ => Ok(()),
        }
    }

    /// A condition that heads for zero at both ends: twice through it, touching it, or missing it.
    fn touch(
        &mut self,
        step: &mut Step<M>,
        event: usize,
        [from, to]: [f64; 2],
        values: [f64; 2],
    ) -> Result<(), Failure> {
        let sign = values[0].signum();
        let (fraction, least) =
            find_minimum(&mut |fraction| Ok(sign * value(step, from + fraction * (to - from), event)?))?;
        let turn = from + fraction * (to - from);
        if least < -TOUCH * self.largest[event] || (least < 0.0 && self.is_through(step, event, turn, least)?) {
            self.locate(step, event, [from, turn], [values[0], sign * least])?;
            return self.locate(step, event, [turn, to], [sign * least, values[1]]);
        }
        if least.abs() <= TOUCH * self.largest[event] {
            let state = step.at(turn)?;
            self.push_touch(step, event, state, to - from);
        }
        Ok(())
    }

    /// Whether a condition that turns so far beyond zero is through it, and has not only touched it up to the accuracy of the
    /// motion: where its terms cancel, it is known better than its largest value tells.
    fn is_through(&self, step: &mut Step<M>, event: usize, turn: f64, least: f64) -> Result<bool, Failure> {
        let sample = step.sample(turn)?;
        Ok(least < -THROUGH * sizes(step.motion, &sample, self.span)?[event])
    }

    /// Enters a touch within a part of such a length, unless it is the same as the last, which is known to the root of rounding.
    fn push_touch(&mut self, step: &Step<M>, event: usize, state: State<M>, part: f64) {
        // Those of a wave are several parts apart.
        let same = (SAME_TOUCH * part).max((SAME_TIME * self.span.min(1.0)).min(part / 2.0));
        let last = self.found.iter().rev().find(|found| found.event == event);
        let is_same =
            |last: &Occurrence<M>| last.crossing == Crossing::Touching && state.time - last.state.time <= same;
        if !last.is_some_and(is_same) {
            self.push(step.motion.mechanism(), event, Crossing::Touching, state);
        }
    }

    pub(super) fn locate(
        &mut self,
        step: &mut Step<M>,
        event: usize,
        [from, to]: [f64; 2],
        values: [f64; 2],
    ) -> Result<(), Failure> {
        let (h, tolerance) = (to - from, tolerance(to, self.span));
        // A condition may stay at zero, as the force of a one-sided spring: it happens where zero is reached.
        let past = |value: f64| if value == 0.0 { -f64::MIN_POSITIVE.copysign(values[0]) } else { value };
        let stays = values[1] == 0.0 && h > 2.0 * tolerance && value(step, to - 2.0 * tolerance, event)? == 0.0;
        let time = match values[1] == 0.0 && !stays {
            true => to,
            false => {
                let mut at = |fraction: f64| value(step, from + fraction * h, event).map(past);
                from + h * find_root(values[0], past(values[1]), tolerance / h, &mut at)?
            }
        };
        let state = step.at(time)?;
        let crossing = if values[0] < 0.0 { Crossing::Rising } else { Crossing::Falling };
        let mechanism = step.motion.mechanism();
        let counts_jumps = releases(&mechanism.description().events[event]);
        let found = conditions(step.motion, &state)?[event];
        // It kept its sign while it was no more than noise, and has left it on the other side.
        let is_noise = self.onset.as_ref().is_some_and(|onset| found.abs() <= onset.noise[event]);
        if counts_jumps || is_noise || !self.is_jump(step, event, time, [found, values[0], values[1]])? {
            self.push(mechanism, event, crossing, state);
        }
        Ok(())
    }

    /// Enters the time at which a condition that was zero goes beyond a value.
    pub(super) fn locate_leaving(
        &mut self,
        step: &mut Step<M>,
        event: usize,
        [from, to]: [f64; 2],
        beyond: f64,
    ) -> Result<(), Failure> {
        let (h, tolerance) = (to - from, tolerance(to, self.span));
        let mut at = |fraction: f64| value(step, from + fraction * h, event).map(|value| value / beyond - 1.0);
        let last = at(1.0)?;
        let fraction = find_root(-1.0, last, tolerance / h, &mut at)?;
        let state = step.at(from + h * fraction)?;
        let crossing = if beyond > 0.0 { Crossing::Rising } else { Crossing::Falling };
        self.push(step.motion.mechanism(), event, crossing, state);
        Ok(())
    }

    fn push(&mut self, mechanism: &M, event: usize, crossing: Crossing, state: State<M>) {
        let described = &mechanism.description().events[event];
        let counts = match described.direction {
            Direction::Both => true,
            Direction::Rising => crossing == Crossing::Rising,
            Direction::Falling => crossing == Crossing::Falling,
        };
        let is_after_start = state.time - self.begin[event] > 2.0 * tolerance(state.time, self.span);
        let occurrence = Occurrence { event, name: described.name, crossing, state, change: None };
        match (counts, is_after_start) {
            (true, true) => self.found.push(occurrence),
            (true, false) => self.at_start = Some(occurrence),
            (false, _) => {}
        }
    }
}
