//! How the rows of C_q are stored and C_q C_q' is factorised: all entries, or only those that may be nonzero.
//!
//! Both give the same numbers, since the entries that sparse rows omit are 0. The choice is made when a mechanism is
//! compiled.

mod dense;
mod sparse;
mod turned;

pub(crate) use dense::Dense;
pub(crate) use sparse::{Sparse, is_sparse, sparse_rows};
pub(crate) use turned::may_have_turned;

use crate::motion::measures::Measures;
use crate::numerics::factors::{Factors, Undefined};
use sim_kernel::{ConstraintLinearization, Mechanism};

/// The constraints of a mechanism, linearised, with C_q stored in this way.
pub(crate) type Linear<M, R> = ConstraintLinearization<<M as Mechanism>::L, <R as Rows<M>>::Jacobian>;

/// A way to store rows.
pub(crate) trait Rows<M: Mechanism> {
    /// m rows of n.
    type Jacobian: Copy;
    /// L D L' of the products of rows with each other.
    type Factors: Factors<M::L>;

    /// C, C_q and C_t.
    fn linearization(mechanism: &M, time: f64, q: &M::Q) -> Linear<M, Self>;
    /// The same rows with columns times the changes that count as 1.
    fn columns(jacobian: &Self::Jacobian, measures: &Measures<M>) -> Self::Jacobian;
    /// The same rows with zeros in those between speeds.
    fn between_positions(jacobian: &Self::Jacobian) -> Self::Jacobian;
    /// A x.
    fn times(jacobian: &Self::Jacobian, x: &M::Q) -> M::L;
    /// The sum of the magnitudes of a row's terms in that.
    fn terms(jacobian: &Self::Jacobian, row: usize, x: &M::Q) -> f64;
    /// A' y.
    fn transposed_times(jacobian: &Self::Jacobian, y: &M::L) -> M::Q;
    /// The factors of A A', computed in place: moving them would take as long as computing them.
    fn factorise(jacobian: &Self::Jacobian, factors: &mut Self::Factors) -> Result<(), Undefined>;
    /// The constraint of a row of the factors.
    fn constraint(k: usize) -> usize;
}
