//! States, samples and trajectories.

use crate::Failure;
use sim_kernel::{Array, Dynamics, Mechanism};

/// The integrated variables: the state of a mechanism, and the work done on it.
#[derive(Debug)]
pub struct State<M: Mechanism> {
    /// t, in seconds.
    pub time: f64,
    /// q.
    pub positions: M::Q,
    /// q'.
    pub speeds: M::Q,
    /// The work of loads and drives since the start, in joules.
    pub work: f64,
}

impl<M: Mechanism> Clone for State<M> {
    fn clone(&self) -> State<M> {
        *self
    }
}

impl<M: Mechanism> Copy for State<M> {}

impl<M: Mechanism> State<M> {
    /// The state at `time` after a change of `factor` times some rates.
    #[inline(always)]
    pub fn changed(&self, time: f64, factor: f64, rates: &Rates<M>) -> State<M> {
        State {
            time,
            positions: self.positions.like(|i| self.positions[i] + factor * rates.positions[i]),
            speeds: self.speeds.like(|i| self.speeds[i] + factor * rates.speeds[i]),
            work: self.work + factor * rates.work,
        }
    }

    /// Whether all of it is finite.
    #[inline(always)]
    pub fn is_finite(&self) -> bool {
        let all_finite = |values: &[f64]| values.iter().all(|value| value.is_finite());
        all_finite(self.positions.as_ref()) && all_finite(self.speeds.as_ref()) && self.work.is_finite()
    }
}

/// A state with the quantities that follow from it, all at one time.
#[derive(Debug)]
pub struct Sample<M: Mechanism> {
    /// The state.
    pub state: State<M>,
    /// q''.
    pub accelerations: M::Q,
    /// lambda.
    pub multipliers: M::L,
    /// The power of loads and drives, in watts.
    pub power: f64,
    /// The inputs that all of this follows from.
    pub inputs: M::Inputs,
}

impl<M: Mechanism> Clone for Sample<M> {
    fn clone(&self) -> Sample<M> {
        *self
    }
}

impl<M: Mechanism> Copy for Sample<M> {}

impl<M: Mechanism> Sample<M> {
    /// A state with the solution of the equations of motion there, at these inputs.
    pub fn new(state: State<M>, dynamics: &Dynamics<f64, M::Q, M::L>, inputs: M::Inputs) -> Sample<M> {
        let Dynamics { accelerations, multipliers, power, .. } = *dynamics;
        Sample { state, accelerations, multipliers, power, inputs }
    }

    /// The rates of the state in time.
    pub fn rates(&self) -> Rates<M> {
        Rates { positions: self.state.speeds, speeds: self.accelerations, work: self.power }
    }
}

/// The rate of each part of a state, or a change of it.
#[derive(Debug)]
pub struct Rates<M: Mechanism> {
    /// Of the positions: q'.
    pub positions: M::Q,
    /// Of the speeds: q''.
    pub speeds: M::Q,
    /// Of the work: the power, in watts.
    pub work: f64,
}

impl<M: Mechanism> Clone for Rates<M> {
    fn clone(&self) -> Rates<M> {
        *self
    }
}

impl<M: Mechanism> Copy for Rates<M> {}

impl<M: Mechanism> Rates<M> {
    /// No change of a state with so many coordinates.
    #[inline(always)]
    pub fn zero(n: usize) -> Rates<M> {
        Rates { positions: M::Q::repeat(n, 0.0), speeds: M::Q::repeat(n, 0.0), work: 0.0 }
    }

    /// These, times a factor.
    #[inline(always)]
    pub fn scaled(&self, factor: f64) -> Rates<M> {
        Rates {
            positions: self.positions.like(|i| factor * self.positions[i]),
            speeds: self.speeds.like(|i| factor * self.speeds[i]),
            work: factor * self.work,
        }
    }

    /// Adds a multiple of others.
    #[inline(always)]
    pub fn add(&mut self, weight: f64, other: &Rates<M>) {
        for i in 0..self.positions.len() {
            self.positions[i] += weight * other.positions[i];
            self.speeds[i] += weight * other.speeds[i];
        }
        self.work += weight * other.work;
    }
}

/// A part of a motion in which nothing is switched or set.
#[derive(Clone, Copy, Debug)]
pub struct Phase<M: Mechanism> {
    /// The mechanism in it.
    pub mechanism: M,
    /// Its first sample.
    pub first: usize,
    /// The kinetic energy that events have taken until then, in joules.
    pub energy_taken: f64,
}

/// The samples of a motion, and how it ended.
#[derive(Clone, Debug)]
pub struct Trajectory<M: Mechanism> {
    /// In the order of time. An event that changes something has two at its time: before, and after.
    pub samples: Vec<Sample<M>>,
    /// The parts between such events, in order.
    pub phases: Vec<Phase<M>>,
    /// The failure that ended it early, if any.
    pub failure: Option<Failure>,
}

impl<M: Mechanism> Trajectory<M> {
    /// The phase that a sample belongs to.
    pub fn phase_of(&self, sample: usize) -> Option<&Phase<M>> {
        self.phases[..self.phases.partition_point(|phase| phase.first <= sample)].last()
    }

    /// Each sample with the mechanism at its time and its inputs; `start` is that before the first phase.
    pub fn with_mechanisms<'t>(&'t self, start: &'t M) -> impl Iterator<Item = (M, &'t Sample<M>)> {
        let mechanism = move |index: usize| self.phase_of(index).map_or(start, |phase| &phase.mechanism);
        self.samples
            .iter()
            .enumerate()
            .map(move |(index, sample)| (mechanism(index).with_inputs(sample.inputs), sample))
    }
}
