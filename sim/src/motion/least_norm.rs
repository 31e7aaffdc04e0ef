//! The shortest of all multipliers with the same forces, where constraints depend on each other.

use sim_kernel::{Array, Mechanism};

/// The lambda of least norm, sum of lambda_i^2 in SI units, with the same C_q' lambda: its part in the space of the columns
/// of C_q, of dimension `rank`. For rows that are independent that is lambda itself.
///
/// The columns are made orthonormal by modified Gram-Schmidt with pivoting, each taken twice (Golub and Van Loan, Matrix
/// Computations, 2013, section 5.2.8); they are brought to one length first, so that the units of coordinates do not decide.
#[cold]
pub(crate) fn least_norm<M: Mechanism>(mut columns: M::LQ, multipliers: &M::L, rank: usize) -> M::L {
    (0..M::Q::LEN).for_each(|j| scale::<M>(&mut columns, j));
    let (mut rest, mut shortest) = (*multipliers, M::L::filled(0.0));
    for k in 0..rank.min(M::Q::LEN) {
        let length = |j: &usize| inner::<M>(&columns, *j, *j);
        let Some(longest) = (k..M::Q::LEN).max_by(|a, b| length(a).total_cmp(&length(b))) else { break };
        (0..M::L::LEN).for_each(|i| columns[i].as_mut().swap(k, longest));
        for before in (0..k).chain(0..k) {
            remove::<M>(&mut columns, before, k);
        }
        scale::<M>(&mut columns, k);
        for later in k + 1..M::Q::LEN {
            remove::<M>(&mut columns, k, later);
        }
        let share: f64 = (0..M::L::LEN).map(|i| columns[i][k] * rest[i]).sum();
        for i in 0..M::L::LEN {
            shortest[i] += share * columns[i][k];
            rest[i] -= share * columns[i][k];
        }
    }
    shortest
}

fn inner<M: Mechanism>(columns: &M::LQ, j: usize, k: usize) -> f64 {
    columns.iter().map(|row| row[j] * row[k]).sum()
}

/// Brings a column to length 1, unless it is zero.
fn scale<M: Mechanism>(columns: &mut M::LQ, j: usize) {
    let length = inner::<M>(columns, j, j).sqrt();
    if length > 0.0 {
        (0..M::L::LEN).for_each(|i| columns[i][j] /= length);
    }
}

/// Takes from column k its part along column j, which has length 1.
fn remove<M: Mechanism>(columns: &mut M::LQ, j: usize, k: usize) {
    let share = inner::<M>(columns, j, k);
    (0..M::L::LEN).for_each(|i| columns[i][k] -= share * columns[i][j]);
}
