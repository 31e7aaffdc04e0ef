//! Small dense linear systems of fixed size, without allocation.

use super::numbers::{finite, sum};
use super::power_of_two::power_of_two;
use sim_kernel::{Array, Mask, Scalar};
use std::marker::PhantomData;

/// A pivot this much smaller than the largest counts as zero. Rows and columns are first scaled to comparable size, so
/// that units do not matter.
const SMALLEST_PIVOT: f64 = 1e-13;

/// The squared sine of the angle between a row and those before it, below which it counts as dependent: a correction
/// would amplify rounding by its inverse root.
pub(crate) const LEAST_INDEPENDENCE: f64 = 1e-8;

/// The largest residual of equations without a pivot, relative to the right-hand side, that agree with the others.
const CONSISTENT: f64 = 1e-6;

/// A solution of a square system, perhaps not unique.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Solved<R> {
    /// The solution; undetermined unknowns are zero.
    pub(crate) solution: R,
    /// The unknowns in the order of their pivots.
    order: R,
    /// The number of unknowns with a pivot.
    rank: usize,
    /// Whether the equations without a pivot agree with the others.
    pub(crate) is_consistent: bool,
}

impl<R: Array<f64>> Solved<R> {
    /// The unknowns that no equation determines.
    pub(crate) fn undetermined(&self) -> impl Iterator<Item = usize> + '_ {
        (self.rank..self.order.len()).map(|k| self.order[k] as usize)
    }
}

/// Solves a square system by elimination with complete pivoting, after scaling rows and columns by powers of 2.
pub(crate) fn solve<A: Array<R>, R: Array<f64>>(mut matrix: A, mut rhs: R) -> Solved<R> {
    let n = rhs.len();
    let column_scale = equilibrate(&mut matrix, &mut rhs);
    let size_of_rhs = rhs.iter().fold(0.0f64, |size, value| size.max(value.abs()));
    let mut order = rhs.like(|i| i as f64);
    let mut first_pivot = 0.0f64;
    let mut rank = 0;
    while rank < n {
        let k = rank;
        let (row, column, size) = largest_entry(&matrix, k);
        first_pivot = first_pivot.max(size);
        if !(size > SMALLEST_PIVOT * first_pivot) {
            break;
        }
        matrix.as_mut().swap(k, row);
        rhs.as_mut().swap(k, row);
        for i in 0..n {
            matrix[i].as_mut().swap(k, column);
        }
        order.as_mut().swap(k, column);
        eliminate(&mut matrix, &mut rhs, k);
        rank += 1;
    }
    let is_consistent = (rank..n).all(|k| rhs[k].abs() <= CONSISTENT * size_of_rhs);
    let mut solution = rhs.like(|_| 0.0);
    for k in (0..rank).rev() {
        let known: f64 = (k + 1..rank).map(|j| matrix[k][j] * rhs[j]).sum();
        rhs[k] = (rhs[k] - known) / matrix[k][k];
        let unknown = order[k] as usize;
        solution[unknown] = rhs[k] * column_scale[unknown];
    }
    Solved { solution, order, rank, is_consistent }
}

/// Takes multiples of row k from those below it.
fn eliminate<A: Array<R>, R: Array<f64>>(matrix: &mut A, rhs: &mut R, k: usize) {
    let (above, below) = matrix.as_mut().split_at_mut(k + 1);
    let pivot_row = &above[k].as_ref()[k..];
    for (i, row) in below.iter_mut().enumerate() {
        let row = &mut row.as_mut()[k..];
        let factor = row[0] / pivot_row[0];
        if factor != 0.0 {
            row.iter_mut().zip(pivot_row).skip(1).for_each(|(entry, pivot)| *entry -= factor * pivot);
            rhs[k + 1 + i] -= factor * rhs[k];
        }
    }
}

/// Scales rows and columns to largest entries near 1; gives the scales of the columns.
fn equilibrate<A: Array<R>, R: Array<f64>>(matrix: &mut A, rhs: &mut R) -> R {
    let n = rhs.len();
    let mut column_scale = rhs.like(|_| 1.0);
    for _ in 0..2 {
        for i in 0..n {
            let scale = 1.0 / power_of_two((0..n).map(|j| matrix[i][j].abs()).fold(0.0, f64::max));
            (0..n).for_each(|j| matrix[i][j] *= scale);
            rhs[i] *= scale;
        }
        for j in 0..n {
            let scale = 1.0 / power_of_two((0..n).map(|i| matrix[i][j].abs()).fold(0.0, f64::max));
            (0..n).for_each(|i| matrix[i][j] *= scale);
            column_scale[j] *= scale;
        }
    }
    column_scale
}

