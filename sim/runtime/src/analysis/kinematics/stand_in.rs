//! Drives that are declared as constraints, `drive: alpha = n*t`: a sweep of alpha replaces such a row.

use super::driven::Driven;
use crate::model::Differentiable;
use {crate::motion::typed::Any, sim_kernel::Mechanism};

/// A drive in place of a constraint.
#[derive(Clone, Copy, Debug)]
pub(super) struct StandIn {
    /// Which constraint, by index.
    pub(super) row: usize,
    /// The place of the law of the drive.
    pub(super) law: usize,
    /// dC/dq of the coordinate.
    pub(super) factor: f64,
}

/// Times, in seconds, at which a prescribed motion differs.
pub(super) const TIMES: [f64; 3] = [0.0, 0.37, 1.91];
/// The distances, increasing for each coordinate, at which the row is checked again.
const AWAY: [f64; 2] = [0.1, 0.013];

/// The first coordinate that a constraint prescribes as a function of time, and its speed at the start.
#[inline(never)]
pub fn prescribed_coordinate<M: Mechanism>(mechanism: &M, q: &M::Q) -> Option<(usize, f64)> {
    let (mechanism, q): (&dyn Differentiable, &[f64]) = (&Any(mechanism), q.as_ref());
    let rates = mechanism.constraint_time_derivative(0.0, q);
    let of =
        |j: usize| stand_in(mechanism, Driven::Coordinate(j), 0, q).map(|drive| (j, -rates[drive.row] / drive.factor));
    (0..q.len()).find_map(of)
}

/// Another position.
pub(super) fn elsewhere(q: &[f64]) -> Vec<f64> {
    q.iter().enumerate().map(|(j, q)| q + AWAY[0] + AWAY[1] * j as f64).collect()
}

/// The constraint that prescribes a coordinate as a function of time, and holds nothing else.
pub(super) fn stand_in(mechanism: &dyn Differentiable, driven: Driven, law: usize, q: &[f64]) -> Option<StandIn> {
    let Driven::Coordinate(coordinate) = driven else { return None };
    let jacobians = [q, &elsewhere(q)].map(|q| mechanism.constraint_jacobian(0.0, q));
    let values = TIMES.map(|time| mechanism.constraints(time, q));
    let factor = |row: usize| jacobians[0][(row, coordinate)];
    let holds_it_alone = |row: usize| {
        let alone = |j: usize| j == coordinate || jacobians.iter().all(|jacobian| jacobian[(row, j)] == 0.0);
        factor(row) != 0.0 && jacobians[1][(row, coordinate)] == factor(row) && (0..q.len()).all(alone)
    };
    let moves = |row: usize| values[1..].iter().any(|later| later[row] != values[0][row]);
    let is_one = |row: &usize| mechanism.is_active(*row) && holds_it_alone(*row) && moves(*row);
    (0..values[0].len()).find(is_one).map(|row| StandIn { row, law, factor: factor(row) })
}
