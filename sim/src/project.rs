//! Projection onto the constraints: positions by Gauss-Newton, velocities by one linear correction.
//!
//! Both corrections are the smallest in the unweighted norm of the coordinates,
//! q -= C_q' (C_q C_q')^-1 C and q' -= C_q' (C_q C_q')^-1 (C_q q' + C_t), or on request in the metric of the mass matrix.
//! Rows that depend on others here are left out of a correction, but not of the check that follows it.

use crate::equations::by_inertia;
use crate::failure::{Failure, What, constraint_name, largest};
use crate::level::{between_positions, has_speed_rows};
use crate::solve::Definite;
use crate::trajectory::State;
use sim_kernel::{Array, ConstraintLinearization, Mechanism};
use std::cell::Cell;

/// Corrections after which a projection that has not converged is given up.
const MOST_CORRECTIONS: usize = 10;
/// A residual below this is met, whatever its terms.
const TOLERANCE: f64 = 1e-12;
/// A residual above this is never put down to rounding: a state known no better is lost.
const LARGEST_ROUNDING: f64 = 1e-6;
/// A change of positions that is rounding, in SI units.
const ROUNDING: f64 = 1e-14;
/// A change of positions, in SI units, and rates of constraints, below which one factorisation serves both projections:
/// what it leaves of the rates is of the order of their product.
const SMALL_CHANGE: f64 = 1e-8;
const SMALL_RATE: f64 = 1e-5;

type Linearization<M> = ConstraintLinearization<<M as Mechanism>::L, <M as Mechanism>::LQ>;
type Factors<M> = Definite<<M as Mechanism>::LL, <M as Mechanism>::L>;

/// Corrects positions and speeds, as [`project_positions`] and [`project_velocities`] one after the other.
/// `redundant` is how many constraints depend on others everywhere.
///
/// # Errors
/// As those, and [`What::SingularPosition`] where more constraints depend on others.
#[inline]
pub fn project<M: Mechanism>(mechanism: &M, state: &mut State<M>, redundant: usize) -> Result<(), Failure> {
    project_measured(mechanism, state, redundant, &Cell::new(M::L::filled(0.0))).map(|_| ())
}

/// The same; gives 1/s^2, where s is the smallest sine between a row of C_q and those before it, of those that are
/// independent. Rows count relative to the longest that they have been, of which it keeps the squares.
#[inline]
pub(crate) fn project_measured<M: Mechanism>(
    mechanism: &M,
    state: &mut State<M>,
    redundant: usize,
    longest: &Cell<M::L>,
) -> Result<f64, Failure> {
    if M::L::LEN == 0 {
        return Ok(0.0);
    }
    let (time, q) = (state.time, &mut state.positions);
    let found = correct_positions(mechanism, time, q)?;
    let open = rates::<M>(&found.linear, &state.speeds);
    let serves =
        !has_speed_rows::<M>() && found.last_change <= SMALL_CHANGE && open.iter().all(|rate| rate.abs() <= SMALL_RATE);
    let factors = if serves { found.factors } else { factorise_again::<M>(&found.linear.jacobian, time, q)? };
    if !factors.is_regular() && factors.dependent().count() > redundant {
        let constraint = factors.dependent().last().map_or("?", |row| constraint_name::<M>(row));
        return Err(Failure::at::<M>(What::SingularPosition { constraint }, time, q));
    }
    correct_speeds::<M>(&found.linear, &factors, &open, time, q, &mut state.speeds)?;
    let (mut squares, mut closeness) = (longest.get(), 0.0f64);
    for row in 0..M::L::LEN {
        let (square, inverse_pivot) = factors.row(row);
        squares[row] = squares[row].max(square);
        closeness = closeness.max(squares[row] * inverse_pivot);
    }
    longest.set(squares);
    Ok(closeness)
}

/// Corrects positions until |C_i| <= max(1e-12, 8 eps (magnitudes of C_i's terms + sum of |C_ij q_j|)), once at
/// least; gives the constraints linearised there.
///
/// An absolute tolerance alone could not be met by constraints with large terms, and without the first correction
/// the projection would set in at some step and spoil the order of the method.
///
/// # Errors
/// [`What::NotProjected`] after ten corrections, [`What::NotFinite`] if a constraint leaves its domain.
#[inline]
pub fn project_positions<M: Mechanism>(mechanism: &M, time: f64, q: &mut M::Q) -> Result<Linearization<M>, Failure> {
    if M::L::LEN == 0 {
        return Ok(mechanism.constraint_linearization(time, q));
    }
    Ok(correct_positions(mechanism, time, q)?.linear)
}

