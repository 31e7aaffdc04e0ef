//! States, samples and trajectories.

use crate::Failure;
use sim_kernel::Mechanism;

/// What is integrated: the state of a mechanism, and the work done on it.
#[derive(Clone, Copy, Debug)]
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

/// A state with what follows from it; all of it belongs to one time.
#[derive(Clone, Copy, Debug)]
pub struct Sample<M: Mechanism> {
    /// The state.
    pub state: State<M>,
    /// q''.
    pub accelerations: M::Q,
    /// lambda.
    pub multipliers: M::L,
}

/// The samples of a motion, and how it ended.
#[derive(Clone, Debug)]
pub struct Trajectory<M: Mechanism> {
    /// In the order of time.
    pub samples: Vec<Sample<M>>,
    /// Why it ended before its time, if it did.
    pub failure: Option<Failure>,
}
