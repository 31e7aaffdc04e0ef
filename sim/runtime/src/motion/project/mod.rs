//! Projection onto the constraints: positions by Gauss-Newton, velocities by one linear correction.
//!
//! Both corrections are the smallest, with lengths measured by the mechanism's own length: with D the diagonal matrix
//! of the coordinates' scales, q -= D^2 C_q' (C_q D^2 C_q')^-1 C and q' -= D^2 C_q' (C_q D^2 C_q')^-1 (C_q q' + C_t);
//! or on request they are the smallest in the metric of the mass matrix. With redundant constraints, C_q and the
//! residuals are first reduced to the rank of C_q (`redundant`).
//!

mod by_mass;
mod redundant;

use crate::model::level::has_speed_rows;
use crate::motion::measures::Measures;
use crate::motion::met::{TOLERANCE, is_met, is_within};
use crate::motion::residuals::{rates, rates_of};
use crate::motion::rows::{Dense, Linear, Rows, Sparse, is_sparse, select_each};
use crate::numerics::arrays::subtract;
use crate::numerics::numbers::{are_finite, larger};
use crate::numerics::solve::Undefined;
use crate::state::failure::{Failure, What, constraint_name, largest};
use crate::state::slot::Slot;
use crate::state::trajectory::State;
pub(crate) use by_mass::{by_mass, smallest_by_inertia};
use redundant::{correct_redundant_positions, project_redundant, reduced_change};
use sim_kernel::{Array, ConstraintLinearization, Mask, Mechanism, Scalar};

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
    project_measured(mechanism, measures, state, &Slot::new(M::L::repeat(mechanism.m(), 0.0))).map(|_| ())
}

/// The same; gives 1/s^2, where s is the smallest sine between a row of C_q D and those before it, of those that are
/// independent. Rows count relative to their greatest length so far, whose squares it keeps.
#[inline]
pub(crate) fn project_measured<M: Mechanism>(
    mechanism: &M,
    measures: &Measures<M>,
    state: &mut State<M>,
    longest: &Slot<M::L>,
) -> Result<f64, Failure> {
    if mechanism.m() > 0 && measures.is_redundant() {
        return project_redundant(mechanism, measures, state);
    }
    project_by_rows(mechanism, measures, state, longest)
}

/// The same without redundant constraints, on numbers of any kind.
///
/// # Errors
/// As [`project`], if any lane fails.
#[inline(always)]
pub(crate) fn project_by_rows<S: Scalar, M: Mechanism<S>>(
    mechanism: &M,
    measures: &Measures<M, S>,
    state: &mut State<M, S>,
    longest: &Slot<M::L>,
) -> Result<S, Failure> {
    match (mechanism.m(), is_sparse(mechanism)) {
        (0, _) => Ok(S::ZERO),
        (_, false) => project_independent::<S, M, Dense>(mechanism, measures, state, longest),
        (_, true) => project_independent::<S, M, Sparse>(mechanism, measures, state, longest),
    }
}

/// The same with rows stored in this way.
#[inline(always)]
fn project_independent<S: Scalar, M: Mechanism<S>, R: Rows<S, M>>(
    mechanism: &M,
    measures: &Measures<M, S>,
    state: &mut State<M, S>,
    longest: &Slot<M::L>,
) -> Result<S, Failure> {
    let (time, q) = (state.time, &mut state.positions);
    // By a statement of its own it is written in place.
    let mut linear = R::linearization(mechanism, time, q);
    let mut factors = R::no_factors(mechanism);
    let is_small = correct_positions::<S, M, R>(mechanism, measures, (time, q), &mut linear, &mut factors)?;
    let open = rates_of::<S, M, R>(mechanism, &linear, &state.speeds);
    let columns = R::columns(mechanism, &linear.jacobian, measures);
    let serves = match has_speed_rows(mechanism) {
        true => S::Mask::NONE,
        false => is_small & is_within(measures, &open, SMALL_RATE),
    };
    if S::not(serves).any() {
        factorise_again::<S, M, R>(mechanism, &columns, serves, &mut factors, time, q)?;
    }
    if !R::is_regular(mechanism, &factors)
        && R::dependent(mechanism, &factors).count() > mechanism.m() - measures.rank()
    {
        return Err(singular_position::<S, M, R>(mechanism, &factors, time, q));
    }
    subtract(&mut state.speeds, &least_change::<S, M, R>(mechanism, measures, &columns, &factors, open));
    if !R::is_regular(mechanism, &factors) {
        check_dependent_rates::<S, M, R>(mechanism, &linear, measures, time, q, &state.speeds)?;
    }
    let (mut squares, mut closeness) = (longest.take(), S::ZERO);
    for k in 0..mechanism.m() {
        let (row, (square, inverse_pivot)) = (R::constraint(mechanism, k), R::pivot(mechanism, &factors, k));
        squares[row] = larger(squares[row], square);
        closeness = larger(closeness, squares[row] * inverse_pivot);
    }
    longest.set(squares);
    Ok(closeness)
}

