//! Redundant constraints, reduced to the rank of C_q.
//!
//! On the constraints the redundant rows of C_q depend on the others; off them, where stages of a step lie, they nearly
//! do, and a solution that satisfied them all would have a pole. Rows are therefore combined by the left singular
//! vectors of the largest singular values: the solution then satisfies all rows in least squares, and depends smoothly
//! on the state.
//!
//! Taking each row as it is would make a pivot of rounding. Leaving out fixed rows would fail at positions where other
//! rows carry the rank. Only mechanisms with redundant rows pay for the reduction.

use crate::motion::measures::Measures;
use sim_kernel::{Array, Mechanism};

/// K: each of its rows combines the declared constraints to one reduced constraint; the last rows are zero.
#[derive(Clone, Debug)]
pub(crate) struct Reduction<M: Mechanism> {
    combinations: M::LL,
}

impl<M: Mechanism> Reduction<M> {
    /// The reduction of C_q to this many rows.
    ///
    /// Rows are orthonormalised with pivoting, which finds the row space up to the deviation of C_q from its rank; one
    /// step of orthogonal iteration (Golub and Van Loan, Matrix Computations, 2013, section 8.2.4) leaves the square of
    /// that.
    pub(crate) fn new(mechanism: &M, jacobian: &M::LQ, measures: &Measures<M>, rank: usize) -> Reduction<M> {
        let m = jacobian.len();
        let mut scaled = measures.columns(mechanism, jacobian);
        let inverse_lengths = measures.constraints().like(|i| inverse(measures.constraints()[i]));
        for i in 0..m {
            scaled[i].as_mut().iter_mut().for_each(|entry| *entry *= inverse_lengths[i]);
        }
        let space = row_space(scaled.clone(), rank);
        // U: an orthonormal basis of the columns of A Q', by rows.
        let mut combinations = M::LL::repeat(m, M::L::repeat(m, 0.0));
        for k in 0..rank.min(m) {
            combinations[k] = M::L::with_len(m, |i| inner(&scaled[i], &space[k]));
            orthonormalise(combinations.as_mut(), k, 2);
        }
        for row in combinations.as_mut() {
            row.as_mut().iter_mut().zip(inverse_lengths.iter()).for_each(|(entry, inverse)| *entry *= inverse);
        }
        Reduction { combinations }
    }

    /// K A, for rows A of the constraints.
    pub(crate) fn rows(&self, jacobian: &M::LQ) -> M::LQ {
        jacobian.like(|k| {
            let combination = &self.combinations[k];
            jacobian[k].like(|j| (0..jacobian.len()).map(|i| combination[i] * jacobian[i][j]).sum())
        })
    }

    /// K r, for a number r of each constraint.
    pub(crate) fn values(&self, values: &M::L) -> M::L {
        values.like(|k| inner(&self.combinations[k], values))
    }

    /// The constraint with the largest part in a row of K.
    pub(crate) fn leading(&self, row: usize) -> usize {
        let part = |i: &usize| self.combinations[row][*i].abs();
        (0..self.combinations.len()).max_by(|a, b| part(a).total_cmp(&part(b))).unwrap_or(row)
    }

    /// Multipliers of the constraints as declared, from those mu of the reduced ones: the shortest, sum of lambda_i^2 in SI
    /// units, with the forces of K' mu, which is its part in the space of the columns of C_q.
    pub(crate) fn multipliers(&self, measures: &Measures<M>, reduced: &M::L) -> M::L {
        let sizes = measures.constraints();
        let scaled = |k: usize| sizes.like(|i| self.combinations[k][i] * sizes[i] * sizes[i]);
        let mut columns = self.combinations.like(scaled);
        let any = sizes.like(|i| (0..reduced.len()).map(|k| self.combinations[k][i] * reduced[k]).sum());
        let mut shortest = reduced.like(|_| 0.0);
        for k in 0..reduced.len() {
            orthonormalise(columns.as_mut(), k, 2);
            let share = inner(&columns[k], &any);
            shortest.as_mut().iter_mut().zip(columns[k].iter()).for_each(|(part, along)| *part += share * along);
        }
        shortest
    }
}

fn inverse(length: f64) -> f64 {
    if length > 0.0 { 1.0 / length } else { 0.0 }
}

/// An orthonormal basis of the space of the rows, of this dimension: the row with the largest rest first.
pub(crate) fn row_space<A: Array<R>, R: Array<f64>>(mut rows: A, rank: usize) -> A {
    for k in 0..rank.min(rows.len()) {
        let length = |i: &usize| inner(&rows[*i], &rows[*i]);
        let Some(longest) = (k..rows.len()).max_by(|a, b| length(a).total_cmp(&length(b))) else { break };
        rows.as_mut().swap(k, longest);
        // They have been subtracted once, below.
        orthonormalise(rows.as_mut(), k, 1);
        let direction = rows[k].clone();
        for i in k + 1..rows.len() {
            remove(&mut rows[i], &direction);
        }
    }
    rows
}

/// Takes from row k its parts along those before it, this many times, and normalises it. Two times remove them to
/// rounding.
fn orthonormalise<A: Array<f64>>(rows: &mut [A], k: usize, times: usize) {
    let (before, row) = rows.split_at_mut(k);
    let Some(row) = row.first_mut() else { return };
    for _ in 0..times {
        before.iter().for_each(|direction| remove(row, direction));
    }
    let factor = inverse(inner(row, row).sqrt());
    row.as_mut().iter_mut().for_each(|entry| *entry *= factor);
}

/// The inner product, summed in lanes: most of the time of a mechanism with redundant constraints is spent here.
#[inline]
fn inner<A: Array<f64>>(a: &A, b: &A) -> f64 {
    const LANES: usize = 8;
    let ((a, rest_of_a), (b, rest_of_b)) = (a.as_ref().as_chunks::<LANES>(), b.as_ref().as_chunks::<LANES>());
    let mut lanes = [0.0; LANES];
    for (a, b) in a.iter().zip(b) {
        for ((lane, a), b) in lanes.iter_mut().zip(a).zip(b) {
            *lane += a * b;
        }
    }
    let rest: f64 = rest_of_a.iter().zip(rest_of_b).map(|(a, b)| a * b).sum();
    lanes.into_iter().sum::<f64>() + rest
}

/// Takes from a row its part along a direction of length 1.
fn remove<A: Array<f64>>(row: &mut A, direction: &A) {
    let share = inner(row, direction);
    row.as_mut().iter_mut().zip(direction.iter()).for_each(|(entry, along)| *entry -= share * along);
}
