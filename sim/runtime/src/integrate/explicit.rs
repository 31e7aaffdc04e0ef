//! Explicit Runge-Kutta methods, on numbers of any kind.
//!
//! The right-hand side is compiled into the steps, and its rare cases (a refused pivot, partitioning, projected stages)
//! take and give states by value in functions of their own, so that the states of stages stay in registers.

use super::dense::{cubic, nested};
use super::method::{Advance, Attempt};
use super::tableau::{ErrorEstimate, MOST_STAGES, RK4, Tableau, Weight};
use crate::motion::Motion;
use crate::motion::field::Field;
use crate::motion::velocity_variables::Integrated;
use crate::state::failure::{Failure, What};
use crate::state::interpolate::{hermite, linear};
use crate::state::settings::Tolerance;
use crate::state::trajectory::{Rates, Sample, State};
use sim_kernel::{Array, Mechanism, Scalar};

/// What changes positions by no more than this in a step, beside what counts as 1, is rounding.
const LEAST_CHANGE: f64 = 1e-15;

/// The method of a tableau, with the stages of its last step.
#[derive(Clone, Debug)]
pub struct ExplicitRungeKutta<M: Mechanism<S>, S: Scalar = f64> {
    tableau: &'static Tableau,
    is_rk4: bool,
    pub(super) stages: [Rates<M, S>; MOST_STAGES],
}

impl<S: Scalar, M: Mechanism<S>> ExplicitRungeKutta<M, S> {
    /// The method of a tableau.
    pub fn new(mechanism: &M, tableau: &'static Tableau) -> ExplicitRungeKutta<M, S> {
        let stages = std::array::from_fn(|_| Rates::zero(mechanism.n()));
        ExplicitRungeKutta { tableau, is_rk4: *tableau == RK4, stages }
    }

    /// Whether states inside a step need its stages.
    pub(super) fn has_dense_output(&self) -> bool {
        !self.tableau.dense.is_empty()
    }

    /// Takes the stages of a step that was made on other numbers.
    pub(super) fn take_stages<T: Scalar, N: Mechanism<T>>(
        &mut self,
        made: &ExplicitRungeKutta<N, T>,
        number: impl Fn(T) -> S,
    ) {
        for (stage, made) in self.stages.iter_mut().zip(&made.stages).take(self.tableau.c.len()) {
            stage.positions = stage.positions.like(|i| number(made.positions[i]));
            stage.speeds = stage.speeds.like(|i| number(made.speeds[i]));
            stage.work = number(made.work);
        }
    }

    /// Evaluates a stage from those before it.
    #[inline(always)]
    pub(super) fn evaluate(
        &mut self,
        field: &impl Field<M, S>,
        start: &Integrated<M, S>,
        h: S,
        stage: usize,
        (weights, node): (&[Weight], f64),
    ) -> Result<(), Failure> {
        let inner = start.changed(start.time() + S::from_f64(node) * h, h, &self.combined(weights));
        field.stage(inner, &mut self.stages[stage])
    }

    /// The sum of weight times stage.
    #[inline(always)]
    pub(super) fn combined(&self, weights: &[Weight]) -> Rates<M, S> {
        let Some(((first, weight), others)) = weights.split_first() else { return self.stages[0].scaled(S::ZERO) };
        let mut sum = self.stages[*first].scaled(S::from_f64(*weight));
        others.iter().for_each(|(stage, weight)| sum.add(S::from_f64(*weight), &self.stages[*stage]));
        sum
    }

    #[inline(always)]
    fn stage(
        &mut self,
        tableau: &Tableau,
        stage: usize,
        field: &impl Field<M, S>,
        start: &Integrated<M, S>,
        h: S,
    ) -> Result<(), Failure> {
        self.evaluate(field, start, h, stage, (tableau.a[stage], tableau.c[stage]))
    }

    /// The end of a step from its stages.
    #[inline(always)]
    fn finish(
        &self,
        tableau: &Tableau,
        field: &impl Field<M, S>,
        (from, start): (&State<M, S>, &Integrated<M, S>),
        time: S,
        tolerance: Option<&Tolerance>,
    ) -> Result<Attempt<M, S>, Failure> {
        let h = time - from.time;
        let end = field.end(start.changed(time, h, &self.combined(tableau.b)))?;
        if !end.is_finite() {
            return Err(not_finite(field.mechanism(), from));
        }
        let error = tolerance.map_or(Ok(S::ZERO), |tolerance| self.error(field, [from, &end], h, tolerance))?;
        Ok(Attempt { end, error })
    }