/// Row, column and size of the first of the largest entries from this row and column on.
fn largest_entry<A: Array<R>, R: Array<f64>>(matrix: &A, from: usize) -> (usize, usize, f64) {
    let (mut row, mut size) = (from, 0.0);
    for i in from..matrix.len() {
        let largest = largest_size(&matrix[i].as_ref()[from..]);
        if largest > size {
            (row, size) = (i, largest);
        }
    }
    let column = (from..matrix.len()).find(|j| matrix[row][*j].abs() == size).unwrap_or(from);
    (row, column, size)
}

/// The largest magnitude, found in lanes.
fn largest_size(values: &[f64]) -> f64 {
    const LANES: usize = 8;
    let larger = |a: f64, b: f64| if b > a { b } else { a };
    let (chunks, rest) = values.as_chunks::<LANES>();
    let mut lanes = [0.0; LANES];
    for chunk in chunks {
        for (lane, value) in lanes.iter_mut().zip(chunk) {
            *lane = larger(*lane, value.abs());
        }
    }
    let among_rest = rest.iter().fold(0.0, |size, value| larger(size, value.abs()));
    lanes.into_iter().fold(among_rest, larger)
}

/// The matrix is not finite in this row.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Undefined {
    /// The row.
    pub(crate) row: usize,
}

/// L D L' factors of a symmetric matrix that is positive definite, or semidefinite because rows depend on each other.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Definite<A, R, S = f64> {
    /// L, below the diagonal.
    lower: A,
    /// 1/D; zero for rows that depend on those before.
    inverse_pivots: R,
    numbers: PhantomData<S>,
}

impl<S: Scalar, A: Array<R>, R: Array<S>> Definite<A, R, S> {
    /// Factorises a matrix of which the lower triangle is given.
    ///
    /// # Errors
    /// As [`factorise`](Definite::factorise).
    #[inline]
    pub(crate) fn new(lower: A) -> Result<Definite<A, R, S>, Undefined> {
        let n = lower.len();
        let mut factors = Definite { lower, inverse_pivots: R::repeat(n, S::ZERO), numbers: PhantomData };
        factors.eliminate()?;
        Ok(factors)
    }

    /// Factorises the matrix of these entries below the diagonal and on it, in place of factors of the same size.
    ///
    /// A row whose pivot has lost all but a few digits to cancellation depends on those before.
    ///
    /// # Errors
    /// If a pivot is not finite; the factors are then not valid.
    #[inline(always)]
    pub(crate) fn factorise(&mut self, entry: impl Fn(usize, usize) -> S) -> Result<(), Undefined> {
        for i in 0..self.lower.len() {
            for j in 0..=i {
                self.lower[i][j] = entry(i, j);
            }
        }
        self.eliminate()
    }

    #[inline(always)]
    fn eliminate(&mut self) -> Result<(), Undefined> {
        let Definite { lower, inverse_pivots, .. } = self;
        for k in 0..lower.len() {
            let mut pivot = lower[k][k];
            for j in 0..k {
                let known = sum((0..j).map(|i| lower[k][i] * lower[j][i]));
                lower[k][j] = lower[k][j] - known;
            }
            for j in 0..k {
                let scaled = lower[k][j] * inverse_pivots[j];
                pivot = pivot - lower[k][j] * scaled;
                lower[k][j] = scaled;
            }
            inverse_pivots[k] = inverse_pivot(pivot, lower[k][k]).ok_or(Undefined { row: k })?;
        }
        Ok(())
    }

    /// Factors of nothing yet.
    #[inline(always)]
    pub(crate) fn blank(n: usize) -> Definite<A, R, S> {
        let lower = A::repeat(n, R::repeat(n, S::ZERO));
        Definite { lower, inverse_pivots: R::repeat(n, S::ZERO), numbers: PhantomData }
    }

    /// The diagonal entry of a row, and the inverse of its pivot: zero if the row depends on those before it.
    #[inline]
    pub(crate) fn row(&self, k: usize) -> (S, S) {
        (self.lower[k][k], self.inverse_pivots[k])
    }

