//! Rows by their entries that may be nonzero, and factors within the envelope.
//!
//! Rows are taken in the order of elimination.

use super::common::{Common, Left, Total, common_column};
use super::{Linear, Rows, select_each};
use crate::model::level::is_speed_row;
use crate::motion::measures::{Measures, mixes_lengths};
use crate::numerics::numbers::sum;
use crate::numerics::solve::{Undefined, inverse_pivot};
use sim_kernel::{Array, Mechanism, Scalar, SparseRow};

/// Rows by their entries that may be nonzero.
pub(crate) struct Sparse;

/// Whether the rows of a mechanism are stored this way.
#[inline(always)]
pub(crate) fn is_sparse<S: Scalar, M: Mechanism<S>>(mechanism: &M) -> bool {
    !mechanism.description().sparsity.is_empty()
}

/// The rows of a mechanism in the order of elimination.
#[inline(always)]
pub(crate) fn sparse_rows<S: Scalar, M: Mechanism<S>>(mechanism: &M) -> &'static [SparseRow] {
    mechanism.description().sparsity
}

/// The first row, in the order of elimination, with which a row has a column in common, that of all parts included.
pub(crate) fn first_met<S: Scalar, M: Mechanism<S>>(mechanism: &M, row: &SparseRow) -> usize {
    if common_column(mechanism).is_some() { 0 } else { row.first }
}

impl<S: Scalar, M: Mechanism<S>> Rows<S, M> for Sparse {
    type Jacobian = M::Entries;
    type Factors = Envelope<M, S>;

    #[inline]
    fn linearization(mechanism: &M, time: S, q: &M::Q) -> Linear<S, M, Sparse> {
        mechanism.sparse_linearization(time, q)
    }

    #[inline]
    fn columns(mechanism: &M, entries: &M::Entries, measures: &Measures<M, S>) -> M::Entries {
        let mut columns = entries.clone();
        if !mixes_lengths(mechanism) {
            return columns;
        }
        for row in sparse_rows(mechanism) {
            for (entry, j) in entries_of_mut(&mut columns, row) {
                *entry = *entry * measures.coordinates()[j];
            }
        }
        columns
    }

    #[inline]
    fn between_positions(mechanism: &M, entries: &M::Entries) -> M::Entries {
        let mut between = entries.clone();
        for row in sparse_rows(mechanism).iter().filter(|row| is_speed_row(mechanism, row.constraint)) {
            entries_of_mut(&mut between, row).for_each(|(entry, _)| *entry = S::ZERO);
        }
        between
    }

    #[inline]
    fn times(mechanism: &M, entries: &M::Entries, x: &M::Q) -> M::L {
        let mut products = M::L::repeat(mechanism.m(), S::ZERO);
        for row in sparse_rows(mechanism) {
            products[row.constraint] = inner(entries, row, x);
        }
        products
    }

    #[cold]
    fn terms(mechanism: &M, entries: &M::Entries, constraint: usize, x: &M::Q) -> S {
        let row = sparse_rows(mechanism).iter().find(|row| row.constraint == constraint);
        row.map_or(S::ZERO, |row| sum(entries_of(entries, row).map(|(entry, j)| (entry * x[j]).abs())))
    }

    #[inline]
    fn transposed_times(mechanism: &M, entries: &M::Entries, y: &M::L) -> M::Q {
        let mut sums = M::Q::repeat(mechanism.n(), S::ZERO);
        for row in sparse_rows(mechanism) {
            let factor = y[row.constraint];
            entries_of(entries, row).for_each(|(entry, j)| sums[j] = sums[j] + factor * entry);
        }
        sums
    }

    #[inline]
    fn factorise(mechanism: &M, entries: &M::Entries, factors: &mut Envelope<M, S>) -> Result<(), Undefined> {
        products(mechanism, entries, entries, &mut factors.lower);
        if let Some(column) = common_column(mechanism) {
            common_entries(mechanism, entries, column, &mut factors.common.entries);
        }
        factors.factorise(mechanism)
    }

    fn no_factors(mechanism: &M) -> Envelope<M, S> {
        let none = M::L::repeat(mechanism.m(), S::ZERO);
        Envelope {
            lower: blank_envelope(mechanism),
            inverse_pivots: none.clone(),
            common: Common { entries: none.clone(), shares: none },
        }
    }

    #[inline]
    fn pivot(mechanism: &M, factors: &Envelope<M, S>, k: usize) -> (S, S) {
        (factors.lower[sparse_rows(mechanism)[k].diagonal], factors.inverse_pivots[k])
    }

    #[inline]
    fn solve(mechanism: &M, factors: &Envelope<M, S>, rhs: M::L) -> M::L {
        factors.solve(mechanism, rhs)
    }

    #[inline]
    fn constraint(mechanism: &M, k: usize) -> usize {
        sparse_rows(mechanism)[k].constraint
    }