#[cold]
fn singular_position<S: Scalar, M: Mechanism<S>, R: Rows<S, M>>(
    mechanism: &M,
    factors: &R::Factors,
    time: S,
    q: &M::Q,
) -> Failure {
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
            correct_positions::<f64, M, Dense>(mechanism, measures, (time, q), &mut linear, &mut factors)?;
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
    factorise::<f64, M, Dense>(mechanism, &columns, false, &mut factors, time, q)?;
    subtract(qd, &least_change::<f64, M, Dense>(mechanism, measures, &columns, &factors, open));
    match <Dense as Rows<f64, M>>::is_regular(mechanism, &factors) {
        true => Ok(()),
        false => check_dependent_rates::<f64, M, Dense>(mechanism, linear, measures, time, q, qd),
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
    check_dependent_rates::<f64, M, Dense>(mechanism, linear, measures, time, q, qd)
}

/// Corrects positions; leaves the constraints linearised there, and the factors that the last correction was made with.
/// Gives where that correction was a [`SMALL_CHANGE`].
///
/// Both are left in place: copies of them would take as long as the projection.
#[inline]
fn correct_positions<S: Scalar, M: Mechanism<S>, R: Rows<S, M>>(
    mechanism: &M,
    measures: &Measures<M, S>,
    (time, q): (S, &mut M::Q),
    linear: &mut Linear<S, M, R>,
    factors: &mut R::Factors,
) -> Result<S::Mask, Failure> {
    correct::<S, M, R>(mechanism, measures, (time, q), linear, |linear, q, is_done| {
        let columns = match has_speed_rows(mechanism) {
            false => R::columns(mechanism, &linear.jacobian, measures),
            true => R::columns(mechanism, &R::between_positions(mechanism, &linear.jacobian), measures),
        };
        factorise::<S, M, R>(mechanism, &columns, is_done, factors, time, q)?;
        Ok(least_change::<S, M, R>(mechanism, measures, &columns, factors, linear.values.clone()))
    })
}

/// Subtracts corrections from positions, at which the constraints are linearised, until these are met; leaves them linearised
/// there. Each lane ends with its own correction: `change` is told which are done. Gives where the last correction was a
/// [`SMALL_CHANGE`].
#[inline]
fn correct<S: Scalar, M: Mechanism<S>, R: Rows<S, M>>(
    mechanism: &M,
    measures: &Measures<M, S>,
    (time, q): (S, &mut M::Q),
    linear: &mut Linear<S, M, R>,
    mut change: impl FnMut(&Linear<S, M, R>, &M::Q, S::Mask) -> Result<M::Q, Failure>,
) -> Result<S::Mask, Failure> {
    let (mut is_done, mut was_small) = (S::Mask::NONE, S::Mask::NONE);
    for _ in 0..MOST_CORRECTIONS {
        if !are_finite(linear.values.as_ref()) {
            return Err(not_finite(mechanism, &linear.values, time, q));
        }
        let correction = change(linear, q, is_done)?;
        let is_small = measures.is_within(&correction, SMALL_CHANGE);
        was_small = (is_done & was_small) | (S::not(is_done) & is_small);
        match is_done.any() {
            false => subtract(q, &correction),
            true => *q = q.like(|j| S::select(is_done, q[j], q[j] - correction[j])),
        }
        is_done = is_done | is_rounding(measures, &linear.values, &correction);
        if !S::not(is_done).any() {
            return Ok(was_small);
        }
        match is_done.any() {
            false => *linear = R::linearization(mechanism, time, q),
            true => relinearise::<S, M, R>(mechanism, (time, q), linear, is_done),
        }
        is_done = is_done | is_met::<S, M, R>(mechanism, measures, time, q, linear);
        if !S::not(is_done).any() {
            return Ok(was_small);
        }
    }
    let (row, residual) = largest(linear.values.iter()).unwrap_or((0, f64::NAN));
    let what =
        What::NotProjected { constraint: constraint_name(mechanism, row), residual, iterations: MOST_CORRECTIONS };
    Err(Failure::at(mechanism, what, time, q))
}

/// Linearises the constraints anew, except where they stay as they are.
#[cold]
fn relinearise<S: Scalar, M: Mechanism<S>, R: Rows<S, M>>(
    mechanism: &M,
    (time, q): (S, &M::Q),
    linear: &mut Linear<S, M, R>,
    stays: S::Mask,
) {
    let new = R::linearization(mechanism, time, q);
    linear.values = select_each(stays, &linear.values, &new.values);
    linear.jacobian = R::select(S::not(stays), new.jacobian, &linear.jacobian);
    linear.time_derivative = select_each(stays, &linear.time_derivative, &new.time_derivative);
}

#[cold]
fn not_finite<S: Scalar, M: Mechanism<S>>(mechanism: &M, values: &M::L, time: S, q: &M::Q) -> Failure {
    let (row, value) = largest(values.iter()).unwrap_or((0, f64::NAN));
    let quantity = format!("constraint `{}` ({value})", constraint_name(mechanism, row));
    Failure::at(mechanism, What::NotFinite { quantity }, time, q)
}

/// Where a correction was so small that the constraints linearised before it still hold after it, within rounding:
/// the residual of C is of second order.
#[inline]
fn is_rounding<S: Scalar, M: Mechanism<S>>(measures: &Measures<M, S>, values: &M::L, correction: &M::Q) -> S::Mask {
    is_within(measures, values, 0.1 * TOLERANCE) & measures.is_within(correction, ROUNDING)
}

/// The factors of A A', except where the old ones stay.
#[inline(always)]
fn factorise<S: Scalar, M: Mechanism<S>, R: Rows<S, M>>(
    mechanism: &M,
    columns: &R::Jacobian,
    stay: S::Mask,
    factors: &mut R::Factors,
    time: S,
    q: &M::Q,
) -> Result<(), Failure> {
    let factorised = match stay.any() {
        false => R::factorise(mechanism, columns, factors),
        true => factorise_some::<S, M, R>(mechanism, columns, stay, factors),
    };
    factorised.map_err(|undefined| {
        let quantity = format!("constraint `{}`", constraint_name(mechanism, undefined.row));
        Failure::at(mechanism, What::NotFinite { quantity }, time, q)
    })
}

#[cold]
fn factorise_some<S: Scalar, M: Mechanism<S>, R: Rows<S, M>>(
    mechanism: &M,
    columns: &R::Jacobian,
    stay: S::Mask,
    factors: &mut R::Factors,
) -> Result<(), Undefined> {
    let old = std::mem::replace(factors, R::no_factors(mechanism));
    R::factorise(mechanism, columns, factors)?;
    *factors = R::select_factors(stay, old, factors);
    Ok(())
}

/// Rarely needed: out of line it keeps the calling loop small.
#[inline(never)]
fn factorise_again<S: Scalar, M: Mechanism<S>, R: Rows<S, M>>(
    mechanism: &M,
    columns: &R::Jacobian,
    stay: S::Mask,
    factors: &mut R::Factors,
    time: S,
    q: &M::Q,
) -> Result<(), Failure> {
    factorise::<S, M, R>(mechanism, columns, stay, factors, time, q)
}

/// D A' (A A')^-1 r, with A = C_q D.
#[inline]
fn least_change<S: Scalar, M: Mechanism<S>, R: Rows<S, M>>(
    mechanism: &M,
    measures: &Measures<M, S>,
    columns: &R::Jacobian,
    factors: &R::Factors,
    residual: M::L,
) -> M::Q {
    measures.change(mechanism, R::transposed_times(mechanism, columns, &R::solve(mechanism, factors, residual)))
}

/// A constraint that depends on others must not require another speed than they do.
#[cold]
fn check_dependent_rates<S: Scalar, M: Mechanism<S>, R: Rows<S, M>>(
    mechanism: &M,
    linear: &Linear<S, M, R>,
    measures: &Measures<M, S>,
    time: S,
    q: &M::Q,
    qd: &M::Q,
) -> Result<(), Failure> {
    let left = rates_of::<S, M, R>(mechanism, linear, qd);
    // A position within 1e-6 of a singular one leaves this residual in the speeds.
    let bound = |i: usize| {
        S::from_f64(1e-6) * (R::terms(mechanism, &linear.jacobian, i, qd) + linear.time_derivative[i].abs())
            + S::from_f64(TOLERANCE) * measures.constraints()[i]
    };
    match (0..mechanism.m()).find(|row| S::not(left[*row].abs().at_most(bound(*row))).any()) {
        None => Ok(()),
        Some(row) => {
            let what = What::DependentConstraint { constraint: constraint_name(mechanism, row) };
            Err(Failure::at(mechanism, what, time, q))
        }
    }
}
