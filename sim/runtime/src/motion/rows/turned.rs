//! Whether a row may have reversed between two positions, relative to those before it.
//!
//! A row reverses where its part that is independent of those before it passes zero. With A and B the rows at both
//! positions, the leading minors of A B' are inner products of the volumes that the first rows span (Cauchy and Binet).
//! So the pivots of its elimination, ratios of successive ones, are positive while no such volume reverses. Only if one
//! is not positive must the parts themselves be computed, at a cost quadratic in the number of rows.

use super::common::common_column;
use super::sparse::{blank_envelope, common_entries, dot, products, sparse_rows};
use sim_kernel::{Array, Mechanism, SparseRow};

/// A pivot this small relative to its terms is undecided: it has lost its digits, or the rows nearly depend on each
/// other, as with sines of 0.01 at both positions.
const LEAST: f64 = 1e-4;

/// Whether a row may have, from the entries of C_q D at both positions.
pub(crate) fn may_have_turned<M: Mechanism>(mechanism: &M, before: &M::Entries, after: &M::Entries) -> bool {
    mixed_pivots(mechanism, before, after).iter().any(|pivot| pivot.is_nan())
}

/// The pivot of each constraint, NaN from the first on that is undecided or not positive. Between equal positions they
/// are the squared lengths of the independent parts; near by, to first order, the products of the parts at both.
pub(crate) fn mixed_pivots<M: Mechanism>(mechanism: &M, before: &M::Entries, after: &M::Entries) -> M::L {
    let (rows, zero) = (sparse_rows(mechanism), blank_envelope(mechanism));
    // L below the diagonal of the one, the transpose of D U in the other.
    let (mut lower, mut upper) = (zero.clone(), zero);
    let (mut pivots, mut inverse_pivots) = (M::L::repeat(mechanism.m(), f64::NAN), M::L::repeat(mechanism.m(), 0.0));
    products(mechanism, after, before, &mut lower);
    products(mechanism, before, after, &mut upper);
    let mut left = Left::of(mechanism, [before, after]);
    for (k, row) in rows.iter().enumerate() {
        let start = row.diagonal + row.first - k;
        let (lower_before, own_lower) = lower.as_mut().split_at_mut(start);
        let (upper_before, own_upper) = upper.as_mut().split_at_mut(start);
        let mut product = own_lower[k - row.first];
        if let Some(left) = &mut left {
            product += left.add(k, row, [&mut *own_lower, &mut *own_upper]);
        }
        for j in row.first..k {
            let (other, at) = (&rows[j], j - row.first);
            let first = row.first.max(other.first);
            let (shared, theirs) = (first - row.first..at, other.diagonal + first - j..other.diagonal);
            own_lower[at] -= dot(&own_lower[shared.clone()], &upper_before[theirs.clone()]);
            own_lower[at] *= inverse_pivots[j];
            own_upper[at] -= dot(&own_upper[shared], &lower_before[theirs]);
        }
        let at = k - row.first;
        let pivot = own_lower[at] - dot(&own_lower[..at], &own_upper[..at]);
        if !(pivot > LEAST * product.abs()) {
            break;
        }
        pivots[row.constraint] = pivot;
        inverse_pivots[k] = 1.0 / pivot;
        if let Some(left) = &mut left {
            left.take(k, row, [&own_lower[..at], &own_upper[..at]], &inverse_pivots);
        }
    }
    pivots
}

/// What is left of a common column's product on the way through the parts, as for the factors of one position.
struct Left<M: Mechanism> {
    part: usize,
    left: f64,
    /// The column at both positions.
    common: [M::L; 2],
    /// Its part by U'^-1 and by L^-1.
    turned: [M::L; 2],
    taken: f64,
}

impl<M: Mechanism> Left<M> {
    fn of(mechanism: &M, positions: [&M::Entries; 2]) -> Option<Left<M>> {
        let column = common_column(mechanism)?;
        let none = M::L::repeat(mechanism.m(), 0.0);
        let common = positions.map(|entries| {
            let mut common = none.clone();
            common_entries(mechanism, entries, column, &mut common);
            common
        });
        Some(Left { part: 0, left: 1.0, common, turned: [none.clone(), none], taken: 0.0 })
    }

