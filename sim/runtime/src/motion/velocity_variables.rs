//! What is integrated beside the coordinates: generalised speeds u where they are declared and determine the speeds
//! well, and the speeds q' elsewhere.
//!
//! The angular velocities of a rotating body change less than the rates of its coordinates, and their equations keep
//! digits that the rates lose. States, samples, rows and events are always in q and q'. A step in generalised speeds
//! starts with u = W q' + w, has q' = N u + n at its stages, and u' = W q'' + W' q' + w'. Projection moves positions
//! and keeps u. An error of u counts as the error of q' that it causes, so u needs no scale of its own. Radau takes all
//! of its steps in q': its linear systems have half the size where q' is the rate of q.

use crate::motion::Motion;
use crate::state::failure::{Failure, What};
use crate::state::trajectory::{Rates, Sample, State};
use sim_kernel::{Array, Dual, Mechanism, Scalar};

/// q on dual numbers.
type DualQ<M> = <<M as Mechanism>::On<Dual> as Mechanism<Dual>>::Q;

/// A state with its velocity variables in the place of its speeds.
#[derive(Clone, Debug)]
pub(crate) struct Integrated<M: Mechanism<S>, S: Scalar = f64>(pub(super) State<M, S>);

impl<S: Scalar, M: Mechanism<S>> Integrated<M, S> {
    /// Its time.
    #[inline(always)]
    pub(crate) fn time(&self) -> S {
        self.0.time
    }

    /// The same at `time` after a change of `factor` times some rates.
    #[inline(always)]
    pub(crate) fn changed(&self, time: S, factor: S, rates: &Rates<M, S>) -> Integrated<M, S> {
        Integrated(self.0.changed(time, factor, rates))
    }

    /// The same at other positions.
    pub(crate) fn moved_to(self, positions: M::Q) -> Integrated<M, S> {
        Integrated(State { positions, ..self.0 })
    }

    /// The change from another.
    pub(crate) fn change_from(&self, from: &Integrated<M, S>) -> Rates<M, S> {
        let (a, b) = (&from.0, &self.0);
        Rates {
            positions: b.positions.zip_with(&a.positions, |b, a| *b - *a),
            speeds: b.speeds.zip_with(&a.speeds, |b, a| *b - *a),
            work: b.work - a.work,
        }
    }
}

/// The relation of speeds to velocity variables.
impl<M: Mechanism> Motion<M> {
    /// A state as what is integrated.
    #[inline(always)]
    pub(crate) fn integrated(&self, state: &State<M>) -> Integrated<M> {
        match self.is_in_generalized_speeds() {
            false => Integrated(state.clone()),
            true => Integrated(State { speeds: self.velocity_variables(state), ..state.clone() }),
        }
    }

    /// The integrated state.
    ///
    /// # Errors
    /// [`What::SpeedsUndetermined`].
    #[inline(always)]
    pub(crate) fn state(&self, Integrated(state): Integrated<M>) -> Result<State<M>, Failure> {
        match self.is_in_generalized_speeds() {
            false => Ok(state),
            true => Ok(State { speeds: self.speeds(&state, &state.speeds)?, ..state }),
        }
    }

    /// The same at the end of a step, so that the next one starts with the same velocity variables.
    ///
    /// # Errors
    /// [`What::SpeedsUndetermined`].
    #[inline(always)]
    pub(crate) fn end(&self, Integrated(state): Integrated<M>) -> Result<State<M>, Failure> {
        match self.is_in_generalized_speeds() {
            false => Ok(state),
            true => Ok(State { speeds: self.refined_speeds(&state, &state.speeds)?, ..state }),
        }
    }

    /// The rates of the integrated variables at a sample.
    #[inline(always)]
    pub(crate) fn rates(&self, sample: &Sample<M>) -> Rates<M> {
        self.rates_by(&sample.state, sample.accelerations.clone(), sample.power)
    }

