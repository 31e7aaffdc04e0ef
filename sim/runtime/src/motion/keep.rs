//! How a motion is kept on its constraints.
//!
//! Integration methods know nothing of constraints: [`Motion::sample`](super::Motion) and `keep` are the only hooks of
//! every stabilisation. Partitioning makes the dependent part follow in every right-hand side.

use crate::motion::Motion;
use crate::motion::project::{by_mass, project_measured};
use crate::motion::singular::weakest_constraint;
use crate::state::failure::Failure;
use crate::state::settings::Stabilisation;
use crate::state::trajectory::State;
use sim_kernel::Mechanism;

impl<M: Mechanism> Motion<M> {
    /// Brings the end of a step, or a point inside it, onto the constraints.
    ///
    /// # Errors
    /// As the projection.
    #[inline]
    pub fn keep(&self, state: &mut State<M>) -> Result<(), Failure> {
        match self.is_in_generalized_speeds() {
            false => self.bring(state),
            true => self.with_velocity_variables_kept(state, |state| self.bring(state)),
        }
    }

    #[inline]
    fn bring(&self, state: &mut State<M>) -> Result<(), Failure> {
        match self.stabilisation {
            Stabilisation::Projection => {
                let closeness = project_measured(&self.mechanism, &self.measures, state, &self.longest)?;
                self.closeness.set(closeness);
                if self.measures.is_redundant() {
                    self.widen(1.0 / closeness.sqrt());
                }
                return Ok(());
            }
            Stabilisation::MassProjection => by_mass(&self.mechanism, &self.measures, state)?,
            Stabilisation::Partitioning => self.partition.borrow().follow(&self.mechanism, &self.measures, state)?,
            Stabilisation::Baumgarte(_) | Stabilisation::None => {}
        }
        let sine = weakest_constraint(self, state).map_or(f64::INFINITY, |(_, sine)| sine);
        let unit = if self.measures.is_redundant() { self.widest.get() } else { 1.0 };
        self.closeness.set((sine * unit).powi(-2));
        Ok(())
    }
}