    /// Adds its share to the rows of both triangles; gives its whole product on the diagonal.
    fn add(&mut self, k: usize, row: &SparseRow, [lower, upper]: [&mut [f64]; 2]) -> f64 {
        if row.part != self.part {
            self.left *= 1.0 - self.left * self.taken;
            (self.part, self.taken) = (row.part, 0.0);
        }
        let [before, after] = &self.common;
        for (at, j) in (row.first..=k).enumerate() {
            lower[at] += self.left * after[k] * before[j];
            upper[at] += self.left * before[k] * after[j];
        }
        after[k] * before[k]
    }

    /// The row is eliminated, with these entries of L and of the transpose of D U.
    fn take(&mut self, k: usize, row: &SparseRow, [lower, upper]: [&[f64]; 2], inverse_pivots: &M::L) {
        let mut scaled =
            upper.iter().zip(&inverse_pivots.as_ref()[row.first..k]).map(|(entry, inverse)| entry * inverse);
        let along = |turned: &M::L, entries: &mut dyn Iterator<Item = f64>| -> f64 {
            turned.as_ref()[row.first..k].iter().zip(entries).map(|(x, entry)| x * entry).sum()
        };
        let known = [along(&self.turned[0], &mut scaled), along(&self.turned[1], &mut lower.iter().copied())];
        for (position, known) in known.into_iter().enumerate() {
            self.turned[position][k] = self.common[position][k] - known;
        }
        self.taken += self.turned[0][k] * self.turned[1][k] * inverse_pivots[k];
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::motion::rows::examples::{Chain, Driven, Engine};
    use crate::motion::rows::{Rows, Sparse};
    use nalgebra::{DMatrix, DVector};

    #[test]
    fn a_crank_that_is_driven_twice_has_a_dependent_row() {
        let mechanism = Driven::<f64>::default();
        assert!(<Driven<f64> as sim_kernel::Compiled>::DESCRIPTION.common_column == Some(0));
        for k in 0..40 {
            let q = <Driven<f64> as Mechanism>::Q::with_len(22, |i| (f64::from(k) * 1.7 + i as f64 * 2.3).sin() * 3.0);
            let entries = mechanism.sparse_linearization(0.0, &q).jacobian;
            let mut factors = Sparse::no_factors(&mechanism);
            Sparse::factorise(&mechanism, &entries, &mut factors).expect("finite");
            let dependent = <Sparse as Rows<f64, Driven>>::dependent(&mechanism, &factors);
            let dependent: Vec<usize> = dependent.map(|k| sparse_rows(&mechanism)[k].constraint).collect();
            assert_eq!(dependent, [22]);
        }
    }

    #[test]
    fn an_engine_is_in_parts() {
        let rows = sparse_rows(&Engine::<f64>::default());
        assert!(<Engine<f64> as sim_kernel::Compiled>::DESCRIPTION.common_column == Some(0));
        assert!(rows.iter().enumerate().all(|(k, row)| row.part == k / 2 * 2));
    }

    /// The part of a row by its factors is what orthogonal projection leaves of it, and its square is the mixed pivot of a
    /// position with itself; with half of the digits, since the factors are those of squares.
    #[test]
    fn parts_are_what_projection_leaves() {
        check_parts(&Chain::<f64>::default());
        check_parts(&Engine::<f64>::default());
    }

    fn check_parts<M: Mechanism>(mechanism: &M) {
        let n = mechanism.n();
        for k in 0..40 {
            let q = M::Q::with_len(n, |i| (f64::from(k) * 1.7 + i as f64 * 2.3).sin() * 3.0);
            let entries = mechanism.sparse_linearization(0.0, &q).jacobian;
            let mut factors = Sparse::no_factors(mechanism);
            Sparse::factorise(mechanism, &entries, &mut factors).expect("finite");
            let pivots = mixed_pivots(mechanism, &entries, &entries);
            let (rows, jacobian) = (sparse_rows(mechanism), mechanism.constraint_jacobian(0.0, &q));
            let of = |k: usize| DVector::from_fn(n, |j, _| jacobian[rows[k].constraint][j]);
            for k in 1..rows.len() {
                let before = DMatrix::from_columns(&(0..k).map(of).collect::<Vec<_>>());
                let along = before.svd(true, false).u.unwrap_or_default();
                let left = of(k) - &along * (along.transpose() * of(k));
                let part = factors.part(mechanism, &entries, rows[k].constraint);
                let off = (DVector::from_column_slice(part.as_ref()) - &left).norm();
                let square = (pivots[rows[k].constraint] - left.norm_squared()).abs();
                assert!(off < 1e-8 && square < 1e-8, "{k}: {off:e} {square:e}");
            }
            // And what the factors solve has the products of the rows as its matrix.
            let sides = M::L::with_len(rows.len(), |i| (i as f64 * 1.3).cos());
            let solved = Sparse::solve(mechanism, &factors, sides.clone());
            let along = M::Q::with_len(n, |j| (0..rows.len()).map(|i| jacobian[i][j] * solved[i]).sum());
            for i in 0..rows.len() {
                let found: f64 = (0..n).map(|j| jacobian[i][j] * along[j]).sum();
                let size = solved.iter().fold(1.0f64, |size, x| size.max(x.abs()));
                assert!((found - sides[i]).abs() < 1e-12 * size, "{k} {i}: {found} {}", sides[i]);
            }
        }
    }

    /// The ratios of successive leading minors of A B', by determinants, beside the products of the rows.
    fn pivots<M: Mechanism>(mechanism: &M, [a, b]: [&M::LQ; 2]) -> Vec<f64> {
        let rows = sparse_rows(mechanism);
        let whole = |all: &M::LQ| DMatrix::from_fn(mechanism.m(), mechanism.n(), |k, j| all[rows[k].constraint][j]);
        let products = whole(a) * whole(b).transpose();
        let minors: Vec<f64> =
            (0..=mechanism.m()).map(|k| products.view((0, 0), (k, k)).into_owned().determinant()).collect();
        (0..mechanism.m()).map(|k| minors[k + 1] / minors[k] / products[(k, k)].abs()).collect()
    }

    /// Rows have reversed where a leading minor has changed its sign, and nothing else is computed where none has.
    #[test]
    fn rows_have_turned_where_a_leading_minor_is_negative() {
        check_turns(&Chain::<f64>::default());
        check_turns(&Engine::<f64>::default());
    }

    fn check_turns<M: Mechanism>(mechanism: &M) {
        let n = mechanism.n();
        let (mut turned, mut unturned) = (0, 0);
        for k in 0..400 {
            // Angles, of which alone C_q depends, that differ by up to 0.01 to 4 rad.
            let spread = 0.01 * 400f64.powf(f64::from(k) / 399.0);
            let at = |i: usize, part: f64| (f64::from(k) * 1.7 + i as f64 * 2.3).sin() * 3.0 + part;
            let from = M::Q::with_len(n, |i| at(i, 0.0));
            let to = M::Q::with_len(n, |i| at(i, spread * (f64::from(k) * 3.1 + i as f64 * 1.9).sin()));
            let entries = [&from, &to].map(|q| mechanism.sparse_linearization(0.0, q).jacobian);
            let jacobians = [&from, &to].map(|q| mechanism.constraint_jacobian(0.0, q));
            let pivots = pivots(mechanism, jacobians.each_ref());
            let least = pivots.iter().copied().fold(f64::INFINITY, f64::min);
            let found = may_have_turned(mechanism, &entries[0], &entries[1]);
            // Between, digits that are lost may count as a turn.
            if least < 0.0 {
                assert!(found, "{k}: {least}");
                turned += 1;
            } else if least > 10.0 * LEAST {
                assert!(!found, "{k}: {least}");
                unturned += 1;
            }
        }
        assert!(turned > 20 && unturned > 200, "{turned} {unturned}");
    }
}
