//! DOP853 with its dense output of order 7.

use super::dense::{cubic, nested};
use super::dop853_tableau::{DENSE_A, DENSE_C, DENSE_D, DOP853};
use super::explicit::ExplicitRungeKutta;
use super::method::{Advance, Attempt};
use crate::motion::Motion;
use crate::state::failure::Failure;
use crate::state::saved::{Bytes, Damaged};
use crate::state::settings::Tolerance;
use crate::state::trajectory::{Rates, Sample, State};
use sim_kernel::{Array, Mechanism, Scalar};

/// The method, with the interpolant of its last step once it has been asked for.
///
/// Hairer, Norsett, Wanner, Solving Ordinary Differential Equations I, (II.6.30) on. The interpolant has the projected
/// end and the right-hand side there, where the source has the end before projection: its first derivative is continuous
/// from step to step. Three more right-hand sides are evaluated for a step that is looked into.
#[derive(Clone, Debug)]
pub struct Dop853<M: Mechanism> {
    method: ExplicitRungeKutta<M>,
    /// Coefficients of the interpolant in s, 1 - s, s, ..
    interpolant: Option<[Rates<M>; 7]>,
}

impl<M: Mechanism> Dop853<M> {
    /// The method.
    pub fn new(mechanism: &M) -> Dop853<M> {
        Dop853 { method: ExplicitRungeKutta::new(mechanism, &DOP853), interpolant: None }
    }

    /// Takes the stages of a step that was made on other numbers.
    pub(super) fn take_stages<S: Scalar, N: Mechanism<S>>(
        &mut self,
        made: &ExplicitRungeKutta<N, S>,
        number: impl Fn(S) -> f64,
    ) {
        self.interpolant = None;
        self.method.take_stages(made, number);
    }

    /// The interpolant as bytes, or from them.
    pub(super) fn transfer(&mut self, bytes: &mut Bytes) -> Result<(), Damaged> {
        let none = Rates::zero(self.method.stages[0].positions.len());
        bytes.option(
            &mut self.interpolant,
            || std::array::from_fn(|_| none.clone()),
            |bytes, coefficients| {
                coefficients.iter_mut().try_for_each(|rates| {
                    bytes.numbers(rates.positions.as_mut())?;
                    bytes.numbers(rates.speeds.as_mut())?;
                    bytes.number(&mut rates.work)
                })
            },
        )
    }

    fn coefficients(&mut self, motion: &Motion<M>, from: &Sample<M>, to: &Sample<M>) -> Result<[Rates<M>; 7], Failure> {
        let h = to.state.time - from.state.time;
        let (start, rates) = (motion.integrated(&from.state), [from, to].map(|sample| motion.rates(sample)));
        self.method.stages[12] = rates[1].clone();
        for (k, (weights, node)) in DENSE_A.iter().zip(DENSE_C).enumerate() {
            self.method.evaluate(motion, &start, h, 13 + k, (weights, node))?;
        }
        let [first, second, third] = cubic(motion, [from, to], rates.each_ref());
        let [a, b, c, d] = DENSE_D.map(|weights| self.method.combined(weights).scaled(h));
        Ok([first, second, third, a, b, c, d])
    }
}

impl<M: Mechanism> Advance<M> for Dop853<M> {
    fn gap(&self) -> f64 {
        self.method.gap()
    }

    fn stiffness(&self, motion: &Motion<M>, from: &Sample<M>, to: &Sample<M>) -> Option<f64> {
        self.method.stiffness(motion, from, to)
    }

    fn control_order(&self) -> Option<f64> {
        self.method.control_order()
    }

    fn step(
        &mut self,
        motion: &Motion<M>,
        from: &Sample<M>,
        time: f64,
        tolerance: Option<&Tolerance>,
    ) -> Result<Attempt<M>, Failure> {
        self.interpolant = None;
        self.method.step(motion, from, time, tolerance)
    }

    fn inside(
        &mut self,
        motion: &Motion<M>,
        from: &Sample<M>,
        to: &Sample<M>,
        fraction: f64,
    ) -> Result<State<M>, Failure> {
        // Computed once for a step, and left where it is: a copy would take as long as its use.
        if self.interpolant.is_none() {
            self.interpolant = Some(self.coefficients(motion, from, to)?);
        }
        let change = nested(self.interpolant.as_ref().map_or(&[], |coefficients| &coefficients[..]), fraction);
        let time = from.state.time + fraction * (to.state.time - from.state.time);
        motion.state(motion.integrated(&from.state).changed(time, 1.0, &change))
    }
}