    /// Those at a stage, which are written where they stay: a sample of it would be copied.
    ///
    /// # Errors
    /// As [`Motion::sample`], and [`What::SpeedsUndetermined`].
    #[inline(always)]
    pub(crate) fn rates_at(&self, integrated: Integrated<M>, rates: &mut Rates<M>) -> Result<(), Failure> {
        let mut state = self.state(integrated)?;
        let solved = self.dynamics(&mut state)?;
        *rates = self.rates_by(&state, solved.accelerations, solved.power);
        Ok(())
    }

    #[inline(always)]
    fn rates_by(&self, state: &State<M>, accelerations: M::Q, work: f64) -> Rates<M> {
        let speeds = match self.is_in_generalized_speeds() {
            false => accelerations,
            true => self.rates_of_velocity_variables(state, &accelerations),
        };
        Rates { positions: state.speeds.clone(), speeds, work }
    }

    /// A small change of the integrated variables at a state, as one of positions and speeds.
    ///
    /// # Errors
    /// [`What::SpeedsUndetermined`].
    #[inline(always)]
    pub(crate) fn in_speeds(&self, state: &State<M>, change: &Rates<M>) -> Result<(M::Q, M::Q), Failure> {
        if !self.is_in_generalized_speeds() {
            return Ok((change.positions.clone(), change.speeds.clone()));
        }
        let none = state.speeds.like(|_| 0.0);
        let [changed, unchanged] = [self.speeds(state, &change.speeds)?, self.speeds(state, &none)?];
        Ok((change.positions.clone(), changed.like(|i| changed[i] - unchanged[i])))
    }

    /// Projects a state in a way that may move its positions, and keeps its generalised speeds except for corrections
    /// by the remaining constraints.
    pub(crate) fn with_velocity_variables_kept(
        &self,
        state: &mut State<M>,
        bring: impl Fn(&mut State<M>) -> Result<(), Failure>,
    ) -> Result<(), Failure> {
        let kept = self.velocity_variables(state);
        bring(state)?;
        // If generalised speeds do not determine them, the projected speeds are used.
        if let Ok(speeds) = self.refined_speeds(state, &kept) {
            state.speeds = speeds;
            if self.mechanism().rows_left().is_some_and(|rows| !rows.is_empty()) {
                bring(state)?;
            }
        }
        Ok(())
    }

    fn velocity_variables(&self, state: &State<M>) -> M::Q {
        self.mechanism().velocity_variables(state.time, &state.positions, &state.speeds)
    }

    /// q' = N u + n.
    #[inline(always)]
    fn speeds(&self, at: &State<M>, variables: &M::Q) -> Result<M::Q, Failure> {
        let found = M::prepared_velocities(self.prepared(), at.time, &at.positions, variables);
        match found.refused {
            false => Ok(found.rates),
            true => Err(undetermined(self.mechanism(), at)),
        }
    }

    /// The same, corrected by the rounding of u - (W q' + w), which would accumulate over many short steps, since the
    /// squares of quaternions round alike in all of them.
    fn refined_speeds(&self, at: &State<M>, variables: &M::Q) -> Result<M::Q, Failure> {
        let speeds = self.speeds(at, variables)?;
        let found = self.velocity_variables(&State { speeds, ..at.clone() });
        self.speeds(at, &variables.like(|i| variables[i] + (variables[i] - found[i])))
    }

    /// u', the derivative of W q' + w along the motion.
    fn rates_of_velocity_variables(&self, state: &State<M>, accelerations: &M::Q) -> M::Q {
        let mechanism = self.mechanism().on(Dual::constant);
        let along = |values: &M::Q, rates: &M::Q| {
            DualQ::<M>::with_len(values.len(), |i| Dual { value: values[i], derivative: rates[i] })
        };
        let (q, qd) = (along(&state.positions, &state.speeds), along(&state.speeds, accelerations));
        let variables = mechanism.velocity_variables(Dual::variable(state.time), &q, &qd);
        state.speeds.like(|i| variables[i].derivative)
    }
}

#[cold]
fn undetermined<M: Mechanism>(mechanism: &M, at: &State<M>) -> Failure {
    Failure::at(mechanism, What::SpeedsUndetermined, at.time, &at.positions)
}
