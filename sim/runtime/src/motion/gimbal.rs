//! Gimbal lock: positions in which the angles of an attitude do not determine its angular velocity.

use crate::state::failure::{Failure, What};
use nalgebra::DMatrix;
use sim_kernel::{Description, Mechanism};

/// A motion of the coordinates with so small a kinetic energy, relative to others of the same size, does not move the
/// body.
const STILL: f64 = 1e-9;
/// Entries of a direction this small relative to the largest count as zero.
const NO_PART: f64 = 0.1;

/// The failure of a motion here, reported as gimbal lock if it is: in space, some coordinates can change together
/// without moving anything, though each of them alone moves something.
pub(crate) fn explained<M: Mechanism>(failure: Failure, mechanism: &M, time: f64, q: &M::Q) -> Failure {
    let (mass, jacobian) = (mechanism.mass_matrix(time, q), mechanism.constraint_jacobian(time, q));
    let mass = DMatrix::from_fn(mechanism.n(), mechanism.n(), |i, j| mass[i][j]);
    let locked = locked(mechanism.description(), &mass, &|row, j| jacobian[row][j]);
    if locked.len() < 2 {
        return failure;
    }
    let angles = format!("`{}`", locked.join("` and `"));
    Failure { what: What::GimbalLock { angles }, ..failure }
}

/// The coordinates in a motion without kinetic energy, by the mass matrix and the entries of C_q.
fn locked(
    description: &'static Description,
    mass: &DMatrix<f64>,
    jacobian: &dyn Fn(usize, usize) -> f64,
) -> Vec<&'static str> {
    if description.dimension < 3 {
        return vec![];
    }
    let n = mass.nrows();
    // Each coordinate in the unit in which it alone has energy 1.
    let size = |i: usize| mass[(i, i)].abs().sqrt();
    if n == 0 || (0..n).any(|i| !(size(i) > 0.0) || !size(i).is_finite()) {
        return vec![];
    }
    let eigen = DMatrix::from_fn(n, n, |i, j| mass[(i, j)] / (size(i) * size(j))).symmetric_eigen();
    let (at, least) = eigen.eigenvalues.argmin();
    if !(least < STILL) {
        return vec![];
    }
    let direction = eigen.eigenvectors.column(at);
    let largest = direction.amax();
    let parts: Vec<usize> = (0..n).filter(|i| direction[*i].abs() > NO_PART * largest).collect();
    // The length of a quaternion moves nothing either, but its constraint holds it.
    if description.norm_constraints.iter().any(|row| parts.iter().any(|i| jacobian(*row, *i) != 0.0)) {
        return vec![];
    }
    parts.into_iter().map(|i| description.coordinates[i].position.name).collect()
}
