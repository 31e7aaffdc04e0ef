//! Projection onto the constraints: positions by Gauss-Newton, velocities by one linear correction.
//!
//! Both corrections are the smallest, with lengths measured by the mechanism's own length: with D the diagonal matrix
//! of the coordinates' scales, q -= D^2 C_q' (C_q D^2 C_q')^-1 C and q' -= D^2 C_q' (C_q D^2 C_q')^-1 (C_q q' + C_t);
//! or on request they are the smallest in the metric of the mass matrix. With redundant constraints, C_q and the
//! residuals are first reduced to the rank of C_q (`redundant`).
//!

mod redundant;

use crate::model::level::{between_positions, has_speed_rows};
use crate::motion::equations::by_inertia;
use crate::motion::measures::Measures;
use crate::motion::met::{TOLERANCE, is_met, is_within};
use crate::motion::reduction::Reduction;
use crate::motion::residuals::{rates, rates_of};
use crate::motion::rows::{Dense, Linear, Rows, Sparse, is_sparse};
use crate::numerics::arrays::subtract;
use crate::state::failure::{Failure, What, constraint_name, largest};
use crate::state::trajectory::State;
use redundant::{correct_redundant_positions, project_redundant, reduced_change};
use sim_kernel::{Array, ConstraintLinearization, Mechanism};
use std::cell::Cell;

/// Corrections after which a projection that has not converged is given up.
const MOST_CORRECTIONS: usize = 10;
/// A change of positions that is rounding, relative to those that count as 1.
const ROUNDING: f64 = 1e-14;
/// A change of positions, and rates of constraints relative to their terms, below which one factorisation serves both
/// projections: the residual of the rates is of the order of their product.
const SMALL_CHANGE: f64 = 1e-8;
const SMALL_RATE: f64 = 1e-5;

type Linearization<M> = ConstraintLinearization<<M as Mechanism>::L, <M as Mechanism>::LQ>;

/// Corrects positions and speeds, as [`project_positions`] and [`project_velocities`] one after the other.
///
/// # Errors
/// As those, and [`What::SingularPosition`] where constraints are dependent that were independent at the start.
#[inline]
pub fn project<M: Mechanism>(mechanism: &M, measures: &Measures<M>, state: &mut State<M>) -> Result<(), Failure> {
    project_measured(mechanism, measures, state, &Cell::new(M::L::repeat(mechanism.m(), 0.0))).map(|_| ())
}

/// The same; gives 1/s^2, where s is the smallest sine between a row of C_q D and those before it, of those that are
/// independent. Rows count relative to their greatest length so far, whose squares it keeps.
#[inline]
pub(crate) fn project_measured<M: Mechanism>(
    mechanism: &M,
    measures: &Measures<M>,
    state: &mut State<M>,
    longest: &Cell<M::L>,
) -> Result<f64, Failure> {
    if mechanism.m() == 0 {
        return Ok(0.0);
    }
    if measures.is_redundant() {
        return project_redundant(mechanism, measures, state);
    }
    match is_sparse(mechanism) {
        false => project_independent::<M, Dense>(mechanism, measures, state, longest),
        true => project_independent::<M, Sparse>(mechanism, measures, state, longest),
    }
}

/// The same without redundant constraints.
#[inline(always)]
fn project_independent<M: Mechanism, R: Rows<M>>(
    mechanism: &M,
    measures: &Measures<M>,
    state: &mut State<M>,
    longest: &Cell<M::L>,
) -> Result<f64, Failure> {
    let (time, q) = (state.time, &mut state.positions);
    let (mut linear, mut factors) = (R::linearization(mechanism, time, q), R::no_factors(mechanism));
    let last_change = correct_positions::<M, R>(mechanism, measures, (time, q), &mut linear, &mut factors)?;
    let open = rates_of::<M, R>(mechanism, &linear, &state.speeds);
    let is_slow = |row: usize| open[row].abs() <= SMALL_RATE * measures.constraints()[row];
    let serves = !has_speed_rows(mechanism) && last_change <= SMALL_CHANGE && (0..mechanism.m()).all(is_slow);
    let columns = R::columns(mechanism, &linear.jacobian, measures);
    if !serves {
        factorise_again::<M, R>(mechanism, &columns, &mut factors, time, q)?;
    }
    if !R::is_regular(mechanism, &factors)
        && R::dependent(mechanism, &factors).count() > mechanism.m() - measures.rank()
    {
        return Err(singular_position::<M, R>(mechanism, &factors, time, q));
    }
    subtract(&mut state.speeds, &least_change::<M, R>(mechanism, measures, &columns, &factors, open));
    if !R::is_regular(mechanism, &factors) {
        check_dependent_rates::<M, R>(mechanism, &linear, measures, time, q, &state.speeds)?;
    }
    let (mut squares, mut closeness) = (longest.get(), 0.0f64);
    for k in 0..mechanism.m() {
        let (row, (square, inverse_pivot)) = (R::constraint(mechanism, k), R::pivot(mechanism, &factors, k));
        squares[row] = squares[row].max(square);
        closeness = closeness.max(squares[row] * inverse_pivot);
    }
    longest.set(squares);
    Ok(closeness)
}

