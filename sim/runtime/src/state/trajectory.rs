//! States, samples and trajectories. States, samples and rates may be of any numbers: of several motions side by side,
//! or with derivatives.

use crate::Failure;
use crate::numerics::numbers::are_finite;
use sim_kernel::{Array, Dynamics, Mechanism, Scalar};

/// The integrated variables: the state of a mechanism, and the work done on it.
#[derive(Clone, Debug)]
pub struct State<M: Mechanism<S>, S: Scalar = f64> {
    /// t, in seconds.
    pub time: S,
    /// q.
    pub positions: M::Q,
    /// q'.
    pub speeds: M::Q,
    /// The work of loads and drives since the start, in joules.
    pub work: S,
}

impl<S: Scalar, M: Mechanism<S>> State<M, S> {
    /// The state at `time` after a change of `factor` times some rates.
    #[inline(always)]
    pub fn changed(&self, time: S, factor: S, rates: &Rates<M, S>) -> State<M, S> {
        State {
            time,
            positions: self.positions.zip_with(&rates.positions, |value, rate| *value + factor * *rate),
            speeds: self.speeds.zip_with(&rates.speeds, |value, rate| *value + factor * *rate),
            work: self.work + factor * rates.work,
        }
    }

    /// Whether all of it is finite.
    #[inline(always)]
    pub fn is_finite(&self) -> bool {
        are_finite(self.positions.as_ref()) && are_finite(self.speeds.as_ref()) && are_finite(&[self.work])
    }
}

/// A state with the quantities that follow from it, all at one time.
#[derive(Clone, Debug)]
pub struct Sample<M: Mechanism<S>, S: Scalar = f64> {
    /// The state.
    pub state: State<M, S>,
    /// q''.
    pub accelerations: M::Q,
    /// lambda.
    pub multipliers: M::L,
    /// The power of loads and drives, in watts.
    pub power: S,
    /// The inputs that all of this follows from.
    pub inputs: M::Inputs,
}

impl<S: Scalar, M: Mechanism<S>> Sample<M, S> {
    /// A state with the solution of the equations of motion there, at these inputs.
    pub fn new(state: State<M, S>, dynamics: Dynamics<S, M::Q, M::L>, inputs: M::Inputs) -> Sample<M, S> {
        let Dynamics { accelerations, multipliers, power, .. } = dynamics;
        Sample { state, accelerations, multipliers, power, inputs }
    }

    /// The rates of the state in time.
    pub fn rates(&self) -> Rates<M, S> {
        Rates { positions: self.state.speeds.clone(), speeds: self.accelerations.clone(), work: self.power }
    }
}

/// The rate of each part of a state, or a change of it.
#[derive(Clone, Debug)]
pub struct Rates<M: Mechanism<S>, S: Scalar = f64> {
    /// Of the positions: q'.
    pub positions: M::Q,
    /// Of the speeds: q''.
    pub speeds: M::Q,
    /// Of the work: the power, in watts.
    pub work: S,
}

impl<S: Scalar, M: Mechanism<S>> Rates<M, S> {
    /// No change of a state with so many coordinates.
    #[inline(always)]
    pub fn zero(n: usize) -> Rates<M, S> {
        Rates { positions: M::Q::repeat(n, S::ZERO), speeds: M::Q::repeat(n, S::ZERO), work: S::ZERO }
    }

    /// These, times a factor.
    #[inline(always)]
    pub fn scaled(&self, factor: S) -> Rates<M, S> {
        Rates {
            positions: self.positions.apply(|rate| factor * *rate),
            speeds: self.speeds.apply(|rate| factor * *rate),
            work: factor * self.work,
        }
    }

    /// Multiplies these by a factor.
    #[inline(always)]
    pub fn scale(&mut self, factor: S) {
        self.positions = self.positions.apply(|rate| factor * *rate);
        self.speeds = self.speeds.apply(|rate| factor * *rate);
        self.work = factor * self.work;
    }

    /// Adds a multiple of others.
    #[inline(always)]
    pub fn add(&mut self, weight: S, other: &Rates<M, S>) {
        self.positions.update(&other.positions, |sum, rate| *sum + weight * *rate);
        self.speeds.update(&other.speeds, |sum, rate| *sum + weight * *rate);
        self.work = self.work + weight * other.work;
    }
}

/// A part of a motion in which nothing is switched or set.
#[derive(Clone, Debug)]
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
            .map(move |(index, sample)| (mechanism(index).with_inputs(sample.inputs.clone()), sample))
    }
}
