//! Which coordinates, or speeds, are independent, and how the others follow from them.

use nalgebra::DMatrix;
use std::ops::Range;

/// Columns of coordinates preferred as dependent are chosen as long as their pivots are this large, beside the largest entry
/// of the row: a coordinate that is at its turning point does not tell where the others are. Columns are in the scales of the
/// coordinates, rows brought to largest entries near 1.
const REGULAR: f64 = 1e-3;
/// A row in which all is smaller is the rounding of those before it.
const LEAST: f64 = 1e-9;

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
    /// pivoting, first among those not preferred as independent, in these scales of the coordinates.
    pub(super) fn new(jacobian: &DMatrix<f64>, rank: usize, wanted: &[Wanted], sizes: &[f64]) -> Split {
        let n = jacobian.ncols();
        let mut matrix = scaled(jacobian, sizes);
        let mut pivots: Vec<(usize, usize)> = Vec::new();
        let classes = [Wanted::Dependent, Wanted::Independent, Wanted::First].map(|class| (class, REGULAR, LEAST));
        for (class, regular, least) in classes.into_iter().chain([(Wanted::First, 0.0, 0.0)]) {
            while pivots.len() < rank {
                let is_free = |at: &(usize, usize)| pivots.iter().all(|taken| taken.0 != at.0 && taken.1 != at.1);
                let size = |at: &(usize, usize)| matrix[*at].abs();
                let row = |i: usize| (0..n).map(move |j| (i, j)).filter(is_free);
                let largest_in_row = |i: usize| row(i).map(|at| size(&at)).fold(0.0, f64::max);
                let is_regular =
                    |at: &(usize, usize)| wanted[at.1] <= class && size(at) > least.max(regular * largest_in_row(at.0));
                let entries = (0..matrix.nrows()).flat_map(row).filter(is_regular);
                let Some(pivot) = entries.max_by(|a, b| size(a).total_cmp(&size(b))) else { break };
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

/// Columns in these scales, and rows brought to largest entries near 1, so that units do not decide.
fn scaled(jacobian: &DMatrix<f64>, sizes: &[f64]) -> DMatrix<f64> {
    let mut matrix = jacobian.clone();
    matrix.column_iter_mut().zip(sizes).for_each(|(mut column, size)| column *= *size);
    for mut row in matrix.row_iter_mut() {
        let largest = row.amax();
        row.iter_mut().filter(|_| largest > 0.0).for_each(|entry| *entry /= largest);
    }
    matrix
}
