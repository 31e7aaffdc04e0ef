//! What a stepper does next, and where the step ends that it attempts.

use crate::state::settings::Tolerance;

/// What a stepper does next.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Aim {
    /// Nothing: the end of its course is reached.
    End,
    /// The next step is made.
    Made,
    /// An attempt at the target.
    Attempt,
}

/// The end of an attempted step.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Target {
    /// Its time, in seconds.
    pub(crate) time: f64,
    /// The time that was wanted, unless a singular position is ahead.
    pub(super) wanted: f64,
    /// The bound of its error, if that is estimated.
    pub(crate) tolerance: Option<Tolerance>,
    /// Whether singular positions in it are looked for.
    pub(super) notes: bool,
}

impl Target {
    /// One to be set.
    pub(super) fn blank() -> Target {
        Target { time: 0.0, wanted: 0.0, tolerance: None, notes: false }
    }
}
