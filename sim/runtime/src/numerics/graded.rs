//! Linear equations whose unknowns are of very unequal stiffness.

use nalgebra::{DMatrix, DVector, Dyn, SVD};

/// Sweeps after which rows and columns are near enough to largest entries of 1; each takes the root of what is lacking.
const SWEEPS: usize = 8;
/// Sweeps after which a decomposition is given up; a few for each row are usual.
const MOST_SWEEPS: usize = 10_000;

/// The factors of R A C, with R and C diagonal and such that the largest entry of each row and column is near 1: then an
/// unknown is soft only if it is so beside itself, and not beside another. (Ruiz, A scaling algorithm to equilibrate both
/// rows and columns norms in matrices, RAL-TR-2001-034.)
pub(crate) struct Graded {
    factors: SVD<f64, Dyn, Dyn>,
    rows: DVector<f64>,
    columns: DVector<f64>,
}

impl Graded {
    /// Of a square matrix whose entries are known up to these errors: those below them are zero, and must not be scaled up.
    pub(crate) fn new(mut matrix: DMatrix<f64>, errors: &DMatrix<f64>) -> Option<Graded> {
        matrix.zip_apply(errors, |entry, error| {
            if entry.abs() <= error {
                *entry = 0.0;
            }
        });
        let root = |largest: f64| if largest > 0.0 { largest.sqrt().recip() } else { 1.0 };
        let [mut rows, mut columns] = [(); 2].map(|()| DVector::repeat(matrix.nrows(), 1.0));
        for _ in 0..SWEEPS {
            let by_row = DVector::from_iterator(rows.len(), matrix.row_iter().map(|row| root(row.amax())));
            let by_column = DVector::from_iterator(rows.len(), matrix.column_iter().map(|column| root(column.amax())));
            for (i, j) in (0..rows.len()).flat_map(|i| (0..rows.len()).map(move |j| (i, j))) {
                matrix[(i, j)] *= by_row[i] * by_column[j];
            }
            rows.component_mul_assign(&by_row);
            columns.component_mul_assign(&by_column);
        }
        let factors = matrix.try_svd(true, true, f64::EPSILON, MOST_SWEEPS)?;
        Some(Graded { factors, rows, columns })
    }

    /// The directions that the matrix takes to nothing, up to this part of the largest, n x k.
    pub(crate) fn free(&self, least: f64) -> DMatrix<f64> {
        let least = least * self.factors.singular_values.amax();
        let values = self.factors.singular_values.iter().enumerate();
        let free: Vec<usize> = values.filter(|(_, value)| **value <= least).map(|(k, _)| k).collect();
        let mut directions = match &self.factors.v_t {
            Some(directions) => directions.select_rows(&free).transpose(),
            None => DMatrix::zeros(self.columns.len(), 0),
        };
        directions.column_iter_mut().for_each(|mut direction| direction.component_mul_assign(&self.columns));
        directions
    }

    /// x of A x = b without those directions.
    pub(crate) fn solve(&self, right: &DVector<f64>, least: f64) -> Option<DVector<f64>> {
        let least = (least * self.factors.singular_values.amax()).max(f64::MIN_POSITIVE);
        let scaled = self.factors.solve(&right.component_mul(&self.rows), least).ok()?;
        Some(scaled.component_mul(&self.columns))
    }
}
