//! How an assembled start changes with parameters and given values.

use super::assemble::{Start, least_norm_solution};
use crate::model::AnyMechanism;
use crate::motion::residuals::rates;
use crate::motion::typed::Any;
use crate::state::failure::{Failure, What};
use crate::state::trajectory::State;
use nalgebra::DVector;
use sim_kernel::{Array, Dual, Mechanism};

/// A direction in which parameters and given values of a start change: so much of each for one unit of the change.
#[derive(Clone, Debug)]
pub struct Direction<M: Mechanism> {
    /// Of the parameters, in SI units.
    pub parameters: M::Parameters,
    /// Of the given positions.
    pub positions: M::Q,
    /// Of the given speeds.
    pub speeds: M::Q,
}

impl<M: Mechanism> Direction<M> {
    /// Whether it has a finite number for each parameter, coordinate and speed.
    pub(crate) fn suits(&self, mechanism: &M) -> bool {
        let lengths = [self.parameters.len(), self.positions.len(), self.speeds.len()];
        let all = self.parameters.iter().chain(self.positions.iter()).chain(self.speeds.iter());
        lengths == [mechanism.parameters().len(), mechanism.n(), mechanism.n()] && all.copied().all(f64::is_finite)
    }
}

/// A state on dual numbers.
type DualState<M> = State<<M as Mechanism>::On<Dual>, Dual>;

/// An assembled state with its derivative in a direction: `lifted` is the mechanism with parameters that change in it.
/// Positions and speeds that are not given follow from the constraints; where these leave a choice, by the smallest
/// change.
///
/// # Errors
/// [`What::NotFinite`] if the constraints have no derivative there.
pub(crate) fn along<M: Mechanism>(
    (mechanism, lifted): (&M, &M::On<Dual>),
    start: &Start<M>,
    state: &State<M>,
    direction: &Direction<M>,
) -> Result<DualState<M>, Failure> {
    let mut found: DualState<M> = State {
        time: Dual::constant(state.time),
        positions: with_rates(&state.positions, &direction.positions, &start.position_given),
        speeds: with_rates(&state.speeds, &direction.speeds, &start.speed_given),
        work: Dual::constant(state.work),
    };
    let any = Any(mechanism);
    let solve = |jacobian, given: &[bool], open: &[Dual]| {
        let open = DVector::from_iterator(open.len(), open.iter().map(|value| value.derivative));
        let quantity = || "the derivative of a constraint in this direction".to_owned();
        least_norm_solution(jacobian, given, &open).ok_or_else(|| {
            Failure::at(mechanism, What::NotFinite { quantity: quantity() }, state.time, &state.positions)
        })
    };
    let jacobian = any.constraint_jacobian(state.time, state.positions.as_ref());
    let linear = lifted.constraint_linearization(found.time, &found.positions);
    let between_positions = any.between_positions(jacobian.clone());
    subtract(&mut found.positions, &solve(between_positions, &start.position_given, linear.values.as_ref())?);
    let linear = lifted.constraint_linearization(found.time, &found.positions);
    let open = rates(lifted, &linear, &found.speeds);
    subtract(&mut found.speeds, &solve(jacobian, &start.speed_given, open.as_ref())?);
    Ok(found)
}

/// Numbers with the rates of those that are given.
fn with_rates<A: Array<f64>, B: Array<Dual>>(values: &A, rates: &A, given: &[bool]) -> B {
    let rate = |i: usize| if given[i] { rates[i] } else { 0.0 };
    B::with_len(values.len(), |i| Dual { value: values[i], derivative: rate(i) })
}

/// Subtracts rates.
fn subtract(values: &mut impl Array<Dual>, rates: &DVector<f64>) {
    values.as_mut().iter_mut().zip(rates).for_each(|(value, rate)| value.derivative -= rate);
}