    /// The estimated error of a step in units of the tolerance.
    fn error(
        &self,
        field: &impl Field<M, S>,
        [from, to]: [&State<M, S>; 2],
        h: S,
        tolerance: &Tolerance,
    ) -> Result<S, Failure> {
        let size = |weights: &[Weight]| {
            let (positions, speeds) = field.in_speeds(from, &self.combined(weights))?;
            Ok(h.abs() * tolerance.norm(field.measures(), from, to, [&positions, &speeds]))
        };
        match self.tableau.error {
            ErrorEstimate::None => Ok(S::ZERO),
            ErrorEstimate::Embedded(weights) => size(weights),
            ErrorEstimate::Embedded53(fifth, third) => {
                let (e5, e3) = (size(fifth)?, size(third)?);
                // (II.10.17); both are zero in equilibrium.
                let norm = e5 * e5 / (e5 * e5 + S::from_f64(0.01) * e3 * e3).sqrt();
                Ok(S::select(e5.at_most(S::ZERO), S::ZERO, norm))
            }
        }
    }

    /// Advances from a sample to a time: see [`Advance::step`].
    ///
    /// # Errors
    /// As the right-hand side; if any lane fails.
    #[inline(always)]
    pub(crate) fn advance(
        &mut self,
        field: &impl Field<M, S>,
        from: &Sample<M, S>,
        time: S,
        tolerance: Option<&Tolerance>,
    ) -> Result<Attempt<M, S>, Failure> {
        let (tableau, start) = (self.tableau, &field.integrated(&from.state));
        let h = time - from.state.time;
        self.stages[0] = field.rates(from);
        if self.is_rk4 && tolerance.is_none() {
            // Written out with constant weights: straight-line code, which saves a twentieth of a run.
            self.stage(&RK4, 1, field, start, h)?;
            self.stage(&RK4, 2, field, start, h)?;
            self.stage(&RK4, 3, field, start, h)?;
            return self.finish(&RK4, field, (&from.state, start), time, None);
        }
        // The last stage of an embedded pair serves its estimate alone.
        let needed = if tolerance.is_none() { tableau.stages_of_step() } else { tableau.c.len() };
        for stage in 1..needed {
            self.stage(tableau, stage, field, start, h)?;
        }
        self.finish(tableau, field, (&from.state, start), time, tolerance)
    }
}

impl<M: Mechanism> Advance<M> for ExplicitRungeKutta<M> {
    fn gap(&self) -> f64 {
        self.tableau.gap()
    }

    /// By the change of accelerations over that of speeds between the end and the stage before it, which is at the same time (Hairer
    /// and Wanner, Solving Ordinary Differential Equations II, section IV.2, who take all of the state).
    fn stiffness(&self, motion: &Motion<M>, from: &Sample<M>, to: &Sample<M>) -> Option<f64> {
        let (last, most) = self.tableau.stability()?;
        let (h, rates) = (to.state.time - from.state.time, motion.rates(to));
        let [of_stage, of_end] = [self.tableau.a[last], self.tableau.b].map(|weights| self.combined(weights).speeds);
        let apart = motion.size(&of_end.like(|i| h * (of_end[i] - of_stage[i])));
        let faster = motion.size(&rates.speeds.like(|i| h * (rates.speeds[i] - self.stages[last].speeds[i])));
        (h * faster > LEAST_CHANGE && apart > 0.0).then(|| faster / apart / most)
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
        self.advance(motion, from, time, tolerance)
    }

    /// Linear for methods of order 1: positions that have followed the speeds at the start contradict those at the end, and a
    /// polynomial of both would swing between them. For others positions by the quintic of both ends. Its derivative would lose the digits of speeds to differences of large
    /// positions, and no cubic has the work as accurately as the step: both are those of the method's own dense output, if
    /// it has one.
    fn inside(
        &mut self,
        motion: &Motion<M>,
        from: &Sample<M>,
        to: &Sample<M>,
        fraction: f64,
    ) -> Result<State<M>, Failure> {
        if self.tableau.order == 1 {
            return Ok(linear(from, to, fraction));
        }
        let between = hermite(from, to, fraction);
        let Some((last, _)) = self.tableau.dense.last() else { return Ok(between) };
        let rates = [from, to].map(|sample| motion.rates(sample));
        let [first, second, third] = cubic(motion, [from, to], rates.each_ref());
        let [_, end] = rates;
        self.stages[*last] = end;
        let fourth = self.combined(self.tableau.dense).scaled(to.state.time - from.state.time);
        let change = nested(&[first, second, third, fourth], fraction);
        let found = motion.integrated(&from.state).changed(between.time, 1.0, &change);
        motion.state(found.moved_to(between.positions))
    }
}

#[cold]
fn not_finite<S: Scalar, M: Mechanism<S>>(mechanism: &M, start: &State<M, S>) -> Failure {
    let what = What::NotFinite { quantity: "the state after this step".into() };
    Failure::at(mechanism, what, start.time, &start.positions)
}