    #[inline]
    fn select(mask: S::Mask, yes: M::Entries, no: &M::Entries) -> M::Entries {
        select_each(mask, &yes, no)
    }

    #[inline]
    fn select_factors(mask: S::Mask, yes: Envelope<M, S>, no: &Envelope<M, S>) -> Envelope<M, S> {
        Envelope {
            lower: select_each(mask, &yes.lower, &no.lower),
            inverse_pivots: select_each(mask, &yes.inverse_pivots, &no.inverse_pivots),
            common: Common {
                entries: select_each(mask, &yes.common.entries, &no.common.entries),
                shares: select_each(mask, &yes.common.shares, &no.common.shares),
            },
        }
    }
}

/// The entries of a row with their columns.
#[inline(always)]
fn entries_of<'a, S: Scalar, E: Array<S>>(
    entries: &'a E,
    row: &'static SparseRow,
) -> impl Iterator<Item = (S, usize)> + 'a {
    let own = &entries.as_ref()[row.entries..row.entries + row.columns.len()];
    own.iter().copied().zip(row.columns.iter().copied())
}

#[inline(always)]
fn entries_of_mut<'a, S: Scalar, E: Array<S>>(
    entries: &'a mut E,
    row: &'static SparseRow,
) -> impl Iterator<Item = (&'a mut S, usize)> {
    let own = &mut entries.as_mut()[row.entries..row.entries + row.columns.len()];
    own.iter_mut().zip(row.columns.iter().copied())
}

/// A row times a vector.
#[inline(always)]
fn inner<S: Scalar, E: Array<S>, Q: Array<S>>(entries: &E, row: &'static SparseRow, x: &Q) -> S {
    sum(entries_of(entries, row).map(|(entry, j)| entry * x[j]))
}

/// The entries of a column, in the order of elimination.
#[inline]
pub(super) fn common_entries<S: Scalar, M: Mechanism<S>>(
    mechanism: &M,
    entries: &M::Entries,
    column: usize,
    common: &mut M::L,
) {
    for (k, row) in sparse_rows(mechanism).iter().enumerate() {
        let own = entries_of(entries, row).find(|(_, j)| *j == column);
        common[k] = own.map_or(S::ZERO, |(entry, _)| entry);
    }
}

/// The lower triangle of A B' within the envelope, without what a common column adds.
#[inline]
pub(super) fn products<S: Scalar, M: Mechanism<S>>(
    mechanism: &M,
    a: &M::Entries,
    b: &M::Entries,
    products: &mut M::Envelope,
) {
    let rows = sparse_rows(mechanism);
    // The row of A that rows of B are multiplied with, by all of its entries; 0 elsewhere.
    let mut spread = M::Q::repeat(mechanism.n(), S::ZERO);
    for (k, row) in rows.iter().enumerate() {
        entries_of(a, row).for_each(|(entry, j)| spread[j] = entry);
        if let Some(column) = common_column(mechanism) {
            spread[column] = S::ZERO;
        }
        let own = &mut products.as_mut()[row.diagonal + row.first - k..=row.diagonal];
        for (other, product) in rows[row.first..=k].iter().zip(own) {
            *product = inner(b, other, &spread);
        }
        row.columns.iter().for_each(|j| spread[*j] = S::ZERO);
    }
}

/// An envelope of zeros.
pub(super) fn blank_envelope<S: Scalar, M: Mechanism<S>>(mechanism: &M) -> M::Envelope {
    let last = sparse_rows(mechanism).last();
    M::Envelope::repeat(last.map_or(0, |row| row.diagonal + 1), S::ZERO)
}

/// The inner product, as four sums: one would wait for each of its additions.
#[inline(always)]
pub(super) fn dot<S: Scalar>(a: &[S], b: &[S]) -> S {
    let ([a, last_of_a], [b, last_of_b]) = (in_fours(a), in_fours(b));
    let mut sums = [S::ZERO; 4];
    for (a, b) in a.chunks_exact(4).zip(b.chunks_exact(4)) {
        for k in 0..4 {
            sums[k] = sums[k] + a[k] * b[k];
        }
    }
    let last = sum(last_of_a.iter().zip(last_of_b).map(|(a, b)| *a * *b));
    (sums[0] + sums[1]) + (sums[2] + sums[3]) + last
}

/// The part whose length is a multiple of four, and the others.
#[inline(always)]
fn in_fours<S>(numbers: &[S]) -> [&[S]; 2] {
    let (fours, last) = numbers.split_at(numbers.len() / 4 * 4);
    [fours, last]
}

/// L D L' factors within the envelope.
#[derive(Clone, Debug)]
pub(crate) struct Envelope<M: Mechanism<S>, S: Scalar = f64> {
    /// L, below the diagonal; the diagonal is that of the matrix.
    lower: M::Envelope,
    /// 1/D; zero for rows that depend on those before.
    inverse_pivots: M::L,
    common: Common<M::L>,
}

