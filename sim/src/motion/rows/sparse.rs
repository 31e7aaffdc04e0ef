//! Rows by their entries that may be nonzero, and factors within the envelope.
//!
//! Rows are taken in the order of elimination.

use super::{Linear, Rows};
use crate::model::level::is_speed_row;
use crate::motion::measures::{Measures, mixes_lengths};
use crate::numerics::solve::{LEAST_INDEPENDENCE, Undefined};
use sim_kernel::{Array, Mechanism, SparseRow};

/// Rows by their entries that may be nonzero.
pub(crate) struct Sparse;

/// Whether the rows of a mechanism are stored this way.
#[inline(always)]
pub(crate) fn is_sparse<M: Mechanism>(mechanism: &M) -> bool {
    !mechanism.description().sparsity.is_empty()
}

/// The rows of a mechanism in the order of elimination.
#[inline(always)]
pub(crate) fn sparse_rows<M: Mechanism>(mechanism: &M) -> &'static [SparseRow] {
    mechanism.description().sparsity
}

impl<M: Mechanism> Rows<M> for Sparse {
    type Jacobian = M::Entries;
    type Factors = Envelope<M>;

    #[inline]
    fn linearization(mechanism: &M, time: f64, q: &M::Q) -> Linear<M, Sparse> {
        mechanism.sparse_linearization(time, q)
    }

    #[inline]
    fn columns(mechanism: &M, entries: &M::Entries, measures: &Measures<M>) -> M::Entries {
        let mut columns = entries.clone();
        if !mixes_lengths(mechanism) {
            return columns;
        }
        for row in sparse_rows(mechanism) {
            for (entry, j) in entries_of_mut(&mut columns, row) {
                *entry *= measures.coordinates()[j];
            }
        }
        columns
    }

    #[inline]
    fn between_positions(mechanism: &M, entries: &M::Entries) -> M::Entries {
        let mut between = entries.clone();
        for row in sparse_rows(mechanism).iter().filter(|row| is_speed_row(mechanism, row.constraint)) {
            entries_of_mut(&mut between, row).for_each(|(entry, _)| *entry = 0.0);
        }
        between
    }

    #[inline]
    fn times(mechanism: &M, entries: &M::Entries, x: &M::Q) -> M::L {
        let mut products = M::L::repeat(mechanism.m(), 0.0);
        for row in sparse_rows(mechanism) {
            products[row.constraint] = inner(entries, row, x);
        }
        products
    }

    #[cold]
    fn terms(mechanism: &M, entries: &M::Entries, constraint: usize, x: &M::Q) -> f64 {
        let row = sparse_rows(mechanism).iter().find(|row| row.constraint == constraint);
        row.map_or(0.0, |row| entries_of(entries, row).map(|(entry, j)| (entry * x[j]).abs()).sum())
    }

    #[inline]
    fn transposed_times(mechanism: &M, entries: &M::Entries, y: &M::L) -> M::Q {
        let mut sums = M::Q::repeat(mechanism.n(), 0.0);
        for row in sparse_rows(mechanism) {
            let factor = y[row.constraint];
            entries_of(entries, row).for_each(|(entry, j)| sums[j] += factor * entry);
        }
        sums
    }

    #[inline]
    fn factorise(mechanism: &M, entries: &M::Entries, factors: &mut Envelope<M>) -> Result<(), Undefined> {
        products(mechanism, entries, entries, &mut factors.lower);
        factors.factorise(mechanism)
    }

    fn no_factors(mechanism: &M) -> Envelope<M> {
        Envelope { lower: blank_envelope(mechanism), inverse_pivots: M::L::repeat(mechanism.m(), 0.0) }
    }

    #[inline]
    fn pivot(mechanism: &M, factors: &Envelope<M>, k: usize) -> (f64, f64) {
        (factors.lower[sparse_rows(mechanism)[k].diagonal], factors.inverse_pivots[k])
    }

    #[inline]
    fn solve(mechanism: &M, factors: &Envelope<M>, rhs: M::L) -> M::L {
        factors.solve(mechanism, rhs)
    }

    #[inline]
    fn constraint(mechanism: &M, k: usize) -> usize {
        sparse_rows(mechanism)[k].constraint
    }
}

/// The entries of a row with their columns.
#[inline(always)]
fn entries_of<'a, E: Array<f64>>(entries: &'a E, row: &'static SparseRow) -> impl Iterator<Item = (f64, usize)> + 'a {
    let own = &entries.as_ref()[row.entries..row.entries + row.columns.len()];
    own.iter().copied().zip(row.columns.iter().copied())
}