/// Corrects velocities at a position where the constraints are already linearised.
///
/// # Errors
/// [`What::DependentConstraint`] if a constraint that depends on others here contradicts them.
#[inline]
pub fn project_velocities<M: Mechanism>(
    linear: &Linearization<M>,
    time: f64,
    q: &M::Q,
    qd: &mut M::Q,
) -> Result<(), Failure> {
    if M::L::LEN == 0 {
        return Ok(());
    }
    let factors = factorise::<M>(&linear.jacobian, time, q)?;
    correct_speeds::<M>(linear, &factors, &rates::<M>(linear, qd), time, q, qd)
}

/// C_q q' + C_t.
#[inline]
pub fn rates<M: Mechanism>(linear: &Linearization<M>, qd: &M::Q) -> M::L {
    M::L::from_fn(|i| inner(&linear.jacobian[i], qd) + linear.time_derivative[i])
}

/// The same projections in the metric of the mass matrix M: q -= M^-1 C_q' (C_q M^-1 C_q')^-1 C, and so for q'.
///
/// # Errors
/// As [`project`], and where the mass matrix does not determine the change.
pub(crate) fn by_mass<M: Mechanism>(mechanism: &M, state: &mut State<M>) -> Result<(), Failure> {
    let (time, q) = (state.time, &mut state.positions);
    let (linear, _) = correct(mechanism, time, q, |linear, q| {
        by_inertia(mechanism, time, q, &between_positions::<M>(&linear.jacobian), &linear.values)
            .map(|change| (change, ()))
    })?;
    let change = by_inertia(mechanism, time, q, &linear.jacobian, &rates::<M>(&linear, &state.speeds))?;
    subtract(&mut state.speeds, &change);
    Ok(())
}

/// Where positions have been corrected to.
struct Corrected<M: Mechanism> {
    /// The constraints there.
    linear: Linearization<M>,
    /// The factors that the last correction was made with.
    factors: Factors<M>,
    /// The largest change of the last correction.
    last_change: f64,
}

#[inline]
fn correct_positions<M: Mechanism>(mechanism: &M, time: f64, q: &mut M::Q) -> Result<Corrected<M>, Failure> {
    let (linear, (factors, last_change)) = correct(mechanism, time, q, |linear, q| {
        let without_speed_rows;
        let jacobian = match has_speed_rows::<M>() {
            false => &linear.jacobian,
            true => {
                without_speed_rows = between_positions::<M>(&linear.jacobian);
                &without_speed_rows
            }
        };
        let factors = factorise::<M>(jacobian, time, q)?;
        let change = least_change::<M>(jacobian, &factors, linear.values);
        let size = change.iter().fold(0.0f64, |size, change| size.max(change.abs()));
        Ok((change, (factors, size)))
    })?;
    Ok(Corrected { linear, factors, last_change })
}

/// Subtracts corrections from positions until the constraints are met; gives the constraints there, and what came with
/// the last correction.
#[inline]
fn correct<M: Mechanism, T>(
    mechanism: &M,
    time: f64,
    q: &mut M::Q,
    change: impl Fn(&Linearization<M>, &M::Q) -> Result<(M::Q, T), Failure>,
) -> Result<(Linearization<M>, T), Failure> {
    let mut linear = mechanism.constraint_linearization(time, q);
    for _ in 0..MOST_CORRECTIONS {
        if !linear.values.iter().all(|value| value.is_finite()) {
            return Err(not_finite::<M>(&linear.values, time, q));
        }
        let (correction, last) = change(&linear, q)?;
        subtract(q, &correction);
        if is_rounding::<M>(&linear, &correction) {
            return Ok((linear, last));
        }
        linear = mechanism.constraint_linearization(time, q);
        if is_met(mechanism, time, q, &linear) {
            return Ok((linear, last));
        }
    }
    let (row, residual) = largest(linear.values.iter()).unwrap_or((0, f64::NAN));
    let what = What::NotProjected { constraint: constraint_name::<M>(row), residual, iterations: MOST_CORRECTIONS };
    Err(Failure::at::<M>(what, time, q))
}

#[cold]
fn not_finite<M: Mechanism>(values: &M::L, time: f64, q: &M::Q) -> Failure {
    let (row, value) = largest(values.iter()).unwrap_or((0, f64::NAN));
    let quantity = format!("constraint `{}` ({value})", constraint_name::<M>(row));
    Failure::at::<M>(What::NotFinite { quantity }, time, q)
}

