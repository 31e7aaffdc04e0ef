//! Degrees of freedom, and constraints that say what others say already.

use crate::failure::{Failure, What, constraint_name};
use nalgebra::{DMatrix, DVector};
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
    let angles = independence(mechanism, time, q);
    let rows = || angles.iter().enumerate();
    let dependent: Vec<_> =
        rows().filter(|(_, sine)| !(**sine > DEPENDENT)).map(|(i, _)| constraint_name::<M>(i)).collect();
    Mobility { degrees_of_freedom: M::Q::LEN + dependent.len() - M::L::LEN, dependent }
}

/// For each row of C_q the sine of its angle to the space of those before it.
fn independence<M: Mechanism>(mechanism: &M, time: f64, q: &M::Q) -> Vec<f64> {
    let jacobian = mechanism.constraint_jacobian(time, q);
    let mut basis: Vec<DVector<f64>> = Vec::new();
    let of_row = |i: usize| {
        let row = DVector::from_iterator(M::Q::LEN, jacobian[i].iter().copied());
        let mut rest = row.clone();
        // Twice, so that rounding leaves nothing of what was taken.
        for direction in basis.iter().chain(&basis) {
            rest -= direction * direction.dot(&rest);
        }
        let sine = rest.norm() / row.norm();
        if sine > DEPENDENT {
            basis.push(rest.normalize());
        }
        sine
    };
    (0..M::L::LEN).map(of_row).collect()
}

/// A negative kinetic energy this small beside the others is rounding.
const NEGATIVE: f64 = 1e-10;

/// That no motion has negative kinetic energy: the mass matrix, constraints apart, has no negative eigenvalue.
///
/// # Errors
/// [`What::NegativeMass`], with the parameters that are negative.
pub fn check_masses<M: Mechanism>(mechanism: &M, time: f64, q: &M::Q) -> Result<(), Failure> {
    let mass = mechanism.mass_matrix(time, q);
    let n = M::Q::LEN;
    let matrix = DMatrix::from_fn(n, n, |i, j| mass[i][j]);
    if n == 0 || matrix.iter().any(|entry| !entry.is_finite()) {
        return Ok(());
    }
    let eigen = matrix.symmetric_eigen();
    let (at, least) = eigen.eigenvalues.argmin();
    if least >= -NEGATIVE * eigen.eigenvalues.amax() {
        return Ok(());
    }
    let coordinate = M::DESCRIPTION.coordinates[eigen.eigenvectors.column(at).iamax()].position.name;
    let parameters = mechanism.parameters();
    let negative = M::DESCRIPTION
        .parameters
        .iter()
        .zip(parameters.iter())
        .filter(|(p, value)| **value < 0.0 && p.unit.contains('g'));
    let names: Vec<String> =
        negative.map(|(p, value)| format!("`{}` is {} {}", p.name, value / p.factor, p.unit)).collect();
    let suspects = if names.is_empty() { String::new() } else { format!("; {}", names.join(", ")) };
    Err(Failure::at::<M>(What::NegativeMass { coordinate, suspects }, time, q))
}
