//! Projection by the smallest corrections in the metric of the mass matrix.

use super::correct;
use crate::model::level::between_positions;
use crate::motion::equations::by_inertia;
use crate::motion::measures::Measures;
use crate::motion::reduction::Reduction;
use crate::motion::residuals::rates;
use crate::motion::rows::Dense;
use crate::numerics::arrays::subtract;
use crate::state::failure::Failure;
use crate::state::trajectory::State;
use sim_kernel::Mechanism;

/// The projections of [`project`](super::project) in the metric of the mass matrix M: q -= M^-1 C_q' (C_q M^-1 C_q')^-1 C, and so for q'.
///
/// # Errors
/// As the projection, and where the mass matrix does not determine the change.
pub(crate) fn by_mass<M: Mechanism>(
    mechanism: &M,
    measures: &Measures<M>,
    state: &mut State<M>,
) -> Result<(), Failure> {
    let (time, q) = (state.time, &mut state.positions);
    let mut linear = mechanism.constraint_linearization(time, q);
    correct::<f64, M, Dense>(mechanism, measures, (time, q), &mut linear, |linear, q, _| {
        let jacobian = between_positions(mechanism, &linear.jacobian);
        let rank = measures.rank_of_positions();
        smallest_by_inertia(mechanism, measures, time, q, (&jacobian, &linear.values), rank)
    })?;
    let open = rates(mechanism, &linear, &state.speeds);
    let change = smallest_by_inertia(mechanism, measures, time, q, (&linear.jacobian, &open), measures.rank())?;
    subtract(&mut state.speeds, &change);
    Ok(())
}

/// M^-1 C_q' (C_q M^-1 C_q')^-1 r, for C_q of this rank away from singular positions.
pub(crate) fn smallest_by_inertia<M: Mechanism>(
    mechanism: &M,
    measures: &Measures<M>,
    time: f64,
    q: &M::Q,
    (jacobian, open): (&M::LQ, &M::L),
    rank: usize,
) -> Result<M::Q, Failure> {
    if !measures.is_redundant() {
        return by_inertia(mechanism, time, q, jacobian, open);
    }
    let reduction = Reduction::new(mechanism, jacobian, measures, rank);
    by_inertia(mechanism, time, q, &reduction.rows(jacobian), &reduction.values(open))
}
