//! Where the rows of a kernel's result are entered.

use sim_kernel::{Array, Scalar};
use std::any::Any;

/// A result that is entered row by row.
pub(super) trait Entered<S> {
    /// The place of a row, which has so many numbers; empty where the result has no such row.
    fn row(&mut self, row: usize, len: usize) -> &mut [S];
}

/// Enters the numbers of a row, which are of the kind of its place.
#[inline]
pub(super) fn enter<A: Scalar, S: Scalar>(found: &mut impl Entered<S>, row: usize, numbers: &[A]) {
    let place = found.row(row, numbers.len());
    debug_assert_eq!(numbers.len(), place.len(), "a row of another length");
    for (entry, number) in place.iter_mut().zip(numbers) {
        if let Some(number) = (number as &dyn Any).downcast_ref() {
            *entry = *number;
        }
    }
}

/// Vectors, each of which is a row, and then the rows of matrices.
pub(super) struct Rows<'r, S, R, const VECTORS: usize, const MATRICES: usize> {
    pub(super) vectors: [&'r mut [S]; VECTORS],
    pub(super) matrices: [&'r mut [R]; MATRICES],
}

/// Vectors alone.
#[inline]
pub(super) fn vectors<S, const VECTORS: usize>(vectors: [&mut [S]; VECTORS]) -> Rows<'_, S, [S; 0], VECTORS, 0> {
    Rows { vectors, matrices: [] }
}

/// Matrices alone.
#[inline]
pub(super) fn matrices<S: Scalar, R: Array<S>, const MATRICES: usize>(
    matrices: [&mut [R]; MATRICES],
) -> Rows<'_, S, R, 0, MATRICES> {
    Rows { vectors: [], matrices }
}

impl<S, R: AsMut<[S]>, const VECTORS: usize, const MATRICES: usize> Entered<S> for Rows<'_, S, R, VECTORS, MATRICES> {
    #[inline]
    fn row(&mut self, row: usize, _: usize) -> &mut [S] {
        if row < VECTORS {
            return self.vectors[row];
        }
        let mut row = row - VECTORS;
        for matrix in &mut self.matrices {
            if row < matrix.len() {
                return matrix[row].as_mut();
            }
            row -= matrix.len();
        }
        &mut []
    }
}

/// Rows whose number and lengths the kernel alone knows.
impl<S: Scalar> Entered<S> for Vec<Vec<S>> {
    fn row(&mut self, row: usize, len: usize) -> &mut [S] {
        self.resize(self.len().max(row + 1), Vec::new());
        self[row] = vec![S::ZERO; len];
        &mut self[row]
    }
}
