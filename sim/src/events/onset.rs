//! The sign of each event condition after the start of a phase.
//!
//! After an event that changes something, its condition is zero up to rounding, so its sign is taken from the first
//! derivative along the motion, or from the second. This distinguishes a ball that leaves the floor from one that
//! nothing holds. A condition that stays below the tolerance of constraints through a step keeps its sign, so that a
//! contact that is held does not land again.

use super::conditions::{conditions, moved, tolerance};
use crate::motion::Motion;
use crate::state::failure::Failure;
use crate::state::saved::{Bytes, Damaged};
use crate::state::trajectory::{Sample, State};
use sim_kernel::{Array, Mechanism};

/// Conditions with their first two derivatives in time.
#[derive(Clone, Debug)]
pub(crate) struct Onset<M: Mechanism> {
    values: M::Events,
    rates: M::Events,
    seconds: M::Events,
    /// The tolerance of constraints and rounding.
    pub(crate) noise: M::Events,
    /// The rounding of the change of a condition in the time `d`.
    significant: M::Events,
    d: f64,
    tolerance: f64,
}

/// Constraints are held to 1e-12.
const OFFSET: f64 = 4e-12;
/// Rounding of a condition relative to its terms.
const ROUNDING: f64 = 1e-14;

impl<M: Mechanism> Onset<M> {
    /// By differences over 1e-5 of the time scale of the motion, or of the span of the run: third derivatives then
    /// contribute less than rounding.
    pub(crate) fn of(motion: &Motion<M>, sample: &Sample<M>, span: f64) -> Result<Onset<M>, Failure> {
        let [fast, sharp] = [&sample.state.speeds, &sample.accelerations].map(|change| motion.size(change));
        let d = 1e-5 * span.min(1.0 / fast.max(sharp.sqrt()));
        let values = conditions(motion, &sample.state)?;
        let (ahead, behind) = (conditions(motion, &moved(sample, d))?, conditions(motion, &moved(sample, -d))?);
        let terms = terms(motion, &sample.state, &values)?;
        Ok(Onset {
            values: values.clone(),
            rates: values.like(|i| (ahead[i] - behind[i]) / (2.0 * d)),
            seconds: values.like(|i| (ahead[i] - 2.0 * values[i] + behind[i]) / (d * d)),
            noise: values.like(|i| OFFSET * terms[i].max(1.0)),
            significant: values.like(|i| ROUNDING * terms[i]),
            d,
            tolerance: tolerance(sample.state.time),
        })
    }

    /// None known yet.
    pub(crate) fn blank(none: &M::Events) -> Onset<M> {
        let [values, rates, seconds, noise, significant] = std::array::from_fn(|_| none.clone());
        Onset { values, rates, seconds, noise, significant, d: 0.0, tolerance: 0.0 }
    }

    /// All of it as bytes, or from them.
    pub(crate) fn transfer(&mut self, bytes: &mut Bytes) -> Result<(), Damaged> {
        let Onset { values, rates, seconds, noise, significant, d, tolerance } = self;
        for numbers in [values, rates, seconds, noise, significant] {
            bytes.numbers(numbers.as_mut())?;
        }
        bytes.number(d)?;
        bytes.number(tolerance)
    }

    /// Whether a condition holds here, to the tolerance of a time.
    pub(crate) fn holds(&self, event: usize) -> bool {
        self.values[event].abs() <= 2.0 * self.tolerance * self.rates[event].abs() + self.noise[event]
    }

    /// Whether a condition lies beyond zero here, on the side of this sign.
    pub(crate) fn is_beyond(&self, event: usize, sign: f64) -> bool {
        sign * self.values[event] > self.noise[event]
    }

    /// The sign of a condition from here on, if it holds here: that of its first derivative, or of its second.
    pub(crate) fn sign(&self, event: usize) -> f64 {
        let (rate, second, least) = (self.rates[event], self.seconds[event], self.significant[event]);
        match () {
            _ if rate.abs() * self.d > least => rate.signum(),
            _ if second.abs() * self.d * self.d / 2.0 > least => second.signum(),
            _ => 0.0,
        }
    }

    /// The time after which a condition that leaves zero here returns to zero, by its derivatives. Where the first is but
    /// rounding, the second leads away for good.
    pub(crate) fn returns_after(&self, event: usize) -> f64 {
        let time = -2.0 * self.rates[event] / self.seconds[event];
        let leaves_slowly = self.rates[event].abs() * self.d <= self.significant[event];
        if time >= 0.0 && !leaves_slowly { time } else { f64::INFINITY }
    }
}

/// The size of the terms of each condition: the sum of |its derivative by a coordinate times the coordinate|.
fn terms<M: Mechanism>(motion: &Motion<M>, state: &State<M>, values: &M::Events) -> Result<M::Events, Failure> {
    let mut terms = values.like(|i| values[i].abs());
    for (j, coordinate) in motion.mechanism().description().coordinates.iter().enumerate() {
        let size = state.positions[j].abs().max(coordinate.position.factor);
        let mut nearby = state.clone();
        nearby.positions[j] += 1e-6 * size;
        let changed = conditions(motion, &nearby)?;
        terms = terms.like(|i| terms[i] + 1e6 * (changed[i] - values[i]).abs());
    }
    Ok(terms)
}
