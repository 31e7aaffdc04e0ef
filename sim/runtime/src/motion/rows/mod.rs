//! How the rows of C_q are stored and C_q C_q' is factorised: all entries, or only those that may be nonzero.
//!
//! Both give the same numbers, since the entries that sparse rows omit are 0. The choice is made when a mechanism is
//! compiled.

mod common;
mod dense;
#[cfg(test)]
pub(crate) mod examples;
mod sparse;
mod turned;

pub(crate) use dense::Dense;
pub(crate) use sparse::{Envelope, Sparse, first_met, is_sparse, sparse_rows};
pub(crate) use turned::{may_have_turned, mixed_pivots};

use crate::motion::measures::Measures;
use crate::numerics::solve::Undefined;
use sim_kernel::{Array, ConstraintLinearization, Mask, Mechanism, Scalar};

/// The constraints of a mechanism, linearised, with C_q stored in this way.
pub(crate) type Linear<S, M, R> = ConstraintLinearization<<M as Mechanism<S>>::L, <R as Rows<S, M>>::Jacobian>;

/// A way to store rows.
pub(crate) trait Rows<S: Scalar, M: Mechanism<S>> {
    /// m rows of n.
    type Jacobian;
    /// L D L' of the products of rows with each other.
    type Factors;

    /// C, C_q and C_t.
    fn linearization(mechanism: &M, time: S, q: &M::Q) -> Linear<S, M, Self>;
    /// The same rows with columns times the changes that count as 1.
    fn columns(mechanism: &M, jacobian: &Self::Jacobian, measures: &Measures<M, S>) -> Self::Jacobian;
    /// The same rows with zeros in those between speeds.
    fn between_positions(mechanism: &M, jacobian: &Self::Jacobian) -> Self::Jacobian;
    /// A x.
    fn times(mechanism: &M, jacobian: &Self::Jacobian, x: &M::Q) -> M::L;
    /// The sum of the magnitudes of a row's terms in that.
    fn terms(mechanism: &M, jacobian: &Self::Jacobian, row: usize, x: &M::Q) -> S;
    /// A' y.
    fn transposed_times(mechanism: &M, jacobian: &Self::Jacobian, y: &M::L) -> M::Q;
    /// The factors of A A', computed in place: moving them would take as long as computing them.
    fn factorise(mechanism: &M, jacobian: &Self::Jacobian, factors: &mut Self::Factors) -> Result<(), Undefined>;
    /// Factors to be computed in place.
    fn no_factors(mechanism: &M) -> Self::Factors;
    /// The diagonal entry of a row of A A', and the inverse of its pivot: zero if the row depends on those before it.
    fn pivot(mechanism: &M, factors: &Self::Factors, k: usize) -> (S, S);
    /// The solution for a right-hand side; unknowns of dependent rows are zero.
    fn solve(mechanism: &M, factors: &Self::Factors, rhs: M::L) -> M::L;
    /// The constraint of a row of the factors.
    fn constraint(mechanism: &M, k: usize) -> usize;

    /// The matrices `yes` where the mask is true and `no` elsewhere.
    fn select(mask: S::Mask, yes: Self::Jacobian, no: &Self::Jacobian) -> Self::Jacobian;
    /// The same of factors.
    fn select_factors(mask: S::Mask, yes: Self::Factors, no: &Self::Factors) -> Self::Factors;

    /// Whether no row is dependent, in any lane.
    #[inline]
    fn is_regular(mechanism: &M, factors: &Self::Factors) -> bool {
        (0..mechanism.m()).all(|k| !is_dependent::<S, M, Self>(mechanism, factors, k))
    }

    /// The rows that depend on those before them, in any lane.
    fn dependent(mechanism: &M, factors: &Self::Factors) -> impl Iterator<Item = usize> {
        (0..mechanism.m()).filter(|k| is_dependent::<S, M, Self>(mechanism, factors, *k))
    }
}

#[inline(always)]
fn is_dependent<S: Scalar, M: Mechanism<S>, R: Rows<S, M> + ?Sized>(
    mechanism: &M,
    factors: &R::Factors,
    k: usize,
) -> bool {
    R::pivot(mechanism, factors, k).1.abs().at_most(S::ZERO).any()
}

/// The numbers `yes` where the mask is true and `no` elsewhere.
#[inline(always)]
pub(crate) fn select_each<S: Scalar, A: Array<S>>(mask: S::Mask, yes: &A, no: &A) -> A {
    yes.like(|i| S::select(mask, yes[i], no[i]))
}

/// The same of matrices.
#[inline(always)]
pub(crate) fn select_rows<S: Scalar, A: Array<R>, R: Array<S>>(mask: S::Mask, yes: &A, no: &A) -> A {
    yes.like(|i| select_each(mask, &yes[i], &no[i]))
}
