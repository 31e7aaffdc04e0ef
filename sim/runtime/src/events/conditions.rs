//! The conditions of events at one time, and the crossings between two times.

use crate::integrate::Step;
use crate::motion::Motion;
use crate::numerics::signs;
use crate::state::failure::Failure;
use crate::state::saved::{Bytes, Damaged};
use crate::state::trajectory::{Sample, State};
use sim_kernel::event::Event;
use sim_kernel::{Array, Mechanism};

/// An interval this much shorter than another has rates of its own.
const SHORTER: f64 = 1e-3;

/// Rates are differences over this part of an interval.
const PART: f64 = 1e-4;

/// The conditions at one time.
#[derive(Clone, Debug)]
pub(super) struct Point<M: Mechanism> {
    pub(super) time: f64,
    pub(super) values: M::Events,
    /// The rates of the values in time, and their rates.
    pub(super) rates: M::Events,
    pub(super) seconds: M::Events,
    /// The interval that they are differences for, in seconds.
    interval: f64,
}

/// The value of a condition at a time inside a step.
pub(super) fn value<M: Mechanism>(step: &mut Step<M>, time: f64, event: usize) -> Result<f64, Failure> {
    let state = step.at(time)?;
    Ok(conditions(step.motion, &state)?[event])
}

/// Whether any condition depends on accelerations or multipliers.
#[inline(always)]
fn any_on_forces(events: &[Event]) -> bool {
    events.iter().any(|event| event.on_forces)
}

/// left - right of each event at a state; the equations of motion are solved only where one needs it.
pub(crate) fn conditions<M: Mechanism>(motion: &Motion<M>, state: &State<M>) -> Result<M::Events, Failure> {
    let (qdd, lambda) = match any_on_forces(motion.mechanism().description().events) {
        true => {
            let sample = motion.sample(state.clone())?;
            (sample.accelerations, sample.multipliers)
        }
        false => (state.positions.like(|_| 0.0), M::L::repeat(motion.mechanism().m(), 0.0)),
    };
    Ok(motion.mechanism().events(state.time, &state.positions, &state.speeds, &qdd, &lambda))
}

/// A state a little later or earlier, by constant accelerations.
pub(crate) fn moved<M: Mechanism>(sample: &Sample<M>, d: f64) -> State<M> {
    let state = &sample.state;
    State {
        time: state.time + d,
        positions: state
            .positions
            .like(|i| state.positions[i] + d * (state.speeds[i] + d / 2.0 * sample.accelerations[i])),
        speeds: state.speeds.like(|i| state.speeds[i] + d * sample.accelerations[i]),
        work: state.work,
    }
}

/// The same, with accelerations that change: those of there as well, where the equations of motion have them.
pub(super) fn bent<M: Mechanism>(motion: &Motion<M>, sample: &Sample<M>, d: f64) -> State<M> {
    let mut state = moved(sample, d);
    let Ok(there) = motion.sample(state.clone()) else { return state };
    let change = sample.accelerations.like(|i| there.accelerations[i] - sample.accelerations[i]);
    if change.iter().all(|change| change.is_finite()) {
        state.positions = state.positions.like(|i| state.positions[i] + d * d / 6.0 * change[i]);
        state.speeds = state.speeds.like(|i| state.speeds[i] + d / 2.0 * change[i]);
    }
    state
}

impl<M: Mechanism> Point<M> {
    /// None known yet.
    pub(super) fn blank(none: &M::Events) -> Point<M> {
        Point { time: 0.0, values: none.clone(), rates: none.clone(), seconds: none.clone(), interval: 0.0 }
    }

    /// All of it as bytes, or from them.
    pub(super) fn transfer(&mut self, bytes: &mut Bytes) -> Result<(), Damaged> {
        bytes.number(&mut self.time)?;
        bytes.numbers(self.values.as_mut())?;
        bytes.numbers(self.rates.as_mut())?;
        bytes.numbers(self.seconds.as_mut())?;
        bytes.number(&mut self.interval)
    }

    /// Values, and their first and second rates by central differences along the motion, over a part of the interval to be
    /// searched.
    pub(super) fn of(motion: &Motion<M>, sample: &Sample<M>, interval: f64) -> Result<Point<M>, Failure> {
        let (state, d) = (&sample.state, PART * interval);
        let (ahead, behind) = (conditions(motion, &moved(sample, d))?, conditions(motion, &moved(sample, -d))?);
        let (qdd, lambda) = (&sample.accelerations, &sample.multipliers);
        let values = motion.mechanism().events(state.time, &state.positions, &state.speeds, qdd, lambda);
        Ok(Point {
            time: state.time,
            rates: ahead.like(|i| (ahead[i] - behind[i]) / (2.0 * d)),
            seconds: ahead.like(|i| (ahead[i] - 2.0 * values[i] + behind[i]) / (d * d)),
            values,
            interval,
        })
    }

    /// The changes of a condition over the same short time before and after this.
    pub(super) fn beside(&self, event: usize) -> [f64; 2] {
        let d = PART * self.interval;
        let (first, second) = (d * self.rates[event], d * d / 2.0 * self.seconds[event]);
        [second - first, second + first]
    }

    /// The same as the start of a step: differences over a much shorter one before it would be rounding.
    pub(super) fn starting(self, step: &Step<M>) -> Result<Point<M>, Failure> {
        match self.interval < SHORTER * step.length() {
            true => Ok(Point { values: self.values, ..Point::of(step.motion, step.from, step.length())? }),
            false => Ok(self),
        }
    }
}

/// A condition at two points: its values, and its rates times the interval.
#[inline]
pub(super) fn ends<M: Mechanism>(event: usize, from: &Point<M>, to: &Point<M>) -> ([f64; 2], [f64; 2]) {
    let h = to.time - from.time;
    ([from.values[event], to.values[event]], [h * from.rates[event], h * to.rates[event]])
}

/// Whether a condition may be zero between two points.
#[inline]
pub(super) fn may_reach_zero<M: Mechanism>(event: usize, from: &Point<M>, to: &Point<M>) -> bool {
    let (values, rates) = ends(event, from, to);
    signs::may_reach_zero(values, rates)
}

/// The accuracy of located times, in seconds, in a motion of this length: motions shorter than a second are faster.
pub(crate) fn tolerance(time: f64, span: f64) -> f64 {
    f64::max(1e-12 * span.min(1.0), 4.0 * f64::EPSILON * time.abs())
}
