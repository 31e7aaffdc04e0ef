//! Positions near one that satisfy the constraints too. What is so at all of them is no accident of a single position.

use crate::conditional::is_active;
use crate::project::project_positions;
use nalgebra::{DMatrix, DVector};
use sim_kernel::{Array, Mechanism};

/// How far away they are: this part of the size of the coordinate that moves most beside its own.
const AWAY: f64 = 0.01;
/// A singular value this small beside the largest is zero.
const NULL: f64 = 1e-9;
/// In what share the next direction is added to each, so that more than those of the basis are tried.
const SHARE: f64 = 0.37;

/// Those found by going in directions that C_q allows here, to both sides, and back onto the constraints. Where nothing
/// moves there are none.
pub(crate) fn nearby_positions<M: Mechanism>(mechanism: &M, time: f64, q: &M::Q) -> Vec<M::Q> {
    let basis = null_space::<M>(mechanism, time, q);
    let mixed = (0..basis.len()).map(|k| &basis[k] + SHARE * &basis[(k + 1) % basis.len()]);
    let directions = basis.iter().cloned().chain(mixed);
    let moved = |direction: DVector<f64>| {
        [AWAY, -AWAY].into_iter().filter_map(move |away| {
            let share = |j: usize| direction[j] / size::<M>(q, j);
            let largest = (0..M::Q::LEN).map(|j| share(j).abs()).fold(0.0, f64::max);
            let mut there = M::Q::from_fn(|j| q[j] + away / largest * direction[j]);
            project_positions(mechanism, time, &mut there).ok()?;
            // Not where it came from.
            let has_moved = (0..M::Q::LEN).any(|j| (there[j] - q[j]).abs() > 0.1 * AWAY * size::<M>(q, j));
            has_moved.then_some(there)
        })
    };
    directions.flat_map(moved).collect()
}

/// What a coordinate is measured by: its value, or its unit.
fn size<M: Mechanism>(q: &M::Q, j: usize) -> f64 {
    q[j].abs().max(M::DESCRIPTION.coordinates[j].position.factor)
}

/// An orthonormal basis of the speeds that the constraints that hold allow.
fn null_space<M: Mechanism>(mechanism: &M, time: f64, q: &M::Q) -> Vec<DVector<f64>> {
    let (n, jacobian) = (M::Q::LEN, mechanism.constraint_jacobian(time, q));
    // Square at least, so that the decomposition gives all directions.
    let entry = |i: usize, j: usize| if i < M::L::LEN && is_active(mechanism, i) { jacobian[i][j] } else { 0.0 };
    let matrix = DMatrix::from_fn(n.max(M::L::LEN), n, entry);
    if matrix.iter().any(|entry| !entry.is_finite()) {
        return Vec::new();
    }
    let svd = matrix.svd(false, true);
    let Some(directions) = svd.v_t else { return Vec::new() };
    let is_null = |k: &usize| svd.singular_values[*k] <= NULL * svd.singular_values.amax();
    (0..n).filter(is_null).map(|k| directions.row(k).transpose()).collect()
}