/// Whether a correction was so small that the constraints linearised before it are those after it, up to rounding:
/// what it leaves of C is of its second order.
#[inline]
fn is_rounding<M: Mechanism>(linear: &Linearization<M>, correction: &M::Q) -> bool {
    let is_small = |values: &[f64], bound: f64| values.iter().all(|value| value.abs() <= bound);
    is_small(linear.values.as_ref(), 0.1 * TOLERANCE) && is_small(correction.as_ref(), ROUNDING)
}

/// The factors of C_q C_q'.
#[inline(always)]
fn factorise<M: Mechanism>(jacobian: &M::LQ, time: f64, q: &M::Q) -> Result<Factors<M>, Failure> {
    let mut gram = M::LL::filled(M::L::filled(0.0));
    for i in 0..M::L::LEN {
        for j in 0..=i {
            gram[i][j] = inner(&jacobian[i], &jacobian[j]);
        }
    }
    Definite::new(gram).map_err(|undefined| {
        let quantity = format!("constraint `{}`", constraint_name::<M>(undefined.row));
        Failure::at::<M>(What::NotFinite { quantity }, time, q)
    })
}

#[inline(never)]
fn factorise_again<M: Mechanism>(jacobian: &M::LQ, time: f64, q: &M::Q) -> Result<Factors<M>, Failure> {
    factorise::<M>(jacobian, time, q)
}

/// C_q' (C_q C_q')^-1 r.
#[inline]
fn least_change<M: Mechanism>(jacobian: &M::LQ, factors: &Factors<M>, residual: M::L) -> M::Q {
    let weights = factors.solve(residual);
    M::Q::from_fn(|j| (0..M::L::LEN).map(|i| jacobian[i][j] * weights[i]).sum())
}

#[inline]
fn correct_speeds<M: Mechanism>(
    linear: &Linearization<M>,
    factors: &Factors<M>,
    open: &M::L,
    time: f64,
    q: &M::Q,
    qd: &mut M::Q,
) -> Result<(), Failure> {
    subtract(qd, &least_change::<M>(&linear.jacobian, factors, *open));
    match factors.is_regular() {
        true => Ok(()),
        false => check_dependent_rates::<M>(linear, time, q, qd),
    }
}

/// A constraint that depends on others must not ask for another speed than they do.
#[cold]
fn check_dependent_rates<M: Mechanism>(
    linear: &Linearization<M>,
    time: f64,
    q: &M::Q,
    qd: &M::Q,
) -> Result<(), Failure> {
    let terms = |i: usize| linear.jacobian[i].iter().zip(qd.iter()).map(|(c, v)| (c * v).abs()).sum::<f64>();
    let left = rates::<M>(linear, qd);
    // A position within 1e-6 of a singular one leaves that part of the speeds.
    let contradicts =
        |i: &usize| !(left[*i].abs() <= 1e-6 * (terms(*i) + linear.time_derivative[*i].abs()) + TOLERANCE);
    match (0..M::L::LEN).find(contradicts) {
        None => Ok(()),
        Some(row) => {
            let what = What::DependentConstraint { constraint: constraint_name::<M>(row) };
            Err(Failure::at::<M>(what, time, q))
        }
    }
}

#[inline]
pub(crate) fn inner<A: Array<f64>>(a: &A, b: &A) -> f64 {
    a.iter().zip(b.iter()).map(|(a, b)| a * b).sum()
}

#[inline]
fn subtract<A: Array<f64>>(from: &mut A, correction: &A) {
    for (value, correction) in from.as_mut().iter_mut().zip(correction.iter()) {
        *value -= correction;
    }
}

/// Whether every residual is at the level of its own rounding.
#[inline]
pub(crate) fn is_met<M: Mechanism>(mechanism: &M, time: f64, q: &M::Q, linear: &Linearization<M>) -> bool {
    linear.values.iter().all(|value| value.abs() <= TOLERANCE) || is_met_by_rounding(mechanism, time, q, linear)
}

#[cold]
fn is_met_by_rounding<M: Mechanism>(mechanism: &M, time: f64, q: &M::Q, linear: &Linearization<M>) -> bool {
    let magnitudes = mechanism.constraint_magnitudes(time, q);
    (0..M::L::LEN).all(|i| {
        let moved: f64 = linear.jacobian[i].iter().zip(q.iter()).map(|(c, q)| (c * q).abs()).sum();
        let rounding = 8.0 * f64::EPSILON * (magnitudes[i] + moved);
        linear.values[i].abs() <= rounding.clamp(TOLERANCE, LARGEST_ROUNDING)
    })
}
