//! A motion on numbers of any kind, without the rare cases.
//!
//! These stay in [`Motion`](super::Motion), in `f64`: refused pivots, redundant constraints, generalised speeds, and
//! stabilisations other than projection. Where a plain motion fails in any lane, its caller turns to the motion itself.

use super::field::Field;
use super::measures::Measures;
use super::project::project_by_rows;
use super::velocity_variables::Integrated;
use crate::numerics::numbers::are_finite;
use crate::state::failure::{Failure, What};
use crate::state::slot::Slot;
use crate::state::trajectory::{Rates, Sample, State};
use sim_kernel::{Array, Mask, Mechanism, Scalar};
use std::cell::Cell;

/// The equations of motion of one mechanism, or of several side by side.
#[derive(Clone, Debug)]
pub(crate) struct Plain<M: Mechanism<S>, S: Scalar> {
    mechanism: M,
    prepared: M::Prepared,
    measures: Measures<M, S>,
    /// The greatest squared length so far of each row of C_q D.
    pub(crate) longest: Slot<M::L>,
    /// The number of right-hand sides evaluated so far.
    pub(crate) evaluations: Cell<u64>,
}

impl<S: Scalar, M: Mechanism<S>> Plain<M, S> {
    /// The equations of motion of a mechanism without redundant constraints.
    pub(crate) fn new(mechanism: M, measures: Measures<M, S>) -> Plain<M, S> {
        let longest = Slot::new(M::L::repeat(mechanism.m(), S::ZERO));
        Plain { prepared: mechanism.prepare(), measures, longest, evaluations: Cell::new(0), mechanism }
    }

    /// A state with its accelerations and multipliers.
    ///
    /// # Errors
    /// If the planned elimination refuses a pivot.
    #[inline(always)]
    pub(crate) fn sample(&self, state: State<M, S>) -> Result<Sample<M, S>, Failure> {
        self.evaluations.set(self.evaluations.get() + 1);
        let solved = M::prepared_dynamics(&self.prepared, state.time, &state.positions, &state.speeds);
        let is_sound = !solved.refused.any()
            && are_finite(solved.accelerations.as_ref())
            && are_finite(solved.multipliers.as_ref())
            && are_finite(&[solved.power]);
        match is_sound {
            true => Ok(Sample::new(state, solved, self.mechanism.inputs())),
            false => Err(self.refused(&state)),
        }
    }

    #[cold]
    fn refused(&self, state: &State<M, S>) -> Failure {
        let why = "the planned elimination of its equations refuses a pivot here";
        Failure::at(&self.mechanism, What::NotDifferentiable { why }, state.time, &state.positions)
    }

    /// Brings a state onto the constraints; gives 1/s^2, where s is the smallest sine between a row of C_q D and those
    /// before it.
    ///
    /// # Errors
    /// As the projection, if any lane fails.
    #[inline(always)]
    pub(crate) fn keep(&self, state: &mut State<M, S>) -> Result<S, Failure> {
        project_by_rows(&self.mechanism, &self.measures, state, &self.longest)
    }
}

impl<S: Scalar, M: Mechanism<S>> Field<M, S> for Plain<M, S> {
    #[inline(always)]
    fn mechanism(&self) -> &M {
        &self.mechanism
    }
    #[inline(always)]
    fn measures(&self) -> &Measures<M, S> {
        &self.measures
    }
    #[inline(always)]
    fn integrated(&self, state: &State<M, S>) -> Integrated<M, S> {
        Integrated(state.clone())
    }
    #[inline(always)]
    fn stage(&self, Integrated(state): Integrated<M, S>, rates: &mut Rates<M, S>) -> Result<(), Failure> {
        *rates = self.sample(state)?.rates();
        Ok(())
    }
    #[inline(always)]
    fn rates(&self, sample: &Sample<M, S>) -> Rates<M, S> {
        sample.rates()
    }
    #[inline(always)]
    fn end(&self, Integrated(state): Integrated<M, S>) -> Result<State<M, S>, Failure> {
        Ok(state)
    }
    #[inline(always)]
    fn in_speeds(&self, _: &State<M, S>, change: &Rates<M, S>) -> Result<(M::Q, M::Q), Failure> {
        Ok((change.positions.clone(), change.speeds.clone()))
    }
}