#[inline(always)]
fn entries_of_mut<'a, E: Array<f64>>(
    entries: &'a mut E,
    row: &'static SparseRow,
) -> impl Iterator<Item = (&'a mut f64, usize)> {
    let own = &mut entries.as_mut()[row.entries..row.entries + row.columns.len()];
    own.iter_mut().zip(row.columns.iter().copied())
}

/// A row times a vector.
#[inline(always)]
fn inner<E: Array<f64>, Q: Array<f64>>(entries: &E, row: &'static SparseRow, x: &Q) -> f64 {
    entries_of(entries, row).map(|(entry, j)| entry * x[j]).sum()
}

/// The lower triangle of A B' within the envelope.
#[inline]
pub(super) fn products<M: Mechanism>(mechanism: &M, a: &M::Entries, b: &M::Entries, products: &mut M::Envelope) {
    let rows = sparse_rows(mechanism);
    // The row of A that rows of B are multiplied with, by all of its entries; 0 elsewhere.
    let mut spread = M::Q::repeat(mechanism.n(), 0.0);
    for (k, row) in rows.iter().enumerate() {
        entries_of(a, row).for_each(|(entry, j)| spread[j] = entry);
        let own = &mut products.as_mut()[row.diagonal + row.first - k..=row.diagonal];
        for (other, product) in rows[row.first..=k].iter().zip(own) {
            *product = inner(b, other, &spread);
        }
        row.columns.iter().for_each(|j| spread[*j] = 0.0);
    }
}

/// An envelope of zeros.
pub(super) fn blank_envelope<M: Mechanism>(mechanism: &M) -> M::Envelope {
    let last = sparse_rows(mechanism).last();
    M::Envelope::repeat(last.map_or(0, |row| row.diagonal + 1), 0.0)
}

/// The inner product.
#[inline(always)]
pub(super) fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// L D L' factors within the envelope.
#[derive(Clone, Debug)]
pub(crate) struct Envelope<M: Mechanism> {
    /// L, below the diagonal; the diagonal is that of the matrix.
    lower: M::Envelope,
    /// 1/D; zero for rows that depend on those before.
    inverse_pivots: M::L,
}

impl<M: Mechanism> Envelope<M> {
    /// As [`Definite`](crate::numerics::solve::Definite) does.
    #[inline]
    fn factorise(&mut self, mechanism: &M) -> Result<(), Undefined> {
        let rows = sparse_rows(mechanism);
        for (k, row) in rows.iter().enumerate() {
            let (before, own) = self.lower.as_mut().split_at_mut(row.diagonal + row.first - k);
            for j in row.first..k {
                let other = &rows[j];
                let first = row.first.max(other.first);
                let theirs = &before[other.diagonal + first - j..other.diagonal];
                let known = dot(&own[first - row.first..j - row.first], theirs);
                own[j - row.first] -= known;
            }
            let square = own[k - row.first];
            let mut pivot = square;
            for (entry, inverse) in own.iter_mut().zip(&self.inverse_pivots.as_ref()[row.first..k]) {
                let scaled = *entry * inverse;
                pivot -= *entry * scaled;
                *entry = scaled;
            }
            self.inverse_pivots[k] = 0.0;
            if pivot > LEAST_INDEPENDENCE * square {
                self.inverse_pivots[k] = 1.0 / pivot;
            } else if !pivot.is_finite() {
                return Err(Undefined { row: row.constraint });
            }
        }
        Ok(())
    }

    /// The entries of L in a row.
    #[inline(always)]
    fn row_of_l(&self, k: usize, row: &SparseRow) -> &[f64] {
        &self.lower.as_ref()[row.diagonal + row.first - k..row.diagonal]
    }

    #[inline]
    fn solve(&self, mechanism: &M, rhs: M::L) -> M::L {
        let rows = sparse_rows(mechanism);
        let mut x = rhs.like(|k| rhs[rows[k].constraint]);
        for (k, row) in rows.iter().enumerate() {
            let known = dot(self.row_of_l(k, row), &x.as_ref()[row.first..k]);
            x[k] -= known;
        }
        (0..mechanism.m()).for_each(|k| x[k] *= self.inverse_pivots[k]);
        for (k, row) in rows.iter().enumerate().rev() {
            let value = if self.inverse_pivots[k] != 0.0 { x[k] } else { 0.0 };
            x[k] = value;
            let before = x.as_mut()[row.first..k].iter_mut();
            before.zip(self.row_of_l(k, row)).for_each(|(x, entry)| *x -= entry * value);
        }
        let mut solution = x;
        rows.iter().zip(x.iter()).for_each(|(row, x)| solution[row.constraint] = *x);
        solution
    }
}