impl<S: Scalar, M: Mechanism<S>> Envelope<M, S> {
    /// As [`Definite`](crate::numerics::solve::Definite) does.
    #[inline]
    fn factorise(&mut self, mechanism: &M) -> Result<(), Undefined> {
        let rows = sparse_rows(mechanism);
        let mut left = Left::<M, S>::of(mechanism);
        for (k, row) in rows.iter().enumerate() {
            let (before, own) = self.lower.as_mut().split_at_mut(row.diagonal + row.first - k);
            let mut square = own[k - row.first];
            if let Some(left) = &mut left {
                left.add(row, &self.common.entries.as_ref()[row.first..=k], own);
                square = square + self.common.entries[k] * self.common.entries[k];
            }
            for j in row.first..k {
                let other = &rows[j];
                let first = row.first.max(other.first);
                let theirs = &before[other.diagonal + first - j..other.diagonal];
                let known = dot(&own[first - row.first..j - row.first], theirs);
                own[j - row.first] = own[j - row.first] - known;
            }
            let mut pivot = own[k - row.first];
            for (entry, inverse) in own.iter_mut().zip(&self.inverse_pivots.as_ref()[row.first..k]) {
                let scaled = *entry * *inverse;
                pivot = pivot - *entry * scaled;
                *entry = scaled;
            }
            let found = inverse_pivot(pivot, square);
            let inverse = found.ok_or(Undefined { row: row.constraint })?;
            self.inverse_pivots[k] = inverse;
            if let Some(left) = &mut left {
                own[k - row.first] = square;
                let known = dot(&own[..k - row.first], &left.turned.as_ref()[row.first..k]);
                self.common.shares[k] = left.take(k, self.common.entries[k] - known, inverse);
            }
        }
        Ok(())
    }

    /// The entries of L in a row.
    #[inline(always)]
    fn row_of_l(&self, k: usize, row: &SparseRow) -> &[S] {
        &self.lower.as_ref()[row.diagonal + row.first - k..row.diagonal]
    }

    /// The part of a row that is orthogonal to those before it, of the entries that were factorised: a row of L^-1 A.
    pub(crate) fn part(&self, mechanism: &M, entries: &M::Entries, constraint: usize) -> M::Q {
        let rows = sparse_rows(mechanism);
        let (mut part, mut shares) = (M::Q::repeat(mechanism.n(), S::ZERO), M::L::repeat(rows.len(), S::ZERO));
        let place = rows.iter().position(|row| row.constraint == constraint).unwrap_or(0);
        shares[place] = S::from_f64(1.0);
        let mut later = Total::of(mechanism);
        for (k, row) in rows[..=place].iter().enumerate().rev() {
            if let Some(later) = &later {
                shares[k] = shares[k] - self.common.shares[k] * later.of_other_parts(row);
            }
            let share = shares[k];
            entries_of(entries, row).for_each(|(entry, j)| part[j] = part[j] + share * entry);
            let own = shares.as_mut()[row.first..k].iter_mut().zip(self.row_of_l(k, row));
            own.for_each(|(other, l)| *other = *other - share * *l);
            if let Some(later) = &mut later {
                later.add(row, share * self.common.entries[k]);
            }
        }
        part
    }

    #[inline]
    fn solve(&self, mechanism: &M, rhs: M::L) -> M::L {
        let rows = sparse_rows(mechanism);
        let mut x = rhs.like(|k| rhs[rows[k].constraint]);
        let mut earlier = Total::of(mechanism);
        for (k, row) in rows.iter().enumerate() {
            let known = dot(self.row_of_l(k, row), &x.as_ref()[row.first..k]);
            x[k] = x[k] - known;
            if let Some(earlier) = &mut earlier {
                x[k] = x[k] - self.common.entries[k] * earlier.of_other_parts(row);
                earlier.add(row, self.common.shares[k] * x[k]);
            }
        }
        (0..mechanism.m()).for_each(|k| x[k] = x[k] * self.inverse_pivots[k]);
        let mut later = Total::of(mechanism);
        for (k, row) in rows.iter().enumerate().rev() {
            if let Some(later) = &later {
                x[k] = x[k] - self.common.shares[k] * later.of_other_parts(row);
            }
            let value = S::select(self.inverse_pivots[k].abs().greater(S::ZERO), x[k], S::ZERO);
            x[k] = value;
            let before = x.as_mut()[row.first..k].iter_mut();
            before.zip(self.row_of_l(k, row)).for_each(|(x, entry)| *x = *x - *entry * value);
            if let Some(later) = &mut later {
                later.add(row, self.common.entries[k] * value);
            }
        }
        let mut solution = x.clone();
        rows.iter().zip(x.iter()).for_each(|(row, x)| solution[row.constraint] = *x);
        solution
    }
}
