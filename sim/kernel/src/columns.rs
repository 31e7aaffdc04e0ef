//! A factorised system L D L' X = B with many right-hand sides.

use crate::Scalar;
use core::array::from_fn;

/// How many columns are solved at a time, in vector registers.
const BLOCK: usize = 8;

/// The elimination of one unknown.
pub struct ColumnsStep {
    /// Its row.
    pub unknown: usize,
    /// The rows that are eliminated later and have an entry of L in its column.
    pub rows: &'static [usize],
    /// The blocks of eight columns in which its row may be other than zero before the way back, a bit each; in those beyond the
    /// last bit it may.
    pub blocks: u64,
}

impl ColumnsStep {
    fn meets(&self, block: usize) -> bool {
        block >= u64::BITS as usize || self.blocks >> block & 1 == 1
    }
}

/// Solves for right-hand sides in the columns of an N x C matrix, given the reciprocals of D and the entries of L by steps, K of
/// them; C is a multiple of eight, and columns beyond that stay as they are. Generated kernels call it.
pub fn solve_columns<S: Scalar, const N: usize, const K: usize, const C: usize>(
    steps: &[ColumnsStep; N],
    inverses: &[S; N],
    entries: &[S; K],
    columns: &mut [[S; C]; N],
) {
    for block in 0..C / BLOCK {
        let first = block * BLOCK;
        let mut rows: [[S; BLOCK]; N] = from_fn(|i| from_fn(|j| columns[i][first + j]));
        let mut at = 0;
        for step in steps {
            let column = step.rows.iter().zip(&entries[at..at + step.rows.len()]);
            at += step.rows.len();
            if step.meets(block) {
                let own = rows[step.unknown];
                for (row, entry) in column {
                    rows[*row] = less_multiple(rows[*row], *entry, &own);
                }
            }
        }
        for (step, inverse) in steps.iter().zip(inverses).rev() {
            at -= step.rows.len();
            let mut own = rows[step.unknown].map(|x| x * *inverse);
            for (row, entry) in step.rows.iter().zip(&entries[at..at + step.rows.len()]) {
                own = less_multiple(own, *entry, &rows[*row]);
            }
            rows[step.unknown] = own;
        }
        for (whole, part) in columns.iter_mut().zip(&rows) {
            whole[first..first + BLOCK].copy_from_slice(part);
        }
    }
}

#[inline(always)]
fn less_multiple<S: Scalar>(from: [S; BLOCK], factor: S, of: &[S; BLOCK]) -> [S; BLOCK] {
    from_fn(|j| from[j] - factor * of[j])
}

#[cfg(test)]
mod tests {
    use super::*;

    /// L D L' = [4 2 0; 2 5 3; 0 3 6] by hand, for nine right-hand sides: seven that are zero in the first row.
    #[test]
    fn columns_solve_their_equations() {
        let matrix = [[4.0, 2.0, 0.0], [2.0, 5.0, 3.0], [0.0, 3.0, 6.0]];
        let (first, second) = (0.5, 0.75);
        let steps = [
            ColumnsStep { unknown: 0, rows: &[1], blocks: 0b10 },
            ColumnsStep { unknown: 1, rows: &[2], blocks: u64::MAX },
            ColumnsStep { unknown: 2, rows: &[], blocks: u64::MAX },
        ];
        let sides: [[f64; 16]; 3] =
            from_fn(|i| from_fn(|j| if i == 0 && j < 8 { 0.0 } else { (3 * i + 2 * j) as f64 - 7.0 }));
        let mut columns = sides;
        solve_columns(&steps, &[0.25, 0.25, 1.0 / 3.75], &[first, second], &mut columns);
        for (i, row) in matrix.iter().enumerate() {
            for j in 0..16 {
                let sum: f64 = (0..3).map(|k| row[k] * columns[k][j]).sum();
                assert!((sum - sides[i][j]).abs() < 1e-13, "{i} {j}: {sum} is not {}", sides[i][j]);
            }
        }
    }
}
