//! Degrees of freedom, and constraints that say what others say already.

use crate::failure::constraint_name;
use nalgebra::DVector;
use sim_kernel::{Array, Mechanism};

/// What the constraints leave free at a position.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Mobility {
    /// How many coordinates can move independently: n less the rank of C_q.
    pub degrees_of_freedom: usize,
    /// The constraints that depend on those before them. Their share of the reactions is not determined, and is
    /// reported as 0.
    pub dependent: Vec<&'static str>,
}

/// A row is dependent whose distance from the space of those before it is less than this part of its length.
const DEPENDENT: f64 = 1e-7;

/// Degrees of freedom and dependent constraints at a position, by orthogonalisation of the rows of C_q, in order.
pub fn mobility<M: Mechanism>(mechanism: &M, time: f64, q: &M::Q) -> Mobility {
    let jacobian = mechanism.constraint_jacobian(time, q);
    let (n, m) = (M::Q::LEN, M::L::LEN);
    let mut basis: Vec<DVector<f64>> = Vec::new();
    let mut dependent = Vec::new();
    for i in 0..m {
        let row = DVector::from_iterator(n, jacobian[i].iter().copied());
        let mut rest = row.clone();
        // Twice, so that rounding leaves nothing of what was taken.
        for direction in basis.iter().chain(&basis) {
            rest -= direction * direction.dot(&rest);
        }
        match rest.norm() > DEPENDENT * row.norm() {
            true => basis.push(rest.normalize()),
            false => dependent.push(constraint_name::<M>(i)),
        }
    }
    Mobility { degrees_of_freedom: n - basis.len(), dependent }
}
