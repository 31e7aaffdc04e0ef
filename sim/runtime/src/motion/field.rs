//! What explicit methods integrate, on numbers of any kind.

use super::Motion;
use super::measures::Measures;
use super::velocity_variables::Integrated;
use crate::state::failure::Failure;
use crate::state::trajectory::{Rates, Sample, State};
use sim_kernel::{Mechanism, Scalar};

/// States of a mechanism, and their rates.
pub(crate) trait Field<M: Mechanism<S>, S: Scalar = f64> {
    /// The mechanism.
    fn mechanism(&self) -> &M;
    /// The scales of its coordinates and constraints.
    fn measures(&self) -> &Measures<M, S>;
    /// A state as what is integrated.
    fn integrated(&self, state: &State<M, S>) -> Integrated<M, S>;
    /// The rates of the integrated variables at a stage, which are written where they stay.
    ///
    /// # Errors
    /// As the right-hand side; if any lane fails.
    fn stage(&self, integrated: Integrated<M, S>, rates: &mut Rates<M, S>) -> Result<(), Failure>;
    /// The rates of the integrated variables at a sample.
    fn rates(&self, sample: &Sample<M, S>) -> Rates<M, S>;
    /// The state at the end of a step.
    ///
    /// # Errors
    /// Where generalised speeds do not determine the speeds.
    fn end(&self, integrated: Integrated<M, S>) -> Result<State<M, S>, Failure>;
    /// A small change of the integrated variables at a state, as one of positions and speeds.
    ///
    /// # Errors
    /// As [`end`](Field::end).
    fn in_speeds(&self, state: &State<M, S>, change: &Rates<M, S>) -> Result<(M::Q, M::Q), Failure>;
}

impl<M: Mechanism> Field<M> for Motion<M> {
    #[inline(always)]
    fn mechanism(&self) -> &M {
        Motion::mechanism(self)
    }
    #[inline(always)]
    fn measures(&self) -> &Measures<M> {
        Motion::measures(self)
    }
    #[inline(always)]
    fn integrated(&self, state: &State<M>) -> Integrated<M> {
        Motion::integrated(self, state)
    }
    #[inline(always)]
    fn stage(&self, integrated: Integrated<M>, rates: &mut Rates<M>) -> Result<(), Failure> {
        self.rates_at(integrated, rates)
    }
    #[inline(always)]
    fn rates(&self, sample: &Sample<M>) -> Rates<M> {
        Motion::rates(self, sample)
    }
    #[inline(always)]
    fn end(&self, integrated: Integrated<M>) -> Result<State<M>, Failure> {
        Motion::end(self, integrated)
    }
    #[inline(always)]
    fn in_speeds(&self, state: &State<M>, change: &Rates<M>) -> Result<(M::Q, M::Q), Failure> {
        Motion::in_speeds(self, state, change)
    }
}
