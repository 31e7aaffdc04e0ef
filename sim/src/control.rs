//! Inputs that a program sets while a motion runs.

use crate::trajectory::Sample;
use sim_kernel::Mechanism;

/// The law of a controller: the inputs that follow from a sample.
type Law<'c, M> = Box<dyn FnMut(&Sample<M>) -> <M as Mechanism>::Inputs + 'c>;

/// What sets the inputs of a run: asked at its start and after every period, of the sample that is reached; between, what it
/// sets is held. Steps end where periods do, so that a motion is smooth within a step.
pub struct Controller<'c, M: Mechanism> {
    period: f64,
    law: Law<'c, M>,
}

impl<'c, M: Mechanism> Controller<'c, M> {
    /// A law that is asked every `period` seconds; `None` unless that is above zero.
    pub fn new(period: f64, law: impl FnMut(&Sample<M>) -> M::Inputs + 'c) -> Option<Controller<'c, M>> {
        (period > 0.0).then(|| Controller { period, law: Box::new(law) })
    }

    /// How long inputs are held, in seconds.
    pub fn period(&self) -> f64 {
        self.period
    }

    /// The inputs from a sample on.
    pub(crate) fn inputs(&mut self, sample: &Sample<M>) -> M::Inputs {
        (self.law)(sample)
    }
}
