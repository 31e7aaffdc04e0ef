//! Small linear systems of the curve.

use nalgebra::{DMatrix, DVector};

/// A correction this small that no longer shrinks is rounding.
const ROUNDING: f64 = 1e-9;
/// Directions in which F_q is this small relative to its largest part keep the curve's own position.
const REGULAR: f64 = 1e-4;
/// The number of sweeps after which a decomposition is given up; a few for each singular value are usual.
const MOST_SWEEPS: usize = 10_000;

/// Corrections end when they are rounding, or no longer shrink.
pub(super) fn is_rounding(size: f64, last: f64, z: &DVector<f64>) -> bool {
    let floor = 4.0 * f64::EPSILON * (1.0 + z.norm());
    size <= floor || (size <= ROUNDING && size >= 0.25 * last)
}

/// A matrix with a row below it.
pub(super) fn bordered(matrix: DMatrix<f64>, row: &DVector<f64>) -> DMatrix<f64> {
    let m = matrix.nrows();
    let mut bordered = matrix.insert_row(m, 0.0);
    bordered.row_mut(m).copy_from(&row.transpose());
    bordered
}

/// The x with A x nearest to the right-hand side.
pub(super) fn least_squares(matrix: DMatrix<f64>, mut rhs: DVector<f64>) -> Option<DVector<f64>> {
    if matrix.is_square() {
        return matrix.lu().solve(&rhs);
    }
    let (n, factors) = (matrix.ncols(), matrix.qr());
    factors.q_tr_mul(&mut rhs);
    factors.r().solve_upper_triangular(&rhs.rows(0, n).into_owned())
}

/// The singular values, the largest first, if the matrix is finite.
pub(super) fn singular_values(matrix: &DMatrix<f64>) -> Option<DVector<f64>> {
    let decomposed = || matrix.clone().try_svd(false, false, 5.0 * f64::EPSILON, MOST_SWEEPS);
    matrix.iter().all(|entry| entry.is_finite()).then(decomposed)?.map(|found| found.singular_values)
}

/// The combination of rows that is nearest to zero, of length 1.
pub(super) fn dependence_of_rows(matrix: DMatrix<f64>) -> Option<DVector<f64>> {
    let decomposed = matrix.try_svd(true, false, 5.0 * f64::EPSILON, MOST_SWEEPS)?;
    decomposed.u?.column_iter().next_back().map(|column| column.into_owned())
}

/// The shortest change that closes the equations, except in directions in which the curve's own position is more
/// accurate: beside a crossing these amplify rounding.
pub(super) fn in_regular_directions(matrix: DMatrix<f64>, rhs: &DVector<f64>) -> Option<DVector<f64>> {
    if matrix.iter().any(|entry| !entry.is_finite()) {
        return None;
    }
    let factors = matrix.try_svd(true, true, 5.0 * f64::EPSILON, MOST_SWEEPS)?;
    let least = REGULAR * factors.singular_values[0];
    factors.solve(rhs, least).ok()
}
