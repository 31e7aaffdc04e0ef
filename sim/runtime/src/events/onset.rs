//! The sign of each event condition after the start of a phase.
//!
//! After an event that changes something, its condition is zero up to rounding, so its sign is taken from the first
//! derivative along the motion, or from the second. This distinguishes a ball that leaves the floor from one that
//! nothing holds. A condition that stays below the tolerance of constraints through a step keeps its sign, so that a
//! contact that is held does not land again.

use super::conditions::{bent, conditions, moved, tolerance};
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
    /// The second derivatives with accelerations that change, which conditions on speeds have.
    bends: M::Events,
    /// The tolerance of constraints and rounding.
    pub(crate) noise: M::Events,
    /// The rounding of the change of a condition in either time.
    significant: M::Events,
    /// The rounding of a condition itself, where its terms cancel.
    last_digits: M::Events,
    /// The times over which first and second derivatives are differences.
    times: [f64; 2],
    tolerance: f64,
}

/// Constraints are held to 1e-12.
pub(super) const OFFSET: f64 = 4e-12;
/// Terms of less than one SI unit count as one, but not those of small mechanisms: at most this many times themselves.
const LARGE: f64 = 1e6;
/// Rounding of a condition relative to its terms.
const ROUNDING: f64 = 1e-14;
/// The same of one condition alone, some units in the last place.
const LAST_DIGITS: f64 = 8.0 * f64::EPSILON;

impl<M: Mechanism> Onset<M> {
    /// By differences over parts of the time scale of the motion, or of the span of the run. In 1e-5 of it third derivatives
    /// contribute less than rounding to a change, and in 1e-4 fourth ones, but gentle accelerations more.
    pub(crate) fn of(motion: &Motion<M>, sample: &Sample<M>, span: f64) -> Result<Onset<M>, Failure> {
        let scale = time_scale(motion, sample, span);
        let times @ [d, e] = [1e-5 * scale, 1e-4 * scale];
        let values = conditions(motion, &sample.state)?;
        let beside = |moved: &dyn Fn(f64) -> State<M>, time: f64| -> Result<[M::Events; 2], Failure> {
            Ok([conditions(motion, &moved(time))?, conditions(motion, &moved(-time))?])
        };
        let [ahead, behind] = beside(&|time| moved(sample, time), d)?;
        let [far_ahead, far_behind] = beside(&|time| moved(sample, time), e)?;
        let [bent_ahead, bent_behind] = beside(&|time| bent(motion, sample, time), e)?;
        let [terms, own_terms] = terms(motion, &sample.state, &values)?;
        let others = other_terms(motion, sample, &values, scale)?;
        let floor = |event: usize| f64::min(1.0, LARGE * (terms[event] + others[event]));
        Ok(Onset {
            values: values.clone(),
            rates: values.like(|i| (ahead[i] - behind[i]) / (2.0 * d)),
            seconds: values.like(|i| (far_ahead[i] - 2.0 * values[i] + far_behind[i]) / (e * e)),
            bends: values.like(|i| (bent_ahead[i] - 2.0 * values[i] + bent_behind[i]) / (e * e)),
            noise: values.like(|i| {
                let noise = OFFSET * terms[i].max(floor(i));
                if noise.is_finite() { noise } else { 0.0 }
            }),
            significant: values.like(|i| ROUNDING * terms[i]),
            last_digits: values.like(|i| LAST_DIGITS * own_terms[i]),
            times,
            tolerance: tolerance(sample.state.time, span),
        })
    }

    /// None known yet.
    pub(crate) fn blank(none: &M::Events) -> Onset<M> {
        let [values, rates, seconds, bends, noise, significant, last_digits] = std::array::from_fn(|_| none.clone());
        Onset { values, rates, seconds, bends, noise, significant, last_digits, times: [0.0; 2], tolerance: 0.0 }
    }

    /// All of it as bytes, or from them.
    pub(crate) fn transfer(&mut self, bytes: &mut Bytes) -> Result<(), Damaged> {
        let Onset { values, rates, seconds, bends, noise, significant, last_digits, times, tolerance } = self;
        for numbers in [values, rates, seconds, bends, noise, significant, last_digits] {
            bytes.numbers(numbers.as_mut())?;
        }
        bytes.numbers(times)?;
        bytes.number(tolerance)
    }

    /// Whether a condition holds here, to the tolerance of a time.
    pub(crate) fn holds(&self, event: usize) -> bool {
        let value = self.values[event].abs();
        value.is_finite() && value <= 2.0 * self.tolerance * self.rates[event].abs() + self.noise[event]
    }

    /// Whether a condition lies beyond zero here, on the side of this sign.
    pub(crate) fn is_beyond(&self, event: usize, sign: f64) -> bool {
        sign * self.values[event] > self.noise[event]
    }

    /// Whether a condition stays where it is, up to noise.
    pub(crate) fn stays(&self, event: usize) -> bool {
        self.rates[event].abs() * self.times[0] <= self.noise[event]
    }

    /// The sign of a condition from here on, if it holds here: as it leaves, or beyond its return if that comes within the
    /// accuracy of times. A force that has just overcome another is rounding here, and so is the direction in which it moves
    /// at first.
    pub(crate) fn sign(&self, event: usize) -> f64 {
        match self.rates[event].abs() <= self.tolerance * self.bends[event].abs() {
            true if self.leaving(event) != 0.0 => self.bends[event].signum(),
            _ => self.leaving(event),
        }
    }

