//! Which coordinates, or speeds, are independent, and how the others follow from them.

use nalgebra::DMatrix;
use std::ops::Range;

/// Columns of coordinates preferred as dependent are chosen as long as their pivots are this large, in a matrix whose
/// rows and columns are brought to largest entries near 1.
const REGULAR: f64 = 1e-3;

/// The preference for a coordinate to be independent.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(super) enum Wanted {
    /// The declaration gives neither its value nor its speed at the start.
    Dependent,
    /// It gives its value.
    Independent,
    /// It gives its speed.
    First,
}

/// Independent and dependent columns of a constraint Jacobian.
#[derive(Clone, Debug)]
pub(super) struct Split {
    /// The independent columns, in order.
    pub(super) independent: Vec<usize>,
    /// The row that each dependent column is eliminated by, and the column; in the order of elimination.
    pivots: Vec<(usize, usize)>,
}

impl Split {
    /// The number of dependent columns is the rank of the Jacobian. They are chosen by elimination with complete
    /// pivoting, first among those not preferred as independent.
    pub(super) fn new(jacobian: &DMatrix<f64>, rank: usize, wanted: &[Wanted]) -> Split {
        let n = jacobian.ncols();
        let mut matrix = equilibrated(jacobian);
        let mut pivots: Vec<(usize, usize)> = Vec::new();
        let classes = [Wanted::Dependent, Wanted::Independent, Wanted::First].map(|class| (class, REGULAR));
        for (class, least) in classes.into_iter().chain([(Wanted::First, 0.0)]) {
            while pivots.len() < rank {
                let is_free = |at: &(usize, usize)| {
                    wanted[at.1] <= class && pivots.iter().all(|taken| taken.0 != at.0 && taken.1 != at.1)
                };
                let entries = (0..matrix.nrows()).flat_map(|i| (0..n).map(move |j| (i, j))).filter(is_free);
                let largest = entries.max_by(|a, b| matrix[*a].abs().total_cmp(&matrix[*b].abs()));
                let Some(pivot) = largest.filter(|at| matrix[*at].abs() > least) else { break };
                eliminate(&mut matrix, pivot, 0..n);
                pivots.push(pivot);
            }
        }
        let independent = (0..n).filter(|j| pivots.iter().all(|(_, column)| column != j)).collect();
        Split { independent, pivots }
    }

    /// The number of dependent columns.
    pub(super) fn rank(&self) -> usize {
        self.pivots.len()
    }

    /// The dependent parts x_d of J_d x_d = -(J_i x_i + r), with J at any position near that of the choice: `own` x n is the part
    /// of all columns of x that is given, in the rows of independent ones. Rows of J that depend on others are left out.
    pub(super) fn complete(&self, jacobian: &DMatrix<f64>, own: DMatrix<f64>, rates: &DMatrix<f64>) -> DMatrix<f64> {
        let (n, columns) = own.shape();
        let mut matrix = jacobian.clone().resize_horizontally(n + columns, 0.0);
        matrix.columns_mut(n, columns).copy_from(rates);
        for pivot in &self.pivots {
            eliminate(&mut matrix, *pivot, 0..n + columns);
        }
        let mut all = own;
        for (row, column) in &self.pivots {
            for k in 0..columns {
                let driven: f64 = self.independent.iter().map(|j| matrix[(*row, *j)] * all[(*j, k)]).sum();
                all[(*column, k)] = -(driven + matrix[(*row, n + k)]);
            }
        }
        all
    }

    /// The values of the pivots in the elimination of a nearby Jacobian.
    pub(super) fn pivot_values(&self, jacobian: &DMatrix<f64>) -> Vec<f64> {
        let mut matrix = jacobian.clone();
        let mut value = |pivot: &(usize, usize)| {
            let value = matrix[*pivot];
            eliminate(&mut matrix, *pivot, 0..jacobian.ncols());
            value
        };
        self.pivots.iter().map(&mut value).collect()
    }

    /// Unit changes of the independent ones, n x f.
    pub(super) fn units(&self, n: usize) -> DMatrix<f64> {
        let mut own = DMatrix::zeros(n, self.independent.len());
        self.independent.iter().enumerate().for_each(|(k, j)| own[(*j, k)] = 1.0);
        own
    }
}

/// Makes the column of a pivot a unit vector with its 1 in the row of it.
fn eliminate(matrix: &mut DMatrix<f64>, (row, column): (usize, usize), columns: Range<usize>) {
    let pivot = matrix[(row, column)];
    columns.clone().for_each(|j| matrix[(row, j)] /= pivot);
    for i in (0..matrix.nrows()).filter(|i| *i != row) {
        let factor = matrix[(i, column)];
        if factor != 0.0 {
            columns.clone().for_each(|j| matrix[(i, j)] -= factor * matrix[(row, j)]);
        }
    }
}

/// Rows and columns brought to largest entries near 1, so that units do not decide.
fn equilibrated(jacobian: &DMatrix<f64>) -> DMatrix<f64> {
    let mut matrix = jacobian.clone();
    let largest =
        |entries: &mut dyn Iterator<Item = &f64>| entries.fold(0.0, |largest: f64, entry| largest.max(entry.abs()));
    for _ in 0..2 {
        for mut row in matrix.row_iter_mut() {
            let size = largest(&mut row.iter());
            row.iter_mut().filter(|_| size > 0.0).for_each(|entry| *entry /= size);
        }
        for mut column in matrix.column_iter_mut() {
            let size = largest(&mut column.iter());
            column.iter_mut().filter(|_| size > 0.0).for_each(|entry| *entry /= size);
        }
    }
    matrix
}
