//! The scales of differences of coordinates, speeds and accelerations, independent of units.

use super::worst::largest;
use crate::model::{AnyMechanism, At};

/// One number s for each coordinate, such that all s q are comparable, in sqrt(kg)*m: the root of its inertia, M_jj at
/// its largest in these samples. Rounding of a solution, by elimination or by projection, spreads among unknowns in
/// proportion to 1/s, because M and C_q are of order 1 in s q; so |s dq| is compared with the largest |s q|, and a
/// coordinate that only rounding moves is not compared with itself.
///
/// A coordinate without inertia takes that of the coordinates to which a constraint couples it, scaled by the ratio of
/// their entries in C_q.
pub(super) fn scales(mechanism: &dyn AnyMechanism, samples: &[At<f64>]) -> Vec<f64> {
    let n = samples.first().map_or(0, |sample| sample.positions.len());
    let masses: Vec<_> = samples.iter().map(|sample| mechanism.mass_matrix(sample.time, sample.positions)).collect();
    let mut scales: Vec<f64> = (0..n).map(|j| largest(masses.iter().map(|mass| mass[(j, j)])).sqrt()).collect();
    let Some(first) = samples.first() else { return scales };
    let jacobian = mechanism.constraint_jacobian(first.time, first.positions);
    let known = scales.clone();
    for j in (0..n).filter(|j| known[*j] == 0.0) {
        let through = |row: usize| {
            let others = (0..n).filter(|i| known[*i] > 0.0 && jacobian[(row, *i)] != 0.0);
            others.map(|i| known[i] * (jacobian[(row, j)] / jacobian[(row, i)]).abs()).fold(f64::INFINITY, f64::min)
        };
        scales[j] = largest((0..jacobian.nrows()).map(through));
    }
    let all = largest(scales.iter().copied());
    let unit = if all > 0.0 { all } else { 1.0 };
    scales.into_iter().map(|scale| if scale > 0.0 { scale } else { unit }).collect()
}
