//! Dense linear equations: elimination with complete pivoting, one step of iterative refinement.

use super::error::{Result, refuse};

/// A factorised square matrix.
pub(super) struct Factors {
    matrix: Vec<Vec<f64>>,
    /// L below the diagonal, U on and above it, of the scaled matrix with rows and columns exchanged.
    lu: Vec<Vec<f64>>,
    rows: Vec<usize>,
    columns: Vec<usize>,
    row_scale: Vec<f64>,
    column_scale: Vec<f64>,
}

impl Factors {
    /// Factorises `matrix` \[n by n, rows\].
    ///
    /// Rows and columns are first scaled by powers of two to entries of order 1; the matrix counts as singular if only
    /// rounding, at most n eps, is left to choose a pivot from.
    pub(super) fn new(matrix: Vec<Vec<f64>>) -> Result<Factors> {
        let n = matrix.len();
        if matrix.iter().flatten().any(|entry| !entry.is_finite()) {
            return refuse("the equations have an entry that is not finite");
        }
        let row_scale: Vec<f64> = matrix.iter().map(|row| scale(row.iter().copied())).collect();
        let column = |j: usize| matrix.iter().zip(&row_scale).map(move |(row, scale)| row[j] * scale);
        let column_scale: Vec<f64> = (0..n).map(|j| scale(column(j))).collect();
        let scaled = |(row, r): (&Vec<f64>, &f64)| row.iter().zip(&column_scale).map(|(a, c)| a * r * c).collect();
        let lu = matrix.iter().zip(&row_scale).map(scaled).collect();
        let mut factors =
            Factors { matrix, lu, rows: (0..n).collect(), columns: (0..n).collect(), row_scale, column_scale };
        (0..n).try_for_each(|k| factors.eliminate(k))?;
        Ok(factors)
    }

    /// x with A x = b \[n\].
    pub(super) fn solve(&self, b: &[f64]) -> Vec<f64> {
        let x = self.substitute(b);
        let residual: Vec<f64> = self.matrix.iter().zip(b).map(|(row, b)| residual(*b, row, &x)).collect();
        let correction = self.substitute(&residual);
        x.iter().zip(correction).map(|(x, correction)| x + correction).collect()
    }

    /// |A^-1| b \[n\], for b of absolute values: how much errors of the size of b can change a solution.
    pub(super) fn amplify(&self, b: &[f64]) -> Vec<f64> {
        let n = b.len();
        let mut bound = vec![0.0; n];
        for (j, b_j) in b.iter().enumerate() {
            let unit: Vec<f64> = (0..n).map(|i| if i == j { 1.0 } else { 0.0 }).collect();
            bound.iter_mut().zip(self.solve(&unit)).for_each(|(bound, inverse)| *bound += inverse.abs() * b_j);
        }
        bound
    }

    fn eliminate(&mut self, k: usize) -> Result<()> {
        let n = self.lu.len();
        let places = (k..n).flat_map(|i| (k..n).map(move |j| (i, j)));
        let size = |(i, j): &(usize, usize)| self.lu[*i][*j].abs();
        let Some((i, j)) = places.max_by(|a, b| size(a).total_cmp(&size(b))) else { return Ok(()) };
        if size(&(i, j)) <= n as f64 * f64::EPSILON {
            return refuse("the equations of motion are singular here");
        }
        self.exchange(k, i, j);
        for i in k + 1..n {
            let factor = self.lu[i][k] / self.lu[k][k];
            self.lu[i][k] = factor;
            for j in k + 1..n {
                self.lu[i][j] -= factor * self.lu[k][j];
            }
        }
        Ok(())
    }

    fn exchange(&mut self, k: usize, i: usize, j: usize) {
        self.lu.swap(k, i);
        self.rows.swap(k, i);
        self.lu.iter_mut().for_each(|row| row.swap(k, j));
        self.columns.swap(k, j);
    }

    /// x from the factors alone.
    fn substitute(&self, b: &[f64]) -> Vec<f64> {
        let mut y: Vec<f64> = self.rows.iter().map(|i| b[*i] * self.row_scale[*i]).collect();
        for i in 0..y.len() {
            y[i] -= (0..i).map(|j| self.lu[i][j] * y[j]).sum::<f64>();
        }
        for i in (0..y.len()).rev() {
            let known: f64 = (i + 1..y.len()).map(|j| self.lu[i][j] * y[j]).sum();
            y[i] = (y[i] - known) / self.lu[i][i];
        }
        let mut x = vec![0.0; y.len()];
        self.columns.iter().zip(y).for_each(|(j, y)| x[*j] = y * self.column_scale[*j]);
        x
    }
}

/// The power of two that brings the largest of `entries` to about 1; 1 where all are zero.
fn scale(entries: impl Iterator<Item = f64>) -> f64 {
    let largest = entries.fold(0.0, |largest: f64, entry| largest.max(entry.abs()));
    if largest == 0.0 { 1.0 } else { (-largest.log2().floor()).exp2() }
}

/// b - row.x as if in twice the precision: every product and sum is carried with its own rounding error.
fn residual(b: f64, row: &[f64], x: &[f64]) -> f64 {
    let (mut sum, mut lost) = (b, 0.0);
    for (a, x) in row.iter().zip(x) {
        let product = -a * x;
        let total = sum + product;
        let back = total - sum;
        lost += (-a).mul_add(*x, -product) + ((sum - (total - back)) + (product - back));
        sum = total;
    }
    sum + lost
}

#[cfg(test)]
mod tests;
