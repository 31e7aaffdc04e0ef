//! Positions near one that satisfy the constraints too. A property of all of them is not accidental to a single
//! position.

use crate::model::AnyMechanism;
use crate::motion::lengths::{measure, without_units};
use nalgebra::DVector;

/// Their distance: this fraction of the scale of the coordinate with the largest relative change.
const AWAY: f64 = 0.01;
/// A singular value this small relative to the largest, or to 1, is zero.
const NULL: f64 = 1e-9;
/// The share of the next direction that is added to each, so that more directions than the basis are tried.
const SHARE: f64 = 0.37;

/// Those found by moving along directions that C_q allows here, to both sides, and projecting. If nothing moves there
/// are none.
pub(crate) fn nearby_positions(mechanism: &dyn AnyMechanism, time: f64, q: &[f64]) -> Vec<Vec<f64>> {
    let measures = measure(mechanism, time, q);
    let basis = null_space(mechanism, time, q, &measures);
    let mixed = (0..basis.len()).map(|k| &basis[k] + SHARE * &basis[(k + 1) % basis.len()]);
    let directions = basis.iter().cloned().chain(mixed);
    let (sizes, _) = &measures;
    let mut found = Vec::new();
    for direction in directions {
        let largest = direction.amax();
        for away in [AWAY, -AWAY] {
            let change = |j: usize| away / largest * direction[j] * sizes[j];
            let mut there: Vec<f64> = (0..q.len()).map(|j| q[j] + change(j)).collect();
            let is_position = mechanism.project_positions(time, &mut there).is_ok();
            // Not where it came from.
            if is_position && (0..q.len()).any(|j| (there[j] - q[j]).abs() > 0.1 * AWAY * sizes[j]) {
                found.push(there);
            }
        }
    }
    found
}

/// An orthonormal basis of the speeds that the active constraints allow, in the scales of the coordinates.
fn null_space(
    mechanism: &dyn AnyMechanism,
    time: f64,
    q: &[f64],
    measures: &(Vec<f64>, Vec<f64>),
) -> Vec<DVector<f64>> {
    let (n, jacobian) = (q.len(), without_units(mechanism.constraint_jacobian(time, q), measures));
    let rows = jacobian.nrows();
    // At least square, so that the decomposition gives all directions.
    let mut matrix = jacobian.resize_vertically(n.max(rows), 0.0);
    (0..rows).filter(|row| !mechanism.is_active(*row)).for_each(|row| matrix.row_mut(row).fill(0.0));
    if matrix.iter().any(|entry| !entry.is_finite()) {
        return Vec::new();
    }
    let svd = matrix.svd(false, true);
    let Some(directions) = svd.v_t else { return Vec::new() };
    let is_null = |k: &usize| svd.singular_values[*k] <= NULL * svd.singular_values.amax().max(1.0);
    (0..n).filter(is_null).map(|k| directions.row(k).transpose()).collect()
}