#[cold]
fn singular_position<M: Mechanism, R: Rows<M>>(mechanism: &M, factors: &R::Factors, time: f64, q: &M::Q) -> Failure {
    let constraint = R::dependent(mechanism, factors)
        .last()
        .map_or("?", |k| constraint_name(mechanism, R::constraint(mechanism, k)));
    Failure::at(mechanism, What::SingularPosition { constraint }, time, q)
}

/// Corrects positions until |C_i| <= 8 eps (magnitudes of C_i's terms + sum of |C_ij q_j|) + 1e-12 of the constraint's
/// scale, once at least; gives the constraints linearised there.
///
/// An absolute tolerance alone could not be met by constraints with large terms, and without the first correction
/// the projection would set in at some step and spoil the order of the method.
///
/// # Errors
/// [`What::NotProjected`] after ten corrections, [`What::NotFinite`] if a constraint leaves its domain.
#[inline]
pub fn project_positions<M: Mechanism>(
    mechanism: &M,
    measures: &Measures<M>,
    time: f64,
    q: &mut M::Q,
) -> Result<Linearization<M>, Failure> {
    let mut linear = mechanism.constraint_linearization(time, q);
    match mechanism.m() {
        0 => {}
        _ if measures.is_redundant() => correct_redundant_positions(mechanism, measures, (time, q), &mut linear)?,
        _ => {
            let mut factors = Dense::no_factors(mechanism);
            correct_positions::<M, Dense>(mechanism, measures, (time, q), &mut linear, &mut factors)?;
        }
    }
    Ok(linear)
}

/// Corrects velocities at a position where the constraints are already linearised.
///
/// # Errors
/// [`What::DependentConstraint`] if a constraint that depends on others here contradicts them.
#[inline]
pub fn project_velocities<M: Mechanism>(
    mechanism: &M,
    measures: &Measures<M>,
    linear: &Linearization<M>,
    time: f64,
    q: &M::Q,
    qd: &mut M::Q,
) -> Result<(), Failure> {
    if mechanism.m() == 0 {
        return Ok(());
    }
    if measures.is_redundant() {
        return project_redundant_velocities(mechanism, measures, linear, time, q, qd);
    }
    let open = rates(mechanism, linear, qd);
    let columns = measures.columns(mechanism, &linear.jacobian);
    let mut factors = Dense::no_factors(mechanism);
    factorise::<M, Dense>(mechanism, &columns, &mut factors, time, q)?;
    subtract(qd, &least_change::<M, Dense>(mechanism, measures, &columns, &factors, open));
    match <Dense as Rows<M>>::is_regular(mechanism, &factors) {
        true => Ok(()),
        false => check_dependent_rates::<M, Dense>(mechanism, linear, measures, time, q, qd),
    }
}

#[cold]
fn project_redundant_velocities<M: Mechanism>(
    mechanism: &M,
    measures: &Measures<M>,
    linear: &Linearization<M>,
    time: f64,
    q: &M::Q,
    qd: &mut M::Q,
) -> Result<(), Failure> {
    let open = rates(mechanism, linear, qd);
    subtract(qd, &reduced_change(mechanism, measures, (&linear.jacobian, measures.rank()), &open, time, q)?.0);
    check_dependent_rates::<M, Dense>(mechanism, linear, measures, time, q, qd)
}

