//! Projection with redundant constraints: C_q and the residuals are first reduced to the rank of C_q ([`Reduction`]).

use super::{Linearization, check_dependent_rates, correct, factorise, least_change, singular_position};
use crate::model::level::between_positions;
use crate::motion::measures::Measures;
use crate::motion::reduction::Reduction;
use crate::motion::residuals::rates;
use crate::motion::rows::{Dense, Rows};
use crate::numerics::arrays::subtract;
use crate::state::failure::Failure;
use crate::state::trajectory::State;
use sim_kernel::Mechanism;

/// The factors of the products of rows.
type Factors<M> = <Dense as Rows<f64, M>>::Factors;

/// Corrects positions and speeds; gives 1/s^2, with s the smallest sine between rows of C_q D. Rows of the reduced C_q count relative to 1.
#[cold]
pub(super) fn project_redundant<M: Mechanism>(
    mechanism: &M,
    measures: &Measures<M>,
    state: &mut State<M>,
) -> Result<f64, Failure> {
    let (time, q) = (state.time, &mut state.positions);
    let mut linear = mechanism.constraint_linearization(time, q);
    correct_redundant_positions(mechanism, measures, (time, q), &mut linear)?;
    let (change, factors) = reduced_change(
        mechanism,
        measures,
        (&linear.jacobian, measures.rank()),
        &rates(mechanism, &linear, &state.speeds),
        time,
        q,
    )?;
    if <Dense as Rows<f64, M>>::dependent(mechanism, &factors).count() > mechanism.m() - measures.rank() {
        return Err(singular_position::<f64, M, Dense>(mechanism, &factors, time, q));
    }
    subtract(&mut state.speeds, &change);
    check_dependent_rates::<f64, M, Dense>(mechanism, &linear, measures, time, q, &state.speeds)?;
    Ok((0..measures.rank()).fold(0.0, |closeness, row| closeness.max(factors.row(row).1)))
}

/// Corrects positions, at which the constraints are linearised, until these are met; leaves them linearised there.
pub(super) fn correct_redundant_positions<M: Mechanism>(
    mechanism: &M,
    measures: &Measures<M>,
    (time, q): (f64, &mut M::Q),
    linear: &mut Linearization<M>,
) -> Result<(), Failure> {
    correct::<f64, M, Dense>(mechanism, measures, (time, q), linear, |linear, q, _| {
        let jacobian = between_positions(mechanism, &linear.jacobian);
        let rank = measures.rank_of_positions();
        reduced_change(mechanism, measures, (&jacobian, rank), &linear.values, time, q).map(|(change, _)| change)
    })
    .map(|_| ())
}

/// The smallest change along rows of C_q of this rank that closes the residuals of the constraints or of their rates,
/// with the factors of the reduced rows.
pub(super) fn reduced_change<M: Mechanism>(
    mechanism: &M,
    measures: &Measures<M>,
    (jacobian, rank): (&M::LQ, usize),
    open: &M::L,
    time: f64,
    q: &M::Q,
) -> Result<(M::Q, Factors<M>), Failure> {
    let reduction = Reduction::new(mechanism, jacobian, measures, rank);
    let columns = measures.columns(mechanism, &reduction.rows(jacobian));
    let mut factors = Dense::no_factors(mechanism);
    factorise::<f64, M, Dense>(mechanism, &columns, false, &mut factors, time, q)?;
    Ok((least_change::<f64, M, Dense>(mechanism, measures, &columns, &factors, reduction.values(open)), factors))
}
