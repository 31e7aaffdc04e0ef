//! The shortest of all multipliers with the same forces, where constraints depend on each other.

use sim_kernel::Array;

/// The lambda of least norm, sum of lambda_i^2 in SI units, with the same C_q' lambda: its part in the space of the columns
/// of C_q, of dimension `rank`. For rows that are independent that is lambda itself.
///
/// The columns are made orthonormal by modified Gram-Schmidt with pivoting, each taken twice (Golub and Van Loan, Matrix
/// Computations, 2013, section 5.2.8); they are brought to one length first, so that the units of coordinates do not decide.
#[cold]
pub(crate) fn least_norm<A: Array<Q>, Q: Array<f64>, L: Array<f64>>(mut columns: A, multipliers: &L, rank: usize) -> L {
    let (m, n) = (columns.len(), columns.iter().next().map_or(0, Array::len));
    (0..n).for_each(|j| scale(&mut columns, j));
    let (mut rest, mut shortest) = (multipliers.clone(), multipliers.like(|_| 0.0));
    for k in 0..rank.min(n) {
        let length = |j: &usize| inner(&columns, *j, *j);
        let Some(longest) = (k..n).max_by(|a, b| length(a).total_cmp(&length(b))) else { break };
        (0..m).for_each(|i| columns[i].as_mut().swap(k, longest));
        for before in (0..k).chain(0..k) {
            remove(&mut columns, before, k);
        }
        scale(&mut columns, k);
        for later in k + 1..n {
            remove(&mut columns, k, later);
        }
        let share: f64 = (0..m).map(|i| columns[i][k] * rest[i]).sum();
        for i in 0..m {
            shortest[i] += share * columns[i][k];
            rest[i] -= share * columns[i][k];
        }
    }
    shortest
}

fn inner<A: Array<Q>, Q: Array<f64>>(columns: &A, j: usize, k: usize) -> f64 {
    columns.iter().map(|row| row[j] * row[k]).sum()
}

/// Brings a column to length 1, unless it is zero.
fn scale<A: Array<Q>, Q: Array<f64>>(columns: &mut A, j: usize) {
    let length = inner(columns, j, j).sqrt();
    if length > 0.0 {
        columns.as_mut().iter_mut().for_each(|row| row[j] /= length);
    }
}

/// Takes from column k its part along column j, which has length 1.
fn remove<A: Array<Q>, Q: Array<f64>>(columns: &mut A, j: usize, k: usize) {
    let share = inner(columns, j, k);
    columns.as_mut().iter_mut().for_each(|row| row[k] -= share * row[j]);
}
