//! Inputs that a program sets while a motion runs.
//!
//! The controller is called between integrations, once per period, so that no step has a jump in it.

use super::Simulation;
use crate::state::failure::Failure;
use crate::state::trajectory::Sample;
use sim_kernel::Mechanism;

/// The law of a controller: the inputs that follow from a sample.
type Law<'c, M> = Box<dyn FnMut(&Sample<M>) -> <M as Mechanism>::Inputs + 'c>;

/// The controller of a run's inputs: called with the sample at the start and after every period; between, its inputs
/// are held. Steps end where periods do, so that a motion is smooth within a step.
pub struct Controller<'c, M: Mechanism> {
    period: f64,
    law: Law<'c, M>,
}

impl<'c, M: Mechanism> Controller<'c, M> {
    /// A law that is called every `period` seconds; `None` unless that is above zero.
    pub fn new(period: f64, law: impl FnMut(&Sample<M>) -> M::Inputs + 'c) -> Option<Controller<'c, M>> {
        (period > 0.0).then(|| Controller { period, law: Box::new(law) })
    }

    /// The time for which inputs are held, in seconds.
    pub fn period(&self) -> f64 {
        self.period
    }
}

/// A controller along a run, if there is one.
pub(crate) struct Control<'r, 'c, M: Mechanism> {
    controller: Option<&'r mut Controller<'c, M>>,
    begin: f64,
    /// The number of calls.
    asked: u32,
}

impl<'r, 'c, M: Mechanism> Control<'r, 'c, M> {
    pub(crate) fn new(controller: Option<&'r mut Controller<'c, M>>, begin: f64) -> Control<'r, 'c, M> {
        Control { controller, begin, asked: 0 }
    }

    /// Until when inputs are held, in a run that ends at `end`.
    pub(crate) fn holds_until(&self, end: f64) -> f64 {
        let period = self.controller.as_ref().map(|controller| controller.period);
        period.map_or(end, |period| (self.begin + f64::from(self.asked) * period).min(end))
    }

    /// Sets the inputs of a motion if a period ends where it is. The controller sees a sample that follows from the inputs so far.
    ///
    /// # Errors
    /// As the sample.
    pub(crate) fn ask(&mut self, simulation: &mut Simulation<M>) -> Result<(), Failure> {
        let is_due = simulation.state().time >= self.holds_until(f64::INFINITY) && !simulation.has_ended();
        let Some(controller) = self.controller.as_mut().filter(|_| is_due) else { return Ok(()) };
        self.asked += 1;
        simulation.set_inputs((controller.law)(&simulation.sample()?))
    }
}
