//! Conditions that are undefined in a part of the motion, as `sqrt(x) = 0.3` where x is below 0: searched up to where they are.

use super::EventSearch;
use super::conditions::{Point, may_reach_zero, value};
use super::waves::point;
use crate::integrate::Step;
use crate::numerics::signs::crosses;
use crate::state::failure::Failure;
use sim_kernel::Mechanism;

/// The number of halvings of a part at whose ends a condition is undefined, in which it may be defined.
const HALVINGS_BETWEEN: usize = 3;

/// Whether a condition is defined at both ends of a part.
pub(super) fn is_defined<M: Mechanism>(event: usize, from: &Point<M>, to: &Point<M>) -> bool {
    (from.values[event] + to.values[event]).is_finite()
}

impl<M: Mechanism> EventSearch<M> {
    /// Searches a part for an event whose condition may be undefined in it.
    pub(super) fn search_defined(
        &mut self,
        step: &mut Step<M>,
        event: usize,
        from: &Point<M>,
        to: &Point<M>,
        halvings: usize,
    ) -> Result<(), Failure> {
        match [from, to].map(|end| end.values[event].is_finite()) {
            [true, true] if may_reach_zero(event, from, to) => self.search_one(step, event, from, to, halvings),
            [true, true] => Ok(()),
            [true, false] => self.search_up_to_border(step, event, from, to.time, halvings),
            [false, true] => self.search_up_to_border(step, event, to, from.time, halvings),
            [false, false] => {
                self.search_between_undefined(step, event, [from.time, to.time], halvings.min(HALVINGS_BETWEEN))
            }
        }
    }

    /// Searches from a point at which a condition is defined towards a time at which it is not. Rates mean nothing close to the
    /// border, so the rest is searched by values alone.
    fn search_up_to_border(
        &mut self,
        step: &mut Step<M>,
        event: usize,
        from: &Point<M>,
        undefined: f64,
        halvings: usize,
    ) -> Result<(), Failure> {
        let border = border(step, event, [from.time, undefined])?;
        let mut from = from.clone();
        for halvings in (0..halvings).rev() {
            let rest = border - from.time;
            let middle = point(step, from.time + rest / 2.0, rest.abs() / 2.0)?;
            if !is_defined(event, &from, &middle) || !middle.rates[event].is_finite() {
                break;
            }
            let (first, second) = if rest < 0.0 { (&middle, &from) } else { (&from, &middle) };
            if may_reach_zero(event, first, second) {
                self.search_one(step, event, first, second, halvings)?;
            }
            from = middle;
        }
        let (mut times, mut values) = ([from.time, border], [from.values[event], value(step, border, event)?]);
        if times[1] < times[0] {
            times.reverse();
            values.reverse();
        }
        if crosses(values) { self.locate(step, event, times, values) } else { Ok(()) }
    }

    /// Searches for times at which a condition is defined between two at which it is not.
    fn search_between_undefined(
        &mut self,
        step: &mut Step<M>,
        event: usize,
        [from, to]: [f64; 2],
        halvings: usize,
    ) -> Result<(), Failure> {
        let half = (to - from) / 2.0;
        let middle = point(step, from + half, half)?;
        if middle.values[event].is_finite() {
            self.search_up_to_border(step, event, &middle, from, halvings)?;
            return self.search_up_to_border(step, event, &middle, to, halvings);
        }
        match halvings {
            0 => Ok(()),
            _ => [[from, middle.time], [middle.time, to]]
                .into_iter()
                .try_for_each(|half| self.search_between_undefined(step, event, half, halvings - 1)),
        }
    }
}

/// The last time, on the way from one at which a condition is defined to one at which it is not, at which it still is.
fn border<M: Mechanism>(
    step: &mut Step<M>,
    event: usize,
    [mut defined, mut undefined]: [f64; 2],
) -> Result<f64, Failure> {
    loop {
        let middle = defined + (undefined - defined) / 2.0;
        if middle == defined || middle == undefined {
            return Ok(defined);
        }
        let found = value(step, middle, event)?;
        if found.is_finite() { defined = middle } else { undefined = middle }
    }
}