    /// The sign of a condition just after this, if it holds here: that of its first derivative, or of its second.
    pub(crate) fn leaving(&self, event: usize) -> f64 {
        let (rate, second, least) = (self.rates[event], self.seconds[event], self.significant[event]);
        match () {
            _ if !self.rests(event) => rate.signum(),
            _ if second.abs() * self.times[1].powi(2) / 2.0 > least => second.signum(),
            _ => 0.0,
        }
    }

    /// Whether all that changes a condition is noise.
    pub(crate) fn is_noise(&self, event: usize) -> bool {
        let [once, twice] = [self.times[0], self.times[1].powi(2) / 2.0];
        let changes = [self.rates[event] * once, self.seconds[event] * twice, self.bends[event] * twice];
        changes.iter().all(|change| change.abs() <= self.noise[event])
    }

    /// Whether the rate of a condition is but rounding here.
    pub(crate) fn rests(&self, event: usize) -> bool {
        self.rates[event].abs() * self.times[0] <= self.significant[event]
    }

    /// The time after which a condition that leaves zero here returns to zero, by its derivatives. Where the first is but
    /// rounding, the second leads away for good.
    pub(crate) fn returns_after(&self, event: usize) -> f64 {
        let time = -2.0 * self.rates[event] / self.seconds[event];
        if time >= 0.0 && !self.rests(event) { time } else { f64::INFINITY }
    }

    /// Whether a condition that leaves zero here and returns goes no further in between than the tolerance of constraints, or its
    /// rounding.
    pub(crate) fn hides_return(&self, event: usize) -> bool {
        let farthest = self.rates[event].powi(2) / (2.0 * self.seconds[event].abs());
        self.returns_after(event).is_finite() && farthest <= self.noise[event].max(self.last_digits[event])
    }
}

/// The time in which a motion changes by as much as counts as 1, or that of the run.
fn time_scale<M: Mechanism>(motion: &Motion<M>, sample: &Sample<M>, span: f64) -> f64 {
    let [fast, sharp] = [&sample.state.speeds, &sample.accelerations].map(|change| motion.size(change));
    span.min(1.0 / fast.max(sharp.sqrt()))
}

/// The size of the terms of each condition at a place in the motion, of all that it depends on.
pub(super) fn sizes<M: Mechanism>(motion: &Motion<M>, sample: &Sample<M>, span: f64) -> Result<M::Events, Failure> {
    let values = conditions(motion, &sample.state)?;
    let [terms, _] = terms(motion, &sample.state, &values)?;
    let others = other_terms(motion, sample, &values, time_scale(motion, sample, span))?;
    Ok(values.like(|i| terms[i] + others[i]))
}

/// Derivatives are differences over this part of what is changed.
const PART: f64 = 1e-6;

/// The change of each condition by all of what is changed by a part in a state.
fn change<M: Mechanism>(motion: &Motion<M>, state: &State<M>, values: &M::Events) -> Result<M::Events, Failure> {
    let changed = conditions(motion, state)?;
    Ok(values.like(|i| (changed[i] - values[i]).abs() / PART))
}

/// The size of the terms of each condition: the sum of |its derivative by a coordinate times the coordinate|, or times the
/// change that counts as 1, where that is more; and the same sum with the coordinates alone.
pub(super) fn terms<M: Mechanism>(
    motion: &Motion<M>,
    state: &State<M>,
    values: &M::Events,
) -> Result<[M::Events; 2], Failure> {
    let mut terms = values.like(|i| values[i].abs());
    let mut own_terms = terms.clone();
    for j in 0..motion.mechanism().n() {
        let own_size = state.positions[j].abs();
        let size = own_size.max(motion.measures().coordinates()[j]);
        let mut nearby = state.clone();
        nearby.positions[j] += PART * size;
        let by_position = change(motion, &nearby, values)?;
        terms = terms.like(|i| terms[i] + by_position[i]);
        own_terms = own_terms.like(|i| own_terms[i] + own_size / size * by_position[i]);
    }
    Ok([terms, own_terms])
}

/// The size of the other terms of each condition, by speeds, by time and by loads, in a motion of this time scale.
fn other_terms<M: Mechanism>(
    motion: &Motion<M>,
    sample: &Sample<M>,
    values: &M::Events,
    scale: f64,
) -> Result<M::Events, Failure> {
    let (mechanism, state) = (motion.mechanism(), &sample.state);
    let mut terms = change(motion, &State { time: state.time + PART * scale, ..state.clone() }, values)?;
    for j in 0..mechanism.n() {
        let mut faster = state.clone();
        faster.speeds[j] += PART * state.speeds[j].abs().max(motion.measures().coordinates()[j] / scale);
        let by_speed = change(motion, &faster, values)?;
        terms = terms.like(|i| terms[i] + by_speed[i]);
    }
    let loads = loads(mechanism, sample);
    let on_forces = |event: usize| mechanism.description().events[event].on_forces;
    Ok(terms.like(|i| terms[i] + if on_forces(i) { loads } else { 0.0 }))
}

/// The sum of all generalised forces, whatever their directions.
fn loads<M: Mechanism>(mechanism: &M, sample: &Sample<M>) -> f64 {
    let State { time, positions, speeds, .. } = &sample.state;
    let mass = mechanism.mass_matrix(*time, positions);
    let inertia = |j: usize| -> f64 { mass[j].iter().zip(sample.accelerations.iter()).map(|(m, a)| m * a).sum() };
    let applied = mechanism.generalized_forces(*time, positions, speeds);
    let convective = mechanism.convective_forces(*time, positions, speeds);
    (0..mechanism.n()).map(|j| applied[j].abs() + convective[j].abs() + inertia(j).abs()).sum()
}