/// The same projections in the metric of the mass matrix M: q -= M^-1 C_q' (C_q M^-1 C_q')^-1 C, and so for q'.
///
/// # Errors
/// As [`project`], and where the mass matrix does not determine the change.
pub(crate) fn by_mass<M: Mechanism>(
    mechanism: &M,
    measures: &Measures<M>,
    state: &mut State<M>,
) -> Result<(), Failure> {
    let (time, q) = (state.time, &mut state.positions);
    let mut linear = mechanism.constraint_linearization(time, q);
    correct::<M, Dense>(mechanism, measures, (time, q), &mut linear, |linear, q| {
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

/// Corrects positions; leaves the constraints linearised there, and the factors that the last correction was made with.
/// Gives the largest part of that correction, relative to those that count as 1.
///
/// Both are left in place: copies of them would take as long as the projection.
#[inline]
fn correct_positions<M: Mechanism, R: Rows<M>>(
    mechanism: &M,
    measures: &Measures<M>,
    (time, q): (f64, &mut M::Q),
    linear: &mut Linear<M, R>,
    factors: &mut R::Factors,
) -> Result<f64, Failure> {
    let mut last_change = 0.0;
    correct::<M, R>(mechanism, measures, (time, q), linear, |linear, q| {
        let columns = match has_speed_rows(mechanism) {
            false => R::columns(mechanism, &linear.jacobian, measures),
            true => R::columns(mechanism, &R::between_positions(mechanism, &linear.jacobian), measures),
        };
        factorise::<M, R>(mechanism, &columns, factors, time, q)?;
        let change = least_change::<M, R>(mechanism, measures, &columns, factors, linear.values);
        last_change = measures.size(mechanism, &change);
        Ok(change)
    })?;
    Ok(last_change)
}

/// Subtracts corrections from positions, at which the constraints are linearised, until these are met; leaves them linearised
/// there.
#[inline]
fn correct<M: Mechanism, R: Rows<M>>(
    mechanism: &M,
    measures: &Measures<M>,
    (time, q): (f64, &mut M::Q),
    linear: &mut Linear<M, R>,
    mut change: impl FnMut(&Linear<M, R>, &M::Q) -> Result<M::Q, Failure>,
) -> Result<(), Failure> {
    for _ in 0..MOST_CORRECTIONS {
        if !linear.values.iter().all(|value| value.is_finite()) {
            return Err(not_finite(mechanism, &linear.values, time, q));
        }
        let correction = change(linear, q)?;
        subtract(q, &correction);
        if is_rounding(mechanism, measures, &linear.values, &correction) {
            return Ok(());
        }
        *linear = R::linearization(mechanism, time, q);
        if is_met::<M, R>(mechanism, measures, time, q, linear) {
            return Ok(());
        }
    }
    let (row, residual) = largest(linear.values.iter()).unwrap_or((0, f64::NAN));
    let what =
        What::NotProjected { constraint: constraint_name(mechanism, row), residual, iterations: MOST_CORRECTIONS };
    Err(Failure::at(mechanism, what, time, q))
}

#[cold]
fn not_finite<M: Mechanism>(mechanism: &M, values: &M::L, time: f64, q: &M::Q) -> Failure {
    let (row, value) = largest(values.iter()).unwrap_or((0, f64::NAN));
    let quantity = format!("constraint `{}` ({value})", constraint_name(mechanism, row));
    Failure::at(mechanism, What::NotFinite { quantity }, time, q)
}

/// Whether a correction was so small that the constraints linearised before it still hold after it, within rounding:
/// the residual of C is of second order.
#[inline]
fn is_rounding<M: Mechanism>(mechanism: &M, measures: &Measures<M>, values: &M::L, correction: &M::Q) -> bool {
    is_within(measures, values, 0.1 * TOLERANCE) && measures.size(mechanism, correction) <= ROUNDING
}

/// The factors of A A'.
#[inline(always)]
fn factorise<M: Mechanism, R: Rows<M>>(
    mechanism: &M,
    columns: &R::Jacobian,
    factors: &mut R::Factors,
    time: f64,
    q: &M::Q,
) -> Result<(), Failure> {
    R::factorise(mechanism, columns, factors).map_err(|undefined| {
        let quantity = format!("constraint `{}`", constraint_name(mechanism, undefined.row));
        Failure::at(mechanism, What::NotFinite { quantity }, time, q)
    })
}

/// Rarely needed: out of line it keeps the calling loop small.
#[inline(never)]
fn factorise_again<M: Mechanism, R: Rows<M>>(
    mechanism: &M,
    columns: &R::Jacobian,
    factors: &mut R::Factors,
    time: f64,
    q: &M::Q,
) -> Result<(), Failure> {
    factorise::<M, R>(mechanism, columns, factors, time, q)
}

/// D A' (A A')^-1 r, with A = C_q D.
#[inline]
fn least_change<M: Mechanism, R: Rows<M>>(
    mechanism: &M,
    measures: &Measures<M>,
    columns: &R::Jacobian,
    factors: &R::Factors,
    residual: M::L,
) -> M::Q {
    measures.change(mechanism, R::transposed_times(mechanism, columns, &R::solve(mechanism, factors, residual)))
}

/// A constraint that depends on others must not require another speed than they do.
#[cold]
fn check_dependent_rates<M: Mechanism, R: Rows<M>>(
    mechanism: &M,
    linear: &Linear<M, R>,
    measures: &Measures<M>,
    time: f64,
    q: &M::Q,
    qd: &M::Q,
) -> Result<(), Failure> {
    let left = rates_of::<M, R>(mechanism, linear, qd);
    // A position within 1e-6 of a singular one leaves this residual in the speeds.
    let bound = |i: usize| {
        1e-6 * (R::terms(mechanism, &linear.jacobian, i, qd) + linear.time_derivative[i].abs())
            + TOLERANCE * measures.constraints()[i]
    };
    match (0..mechanism.m()).find(|row| !(left[*row].abs() <= bound(*row))) {
        None => Ok(()),
        Some(row) => {
            let what = What::DependentConstraint { constraint: constraint_name(mechanism, row) };
            Err(Failure::at(mechanism, what, time, q))
        }
    }
}
