//! The interface of factors of a symmetric matrix, independent of storage.

use sim_kernel::Array;

/// L D L' factors of a symmetric matrix that is positive definite, or semidefinite because rows depend on each other.
pub(crate) trait Factors<L: Array<f64>> {
    /// Factors of nothing yet.
    fn blank() -> Self;
    /// The diagonal entry of a row, and the inverse of its pivot: zero if the row depends on those before it.
    fn row(&self, row: usize) -> (f64, f64);
    /// The solution for a right-hand side; zero for unknowns whose rows depend on others.
    fn solve(&self, rhs: L) -> L;

    /// Whether no row depends on others.
    #[inline]
    fn is_regular(&self) -> bool {
        (0..L::LEN).all(|row| self.row(row).1 != 0.0)
    }

    /// The rows that depend on those before them.
    fn dependent(&self) -> impl Iterator<Item = usize> {
        (0..L::LEN).filter(|row| self.row(*row).1 == 0.0)
    }
}

/// The matrix is not finite in this row.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Undefined {
    /// The row.
    pub(crate) row: usize,
}
