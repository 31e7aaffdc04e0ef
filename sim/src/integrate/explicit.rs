//! Explicit Runge-Kutta methods.

use super::method::{Advance, Attempt};
use super::tableau::{ErrorEstimate, MOST_STAGES, RK4, Tableau, Weight};
use crate::failure::{Failure, What};
use crate::motion::Motion;
use crate::settings::Tolerance;
use crate::trajectory::{Rates, Sample, State};
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
    pub fn new(tableau: &'static Tableau) -> ExplicitRungeKutta<M> {
        ExplicitRungeKutta { tableau, is_rk4: *tableau == RK4, stages: [Rates::zero(); MOST_STAGES] }
    }

    /// Evaluates a stage from those before it.
    #[inline(always)]
    pub(super) fn evaluate(
        &mut self,
        motion: &Motion<M>,
        start: &State<M>,
        h: f64,
        stage: usize,
        (weights, node): (&[Weight], f64),
    ) -> Result<(), Failure> {
        let inner = start.changed(start.time + node * h, h, &self.combined(weights));
        self.stages[stage] = motion.sample(inner)?.rates();
        Ok(())
    }

    /// The sum of weight times stage.
    #[inline(always)]
    pub(super) fn combined(&self, weights: &[Weight]) -> Rates<M> {
        let Some(((first, weight), others)) = weights.split_first() else { return Rates::zero() };
        let mut sum = self.stages[*first].scaled(*weight);
        others.iter().for_each(|(stage, weight)| sum.add(*weight, &self.stages[*stage]));
        sum
    }

    /// One step. Inlined with a constant tableau it is straight-line code.
    #[inline(always)]
    fn step_by(
        &mut self,
        tableau: &Tableau,
        motion: &Motion<M>,
        from: &Sample<M>,
        time: f64,
        tolerance: Option<&Tolerance>,
    ) -> Result<Attempt<M>, Failure> {
        let start = &from.state;
        let h = time - start.time;
        self.stages[0] = from.rates();
        // The last stage of an embedded pair serves its estimate alone.
        let needed = if tolerance.is_none() { tableau.stages_of_step() } else { tableau.c.len() };
        if needed == 4 {
            self.evaluate(motion, start, h, 1, (tableau.a[1], tableau.c[1]))?;
            self.evaluate(motion, start, h, 2, (tableau.a[2], tableau.c[2]))?;
            self.evaluate(motion, start, h, 3, (tableau.a[3], tableau.c[3]))?;
        } else {
        for stage in 1..needed {
            self.evaluate(motion, start, h, stage, (tableau.a[stage], tableau.c[stage]))?;
        }
        }
        let end = start.changed(time, h, &self.combined(tableau.b));
        if !end.is_finite() {
            return Err(not_finite(start));
        }
        let error = tolerance.map_or(0.0, |tolerance| self.error(start, &end, h, tolerance));
        Ok(Attempt { end, error })
    }

    /// The estimated error of a step in units of the tolerance.
    fn error(&self, from: &State<M>, to: &State<M>, h: f64, tolerance: &Tolerance) -> f64 {
        let size = |weights: &[Weight]| {
            let difference = self.combined(weights);
            h.abs() * tolerance.norm(from, to, &(difference.positions, difference.speeds))
        };
        match self.tableau.error {
            ErrorEstimate::None => 0.0,
            ErrorEstimate::Embedded(weights) => size(weights),
            ErrorEstimate::Embedded53(fifth, third) => {
                let (e5, e3) = (size(fifth), size(third));
                // (II.10.17); both are zero in equilibrium.
                if e5 == 0.0 { 0.0 } else { e5 * e5 / (e5 * e5 + 0.01 * e3 * e3).sqrt() }
            }
        }
    }
}

impl<M: Mechanism> Advance<M> for ExplicitRungeKutta<M> {
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
        // The report's method, with which most equal steps are made, is compiled with its numbers.
        match self.is_rk4 {
            true => self.step_by(&RK4, motion, from, time, tolerance),
            false => self.step_by(self.tableau, motion, from, time, tolerance),
        }
    }
}

#[cold]
fn not_finite<M: Mechanism>(start: &State<M>) -> Failure {
    let what = What::NotFinite { quantity: "the state after this step".into() };
    Failure::at::<M>(what, start.time, &start.positions)
}
