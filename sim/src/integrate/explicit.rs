//! Explicit Runge-Kutta methods.
//!
//! The right-hand side is compiled into the steps, and its rare cases (a refused pivot, partitioning, projected stages)
//! take and give states by value in functions of their own, so that the states of stages stay in registers.

use super::method::{Advance, Attempt};
use super::tableau::{ErrorEstimate, MOST_STAGES, RK4, Tableau, Weight};
use crate::motion::Motion;
use crate::motion::velocity_variables::Integrated;
use crate::state::failure::{Failure, What};
use crate::state::settings::Tolerance;
use crate::state::trajectory::{Rates, Sample, State};
use sim_kernel::Mechanism;

/// The method of a tableau, with the stages of its last step.
#[derive(Clone, Debug)]
pub struct ExplicitRungeKutta<M: Mechanism> {
    tableau: &'static Tableau,
    is_rk4: bool,
    pub(super) stages: [Rates<M>; MOST_STAGES],
}

impl<M: Mechanism> ExplicitRungeKutta<M> {
    /// The method of a tableau.
    pub fn new(mechanism: &M, tableau: &'static Tableau) -> ExplicitRungeKutta<M> {
        ExplicitRungeKutta { tableau, is_rk4: *tableau == RK4, stages: [Rates::zero(mechanism.n()); MOST_STAGES] }
    }

    /// Evaluates a stage from those before it.
    #[inline(always)]
    pub(super) fn evaluate(
        &mut self,
        motion: &Motion<M>,
        start: &Integrated<M>,
        h: f64,
        stage: usize,
        (weights, node): (&[Weight], f64),
    ) -> Result<(), Failure> {
        let inner = start.changed(start.time() + node * h, h, &self.combined(weights));
        self.stages[stage] = motion.rates(&motion.sample_in_place(motion.state(inner)?)?);
        Ok(())
    }

    /// The sum of weight times stage.
    #[inline(always)]
    pub(super) fn combined(&self, weights: &[Weight]) -> Rates<M> {
        let Some(((first, weight), others)) = weights.split_first() else { return self.stages[0].scaled(0.0) };
        let mut sum = self.stages[*first].scaled(*weight);
        others.iter().for_each(|(stage, weight)| sum.add(*weight, &self.stages[*stage]));
        sum
    }

    #[inline(always)]
    fn stage(
        &mut self,
        tableau: &Tableau,
        stage: usize,
        motion: &Motion<M>,
        start: &Integrated<M>,
        h: f64,
    ) -> Result<(), Failure> {
        self.evaluate(motion, start, h, stage, (tableau.a[stage], tableau.c[stage]))
    }

    /// The end of a step from its stages.
    #[inline(always)]
    fn finish(
        &self,
        tableau: &Tableau,
        motion: &Motion<M>,
        (from, start): (&State<M>, &Integrated<M>),
        time: f64,
        tolerance: Option<&Tolerance>,
    ) -> Result<Attempt<M>, Failure> {
        let h = time - from.time;
        let end = motion.end(start.changed(time, h, &self.combined(tableau.b)))?;
        if !end.is_finite() {
            return Err(not_finite(motion.mechanism(), from));
        }
        let error = tolerance.map_or(Ok(0.0), |tolerance| self.error(motion, [from, &end], h, tolerance))?;
        Ok(Attempt { end, error })
    }

    /// The estimated error of a step in units of the tolerance.
    fn error(
        &self,
        motion: &Motion<M>,
        [from, to]: [&State<M>; 2],
        h: f64,
        tolerance: &Tolerance,
    ) -> Result<f64, Failure> {
        let size = |weights: &[Weight]| {
            let difference = motion.in_speeds(from, &self.combined(weights))?;
            Ok(h.abs() * tolerance.norm(motion.measures(), from, to, &difference))
        };
        match self.tableau.error {
            ErrorEstimate::None => Ok(0.0),
            ErrorEstimate::Embedded(weights) => size(weights),
            ErrorEstimate::Embedded53(fifth, third) => {
                let (e5, e3) = (size(fifth)?, size(third)?);
                // (II.10.17); both are zero in equilibrium.
                Ok(if e5 == 0.0 { 0.0 } else { e5 * e5 / (e5 * e5 + 0.01 * e3 * e3).sqrt() })
            }
        }
    }
}

impl<M: Mechanism> Advance<M> for ExplicitRungeKutta<M> {
    fn gap(&self) -> f64 {
        self.tableau.gap()
    }

    fn control_order(&self) -> Option<f64> {
        (self.tableau.error != ErrorEstimate::None).then_some(self.tableau.order as f64)
    }

    #[inline]
    fn step(
        &mut self,
        motion: &Motion<M>,
        from: &Sample<M>,
        time: f64,
        tolerance: Option<&Tolerance>,
    ) -> Result<Attempt<M>, Failure> {
        let (tableau, start) = (self.tableau, &motion.integrated(&from.state));
        let h = time - from.state.time;
        self.stages[0] = motion.rates(from);
        if self.is_rk4 && tolerance.is_none() {
            // Written out with constant weights: straight-line code, which saves a twentieth of a run.
            self.stage(&RK4, 1, motion, start, h)?;
            self.stage(&RK4, 2, motion, start, h)?;
            self.stage(&RK4, 3, motion, start, h)?;
            return self.finish(&RK4, motion, (&from.state, start), time, None);
        }
        // The last stage of an embedded pair serves its estimate alone.
        let needed = if tolerance.is_none() { tableau.stages_of_step() } else { tableau.c.len() };
        for stage in 1..needed {
            self.stage(tableau, stage, motion, start, h)?;
        }
        self.finish(tableau, motion, (&from.state, start), time, tolerance)
    }
}

#[cold]
fn not_finite<M: Mechanism>(mechanism: &M, start: &State<M>) -> Failure {
    let what = What::NotFinite { quantity: "the state after this step".into() };
    Failure::at(mechanism, what, start.time, &start.positions)
}
