//! The trait of integration methods.

use crate::motion::Motion;
use crate::motion::measures::Measures;
use crate::state::failure::Failure;
use crate::state::interpolate::hermite;
use crate::state::settings::Tolerance;
use crate::state::trajectory::{Sample, State};
use sim_kernel::{Array, Mechanism};

/// A method that advances a motion step by step. `examples/own_integrator.rs` shows a custom one.
///
/// A method knows nothing of constraints, events or records: its end is projected, and states inside a step come from
/// [`Advance::inside`] and are projected too.
pub trait Advance<M: Mechanism> {
    /// The order of its error estimate plus 1, by which steps are chosen; none if it makes no estimate.
    fn control_order(&self) -> Option<f64> {
        None
    }

    /// The place in a step that is farthest from its stages, as a fraction: there a singular position does no harm.
    fn gap(&self) -> f64 {
        0.5
    }

    /// Whether its stages are computed one from another, so that each can be projected first.
    fn is_explicit(&self) -> bool {
        true
    }

    /// Advances from a sample to `time`.
    ///
    /// # Errors
    /// Failures of the right-hand side, and those of the method itself.
    fn step(
        &mut self,
        motion: &Motion<M>,
        from: &Sample<M>,
        time: f64,
        tolerance: Option<&Tolerance>,
    ) -> Result<Attempt<M>, Failure>;

    /// The state at a fraction of the last step, from its start to its projected end; not yet projected itself.
    ///
    /// By default the quintic that has positions, speeds and accelerations of both ends.
    ///
    /// # Errors
    /// Failures of the right-hand side, if it is evaluated again.
    fn inside(
        &mut self,
        motion: &Motion<M>,
        from: &Sample<M>,
        to: &Sample<M>,
        fraction: f64,
    ) -> Result<State<M>, Failure> {
        let _ = motion;
        Ok(hermite(from, to, fraction))
    }
}

/// The end of a step.
#[derive(Debug)]
pub struct Attempt<M: Mechanism> {
    /// The state at its end.
    pub end: State<M>,
    /// The estimate of its error in units of the tolerance; 0 if there is none.
    pub error: f64,
}

impl<M: Mechanism> Clone for Attempt<M> {
    fn clone(&self) -> Attempt<M> {
        *self
    }
}

impl<M: Mechanism> Copy for Attempt<M> {}

impl Tolerance {
    /// The norm of an error of positions and speeds in units of the tolerance: root of the mean square.
    ///
    /// Hairer, Norsett, Wanner, Solving Ordinary Differential Equations I, (II.4.11); the absolute part is a fraction
    /// of the scale of each coordinate, so it depends on neither units nor sizes.
    #[inline]
    pub fn norm<M: Mechanism>(
        &self,
        measures: &Measures<M>,
        from: &State<M>,
        to: &State<M>,
        error: &(M::Q, M::Q),
    ) -> f64 {
        let mut sum = 0.0;
        let n = measures.coordinates().len();
        for i in 0..n {
            let absolute = self.absolute * measures.coordinates()[i];
            let scale = |a: f64, b: f64| absolute + self.relative * a.abs().max(b.abs());
            sum += (error.0[i] / scale(from.positions[i], to.positions[i])).powi(2);
            sum += (error.1[i] / scale(from.speeds[i], to.speeds[i])).powi(2);
        }
        (sum / (2 * n).max(1) as f64).sqrt()
    }
}
