//! The trait of integration methods.

use crate::motion::Motion;
use crate::motion::measures::Measures;
use crate::numerics::numbers::larger;
use crate::state::failure::Failure;
use crate::state::interpolate::hermite;
use crate::state::settings::Tolerance;
use crate::state::trajectory::{Sample, State};
use sim_kernel::{Array, Mechanism, Scalar};

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

    /// h |lambda| of the last step over what keeps the method stable, roughly: steps that stability limits are about 1. None if the
    /// method does not know.
    fn stiffness(&self, motion: &Motion<M>, from: &Sample<M>, to: &Sample<M>) -> Option<f64> {
        let _ = (motion, from, to);
        None
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
#[derive(Clone, Debug)]
pub struct Attempt<M: Mechanism<S>, S: Scalar = f64> {
    /// The state at its end.
    pub end: State<M, S>,
    /// The estimate of its error in units of the tolerance; 0 if there is none.
    pub error: S,
}

impl Tolerance {
    /// The norm of an error of positions and speeds in units of the tolerance: root of the mean square.
    ///
    /// Hairer, Norsett, Wanner, Solving Ordinary Differential Equations I, (II.4.11); the absolute part is a fraction
    /// of the scale of each coordinate, so it depends on neither units nor sizes.
    #[inline]
    pub fn norm<S: Scalar, M: Mechanism<S>>(
        &self,
        measures: &Measures<M, S>,
        from: &State<M, S>,
        to: &State<M, S>,
        [of_positions, of_speeds]: [&M::Q; 2],
    ) -> S {
        let (mut sum, number) = (S::ZERO, S::from_f64);
        let n = measures.coordinates().len();
        for i in 0..n {
            let absolute = number(self.absolute) * measures.coordinates()[i];
            let scale = |a: S, b: S| absolute + number(self.relative) * larger(a.abs(), b.abs());
            let [of_position, of_speed] = [
                of_positions[i] / scale(from.positions[i], to.positions[i]),
                of_speeds[i] / scale(from.speeds[i], to.speeds[i]),
            ];
            sum = sum + of_position * of_position;
            sum = sum + of_speed * of_speed;
        }
        (sum / number((2 * n).max(1) as f64)).sqrt()
    }
}
