//! Reactions that belong to accelerations.

use crate::motion::Motion;
use crate::state::trajectory::State;
use nalgebra::{DMatrix, DVector};
use sim_kernel::{Array, Mechanism};

/// What constraints resist by less than this part of what they resist most they do not resist: at a singular position reactions may
/// have a pole.
const WEAK: f64 = 1e-9;

/// The multipliers nearest to some with which these accelerations meet C_q' lambda = T_q' (F - M g) - T_q' M T_q q'', in all directions
/// that the constraints resist.
pub(crate) fn consistent<M: Mechanism>(
    motion: &Motion<M>,
    state: &State<M>,
    accelerations: &M::Q,
    multipliers: &M::L,
) -> M::L {
    let (mechanism, State { time, positions: q, speeds, .. }) = (motion.mechanism(), state);
    let jacobian = mechanism.constraint_linearization(*time, q).jacobian;
    let mass = mechanism.mass_matrix(*time, q);
    let (forces, convective) =
        (mechanism.generalized_forces(*time, q, speeds), mechanism.convective_forces(*time, q, speeds));
    let (n, m) = (mechanism.n(), mechanism.m());
    let scales = motion.measures().coordinates();
    let along = |j: usize| (0..m).map(|row| jacobian[row][j] * multipliers[row]).sum::<f64>();
    let inertial = |j: usize| (0..n).map(|k| mass[j][k] * accelerations[k]).sum::<f64>();
    let open = |j: usize| (forces[j] - convective[j] - inertial(j) - along(j)) * scales[j];
    let length = |row: usize| (0..n).map(|j| (jacobian[row][j] * scales[j]).powi(2)).sum::<f64>().sqrt();
    let lengths: Vec<f64> = (0..m).map(|row| if length(row) > 0.0 { length(row) } else { 1.0 }).collect();
    let rows = DMatrix::from_fn(n, m, |j, row| jacobian[row][j] * scales[j] / lengths[row]);
    let change = nearest(rows, DVector::from_fn(n, |j, _| open(j)));
    multipliers.like(|row| multipliers[row] + change.as_ref().map_or(0.0, |change| change[row] / lengths[row]))
}

fn nearest(rows: DMatrix<f64>, open: DVector<f64>) -> Option<DVector<f64>> {
    if rows.iter().chain(&open).any(|value| !value.is_finite()) {
        return None;
    }
    let factors = rows.svd(true, true);
    let largest = factors.singular_values.iter().fold(f64::MIN_POSITIVE, |a: f64, b| a.max(*b));
    factors.solve(&open, WEAK * largest).ok()
}
