//! Projection onto the constraints: positions by Gauss-Newton, velocities by one linear correction.
//!
//! Both corrections are the smallest in the unweighted norm of the coordinates:
//! q -= C_q' (C_q C_q')^-1 C and q' -= C_q' (C_q C_q')^-1 (C_q q' + C_t).

use crate::failure::{Failure, What, constraint_name, largest};
use crate::solve::solve_definite;
use sim_kernel::{Array, ConstraintLinearization, Mechanism};

/// Corrections after which a projection that has not converged is given up.
const MOST_CORRECTIONS: usize = 10;
/// A residual below this is met, whatever its terms.
const TOLERANCE: f64 = 1e-12;

/// A residual above this is never put down to rounding: a state known no better is lost.
const LARGEST_ROUNDING: f64 = 1e-6;

type Linearization<M> = ConstraintLinearization<<M as Mechanism>::L, <M as Mechanism>::LQ>;

/// Corrects positions until |C_i| <= max(1e-12, 8 eps (magnitudes of C_i's terms + sum of |C_ij q_j|)), once at
/// least; gives the constraints linearised there.
///
/// An absolute tolerance alone could not be met by constraints with large terms, and without the first correction
/// the projection would set in at some step and spoil the order of the method.
///
/// # Errors
/// [`What::NotProjected`] after ten corrections, [`What::DependentConstraint`] where C_q loses rank,
/// [`What::NotFinite`] if a constraint leaves its domain.
#[inline]
pub fn project_positions<M: Mechanism>(mechanism: &M, time: f64, q: &mut M::Q) -> Result<Linearization<M>, Failure> {
    let mut linear = mechanism.constraint_linearization(time, q);
    if M::L::LEN == 0 {
        return Ok(linear);
    }
    for _ in 0..MOST_CORRECTIONS {
        if let Some((row, value)) = largest(linear.values.iter()).filter(|(_, value)| !value.is_finite()) {
            let quantity = format!("constraint `{}` ({value})", constraint_name::<M>(row));
            return Err(Failure::at::<M>(What::NotFinite { quantity }, time, q));
        }
        let correction = least_change::<M>(&linear, linear.values, time, q)?;
        subtract(q, &correction);
        linear = mechanism.constraint_linearization(time, q);
        if is_met(mechanism, time, q, &linear) {
            return Ok(linear);
        }
    }
    let (row, residual) = largest(linear.values.iter()).unwrap_or((0, f64::NAN));
    let what = What::NotProjected { constraint: constraint_name::<M>(row), residual, iterations: MOST_CORRECTIONS };
    Err(Failure::at::<M>(what, time, q))
}

/// Corrects velocities at a position where the constraints are already linearised.
///
/// # Errors
/// [`What::DependentConstraint`] where C_q loses rank.
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
    let rates = M::L::from_fn(|i| inner(&linear.jacobian[i], qd) + linear.time_derivative[i]);
    let correction = least_change::<M>(linear, rates, time, q)?;
    subtract(qd, &correction);
    Ok(())
}

/// C_q' (C_q C_q')^-1 r.
#[inline]
fn least_change<M: Mechanism>(linear: &Linearization<M>, residual: M::L, time: f64, q: &M::Q) -> Result<M::Q, Failure> {
    let jacobian = &linear.jacobian;
    let gram = M::LL::from_fn(|i| M::L::from_fn(|j| if j <= i { inner(&jacobian[i], &jacobian[j]) } else { 0.0 }));
    let weights = solve_definite(gram, residual).map_err(|deficient| {
        let constraint = constraint_name::<M>(deficient.unknown);
        let finite = jacobian[deficient.unknown].iter().all(|entry| entry.is_finite());
        let what = match finite {
            true => What::DependentConstraint { constraint },
            false => What::NotFinite { quantity: format!("constraint `{constraint}`") },
        };
        Failure::at::<M>(what, time, q)
    })?;
    Ok(M::Q::from_fn(|j| (0..M::L::LEN).map(|i| jacobian[i][j] * weights[i]).sum()))
}

#[inline]
fn inner<A: Array<f64>>(a: &A, b: &A) -> f64 {
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
