//! Into how many parts a step is divided to be searched: conditions that go to and fro need some for each time.

use super::EventSearch;
use super::conditions::{Point, conditions, value};
use super::held::is_held;
use super::onset::{OFFSET, sizes as all_sizes, terms};
use crate::integrate::Step;
use crate::state::failure::Failure;
use sim_kernel::{Array, Mechanism};

/// The largest change of the phase of a condition that goes to and fro in a part of a step.
const MOST_CHANGE: f64 = 1.0;
/// The largest number of parts by the rates of a condition, which are differences.
const MOST_PARTS_OF_A_WAVE: f64 = 1e4;
/// The number of further parts of a part from which it is divided again.
pub(super) const DIVIDED_AGAIN: f64 = 3.0;
/// The least size of a condition, relative to its terms, that goes to and fro: of rounding nothing is asked.
const LEAST_WAVE: f64 = 1e-6;

/// The least value that is not rounding, relative to the largest one, which is a millionth of the terms at least.
const LEAST_VALUE: f64 = 1e-9;

/// Where a step is looked into for what is but rounding, as parts of it, unlike those of any wave.
const INSIDE: [f64; 3] = [0.23, 0.51, 0.87];

impl<M: Mechanism> EventSearch<M> {
    /// Notes how large conditions are by their terms.
    pub(super) fn note_sizes(&mut self, step: &Step<M>) {
        let state = &step.from.state;
        let sizes = conditions(step.motion, state).and_then(|values| terms(step.motion, state, &values));
        if let Ok([sizes, _]) = sizes {
            self.largest = self.largest.like(|i| self.largest[i].max(LEAST_WAVE * sizes[i]));
        }
        if let Ok(sizes) = all_sizes(step.motion, step.from, self.span) {
            self.noise = sizes.like(|i| if sizes[i].is_finite() { OFFSET * sizes[i] } else { 0.0 });
        }
    }

    /// Notes which conditions are but rounding through a step, since constraints keep them at zero.
    pub(super) fn note_quiet(&mut self, step: &mut Step<M>, from: &Point<M>, to: &Point<M>) -> Result<(), Failure> {
        for event in 0..self.is_quiet.len() {
            let ends = from.values[event].abs().max(to.values[event].abs());
            self.is_quiet[event] = ends <= self.noise[event];
            for place in INSIDE {
                if !self.is_quiet[event] {
                    break;
                }
                let inside = value(step, from.time + place * (to.time - from.time), event)?;
                self.is_quiet[event] = inside.abs() <= self.noise[event];
            }
            self.is_quiet[event] = self.is_quiet[event] && is_held(step.motion, step.to, event);
        }
        Ok(())
    }

    /// The number of parts of an interval for the condition that changes fastest, and which that is. One that goes to and fro as
    /// A sin(w t) has everywhere between 0.78 w and w as the larger of |rate|/A and the root of |second rate|/A. So both ends say
    /// how fast it is; one may lie at a corner, where the second rate means nothing. Of one that decays A is not known, but w is also
    /// the root of |second rate|/|value|, where these are of unlike sign.
    pub(super) fn waves(&self, from: &Point<M>, to: &Point<M>) -> (f64, usize) {
        let h = to.time - from.time;
        let of = |event: usize| {
            let size = self.largest[event].max(from.values[event].abs()).max(to.values[event].abs());
            let fastest = |point: &Point<M>| {
                let [rate, second] = [point.rates[event], point.seconds[event]].map(|rate| rate.abs() / size);
                rate.max(second.sqrt())
            };
            let swings = |point: &Point<M>| match point.values[event] {
                value if value.abs() > LEAST_VALUE * size => (-point.seconds[event] / value).max(0.0).sqrt(),
                _ => 0.0,
            };
            let fast = (fastest(from) * fastest(to)).sqrt().max(swings(from).min(swings(to)));
            ((h * fast / MOST_CHANGE).ceil(), event)
        };
        let all =
            (0..self.begin.len()).filter(|event| !self.is_quiet[*event]).map(of).filter(|(parts, _)| parts.is_finite());
        let (most, event) = all.fold((1.0, 0), |most, of| if of.0 > most.0 { of } else { most });
        (most.min(MOST_PARTS_OF_A_WAVE), event)
    }
}

/// The conditions at a time inside a step, for a search over such an interval.
pub(super) fn point<M: Mechanism>(step: &mut Step<M>, time: f64, interval: f64) -> Result<Point<M>, Failure> {
    let sample = step.sample(time)?;
    Point::of(step.motion, &sample, interval)
}