    /// These where the mask is true, and others elsewhere.
    #[inline]
    pub(crate) fn or(self, mask: S::Mask, others: &Definite<A, R, S>) -> Definite<A, R, S> {
        let select = |yes: &R, no: &R| yes.like(|i| S::select(mask, yes[i], no[i]));
        Definite {
            lower: self.lower.like(|i| select(&self.lower[i], &others.lower[i])),
            inverse_pivots: select(&self.inverse_pivots, &others.inverse_pivots),
            numbers: PhantomData,
        }
    }

    /// The solution for a right-hand side; zero for unknowns whose rows depend on others.
    #[inline]
    pub(crate) fn solve(&self, mut rhs: R) -> R {
        let (n, lower) = (rhs.len(), &self.lower);
        for k in 0..n {
            let known = sum((0..k).map(|j| lower[k][j] * rhs[j]));
            rhs[k] = rhs[k] - known;
        }
        for k in (0..n).rev() {
            let known = sum((k + 1..n).map(|i| lower[i][k] * rhs[i]));
            let solved = rhs[k] * self.inverse_pivots[k] - known;
            rhs[k] = S::select(self.inverse_pivots[k].abs().greater(S::ZERO), solved, S::ZERO);
        }
        rhs
    }
}

/// The inverse of the pivot of a row with this diagonal entry: zero if the row depends on those before it, none if it
/// is not finite.
#[inline(always)]
pub(crate) fn inverse_pivot<S: Scalar>(pivot: S, diagonal: S) -> Option<S> {
    let is_independent = pivot.greater(S::from_f64(LEAST_INDEPENDENCE) * diagonal);
    // As almost always, and in fewer operations.
    if !S::not(is_independent).any() {
        return Some(S::from_f64(1.0) / pivot);
    }
    let is_known = is_independent | finite(pivot);
    (!S::not(is_known).any()).then(|| S::select(is_independent, S::from_f64(1.0) / pivot, S::ZERO))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A Hilbert matrix is definite and ill-conditioned (1.5e4 at size 4); its inverse has integer entries.
    fn hilbert() -> [[f64; 4]; 4] {
        std::array::from_fn(|i| std::array::from_fn(|j| 1.0 / (i + j + 1) as f64))
    }

    #[test]
    fn both_solvers_invert_a_hilbert_matrix() {
        let first_column = [16.0, -120.0, 240.0, -140.0];
        let rhs = [1.0, 0.0, 0.0, 0.0];
        for solution in [solve(hilbert(), rhs).solution, Definite::new(hilbert()).unwrap().solve(rhs)] {
            for (x, expected) in solution.iter().zip(first_column) {
                // Condition 1.5e4 times a few roundings of 1.1e-16, relative to the largest entry.
                assert!((x - expected).abs() < 240.0 * 1.5e4 * 1e-15, "{solution:?}");
            }
        }
    }

    #[test]
    fn zero_diagonals_and_wild_scales_are_no_obstacle() {
        assert_eq!(solve([[0.0, 2.0], [4e-9, 0.0]], [2.0, 8e-9]).solution, [2.0, 1.0]);
    }

    #[test]
    fn dependent_rows_leave_an_unknown_undetermined() {
        let solved = solve([[1.0, 2.0], [2.0, 4.0]], [1.0, 2.0]);
        assert!(solved.is_consistent && solved.undetermined().eq([1]));
        assert_eq!(solved.solution, [1.0, 0.0]);
        assert!(!solve([[1.0, 2.0], [2.0, 4.0]], [1.0, 1.0]).is_consistent);
        assert!(!solve([[f64::NAN, 2.0], [2.0, 4.0]], [1.0, 1.0]).is_consistent);
        let factors = Definite::new([[1.0, 0.0], [2.0, 4.0]]).unwrap();
        assert_eq!(factors.row(1).1, 0.0);
        assert_eq!(factors.solve([1.0, 2.0]), [1.0, 0.0]);
        // Even if the dependent row contradicts the others, its unknown is zero.
        assert_eq!(factors.solve([1.0, 5.0]), [1.0, 0.0]);
        assert!(Definite::new([[1.0, 0.0], [f64::NAN, 4.0]]).is_err());
    }
}
