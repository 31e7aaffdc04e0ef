//! The watcher of a motion.

use crate::integrate::Step;
use crate::motion::Motion;
use crate::state::failure::Failure;
use crate::state::trajectory::{Sample, State};
use sim_kernel::Mechanism;

/// The watcher of a motion.
pub(crate) trait Watch<M: Mechanism> {
    /// A phase starts with a sample; events have taken this much kinetic energy so far, in joules.
    fn starts(&mut self, motion: &Motion<M>, sample: &Sample<M>, energy_taken: f64);

    /// A step has been made; it counts up to a state inside it if an event ends the phase there.
    ///
    /// # Errors
    /// As dense output.
    fn steps(&mut self, step: &mut Step<M>, until: Option<&State<M>>) -> Result<(), Failure>;
}

/// Nobody.
impl<M: Mechanism> Watch<M> for () {
    fn starts(&mut self, _: &Motion<M>, _: &Sample<M>, _: f64) {}

    fn steps(&mut self, _: &mut Step<M>, _: Option<&State<M>>) -> Result<(), Failure> {
        Ok(())
    }
}
