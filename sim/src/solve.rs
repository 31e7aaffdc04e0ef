//! Small dense linear systems of fixed size, without allocation.

use sim_kernel::Array;

/// The system has no unique solution: these unknowns were left without a pivot.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Deficient {
    /// The first such unknown.
    pub(crate) unknown: usize,
}

/// A pivot this much smaller than the largest is taken for zero. Rows and columns are first brought to
/// comparable size, so that units do not decide.
const SMALLEST_PIVOT: f64 = 1e-13;

/// Solves a square system by elimination with complete pivoting, after scaling rows and columns by powers of 2.
pub(crate) fn solve<A: Array<R>, R: Array<f64>>(mut matrix: A, mut rhs: R) -> Result<R, Deficient> {
    let n = R::LEN;
    let column_scale = equilibrate(&mut matrix, &mut rhs);
    let mut columns = R::from_fn(|i| i as f64);
    let mut first_pivot = 0.0f64;
    for k in 0..n {
        let (row, column, size) = largest_entry(&matrix, k);
        first_pivot = first_pivot.max(size);
        if !(size > SMALLEST_PIVOT * first_pivot) {
            return Err(Deficient { unknown: columns[k] as usize });
        }
        matrix.as_mut().swap(k, row);
        rhs.as_mut().swap(k, row);
        for i in 0..n {
            matrix[i].as_mut().swap(k, column);
        }
        columns.as_mut().swap(k, column);
        for i in k + 1..n {
            let factor = matrix[i][k] / matrix[k][k];
            if factor != 0.0 {
                for j in k + 1..n {
                    matrix[i][j] -= factor * matrix[k][j];
                }
                rhs[i] -= factor * rhs[k];
            }
        }
    }
    let mut solution = R::filled(0.0);
    for k in (0..n).rev() {
        let known: f64 = (k + 1..n).map(|j| matrix[k][j] * rhs[j]).sum();
        rhs[k] = (rhs[k] - known) / matrix[k][k];
        let unknown = columns[k] as usize;
        solution[unknown] = rhs[k] * column_scale[unknown];
    }
    Ok(solution)
}

/// Scales rows and columns to largest entries near 1; gives the scales of the columns.
fn equilibrate<A: Array<R>, R: Array<f64>>(matrix: &mut A, rhs: &mut R) -> R {
    let n = R::LEN;
    let mut column_scale = R::filled(1.0);
    for _ in 0..2 {
        for i in 0..n {
            let scale = power_of_two((0..n).map(|j| matrix[i][j].abs()).fold(0.0, f64::max));
            (0..n).for_each(|j| matrix[i][j] *= scale);
            rhs[i] *= scale;
        }
        for j in 0..n {
            let scale = power_of_two((0..n).map(|i| matrix[i][j].abs()).fold(0.0, f64::max));
            (0..n).for_each(|i| matrix[i][j] *= scale);
            column_scale[j] *= scale;
        }
    }
    column_scale
}

/// About 1 / size, exact to multiply with.
fn power_of_two(size: f64) -> f64 {
    if size > 0.0 && size.is_finite() { (-size.log2().round()).clamp(-1000.0, 1000.0).exp2() } else { 1.0 }
}

fn largest_entry<A: Array<R>, R: Array<f64>>(matrix: &A, from: usize) -> (usize, usize, f64) {
    let mut found = (from, from, 0.0);
    for i in from..R::LEN {
        for j in from..R::LEN {
            let size = matrix[i][j].abs();
            if size > found.2 {
                found = (i, j, size);
            }
        }
    }
    found
}

/// Solves a symmetric positive definite system, of which the lower triangle is given, by L D L' factorisation.
///
/// The unknown is refused at whose pivot cancellation has taken all but a few digits: it depends on those before.
#[inline]
pub(crate) fn solve_definite<A: Array<R>, R: Array<f64>>(mut matrix: A, mut rhs: R) -> Result<R, Deficient> {
    let n = R::LEN;
    let mut inverse_pivots = R::filled(0.0);
    for k in 0..n {
        let mut pivot = matrix[k][k];
        for j in 0..k {
            let known: f64 = (0..j).map(|i| matrix[k][i] * matrix[j][i]).sum();
            matrix[k][j] -= known;
        }
        for j in 0..k {
            let scaled = matrix[k][j] * inverse_pivots[j];
            pivot -= matrix[k][j] * scaled;
            rhs[k] -= scaled * rhs[j];
            matrix[k][j] = scaled;
        }
        if !(pivot > SMALLEST_PIVOT * matrix[k][k]) {
            return Err(Deficient { unknown: k });
        }
        inverse_pivots[k] = 1.0 / pivot;
    }
    for k in (0..n).rev() {
        let known: f64 = (k + 1..n).map(|i| matrix[i][k] * rhs[i]).sum();
        rhs[k] = rhs[k] * inverse_pivots[k] - known;
    }
    Ok(rhs)
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
        for solution in [solve(hilbert(), [1.0, 0.0, 0.0, 0.0]), solve_definite(hilbert(), [1.0, 0.0, 0.0, 0.0])] {
            let solution = solution.unwrap();
            for (x, expected) in solution.iter().zip(first_column) {
                // Condition 1.5e4 times a few roundings of 1.1e-16, relative to the largest entry.
                assert!((x - expected).abs() < 240.0 * 1.5e4 * 1e-15, "{solution:?}");
            }
        }
    }

    #[test]
    fn zero_diagonals_and_wild_scales_are_no_obstacle() {
        let solution = solve([[0.0, 2.0], [4e-9, 0.0]], [2.0, 8e-9]).unwrap();
        assert_eq!(solution, [2.0, 1.0]);
    }

    #[test]
    fn dependent_rows_are_refused() {
        assert!(solve([[1.0, 2.0], [2.0, 4.0]], [1.0, 1.0]).is_err());
        assert_eq!(solve_definite([[1.0, 2.0], [2.0, 4.0]], [1.0, 1.0]), Err(Deficient { unknown: 1 }));
        assert!(solve([[f64::NAN, 2.0], [2.0, 4.0]], [1.0, 1.0]).is_err());
    }
}
