//! The sparsity of C_q, and an order of its rows in which the factors of C_q C_q' have little fill.
//!
//! Rows that have a coordinate in common are neighbours. They are ordered by the reverse of Cuthill and McKee's
//! algorithm (George and Liu, Computer Solution of Large Sparse Positive Definite Systems, 1981, chapter 4), unless the
//! declared order has as small an envelope: all fill of the factors of C_q C_q' lies in it.
//!
//! A coordinate that most rows have in common, as the legs of a walker have a crank, would make all of them neighbours. Its column is
//! taken out then: without it the rows fall into parts, each with an envelope of its own, and what the column adds between parts
//! is a product of two vectors, of which each part of the factors takes its share.
//!
//! Sparse rows are used only where they save operations. Elsewhere rows stay dense; the choice is a constant of the
//! type. Projection by the mass matrix, partitioning, redundant constraints and whatever runs once per simulation stay
//! dense.

use std::cmp::Reverse;
use std::collections::{BTreeMap, BTreeSet};

/// The sparsity of C_q.
pub struct Sparsity {
    /// Its rows in the order in which they are eliminated.
    pub rows: Vec<SparseRow>,
    /// The column that parts of its rows have in common, if there are parts.
    pub common: Option<usize>,
}

/// A row of C_q.
#[derive(Clone)]
pub struct SparseRow {
    /// The constraint.
    pub constraint: usize,
    /// The columns of its entries that may be nonzero.
    pub columns: Vec<usize>,
    /// The place of its first entry among those of all rows.
    pub entries: usize,
    /// The place in the order of the first row of its part with which it has a column in common.
    pub first: usize,
    /// The place in the order of the first row of its part.
    pub part: usize,
    /// The place of its diagonal entry in the envelope of C_q C_q', row after row.
    pub diagonal: usize,
}

/// The number of contiguous dense operations that take as long as a sparse one of a product, with its overhead.
const LOOK_UP: usize = 8;
/// The same of one within the envelope, whose rows are contiguous but begin anywhere.
const WITHIN: usize = 2;

/// How many times fewer operations it must take to take out a column.
const PARTS_SAVE: usize = 2;

/// How many times smaller another order must make the envelope. The declared one goes from body to body: each row then
/// depends least on those before it, so positions seem singular only where they are.
const SAVES: usize = 2;

impl Sparsity {
    /// The sparsity of rows with entries in these columns; nothing if dense rows are as good.
    pub(super) fn of(columns: Vec<BTreeSet<usize>>, coordinates: usize) -> Option<Sparsity> {
        let whole = Sparsity::whole(&columns);
        let best = match Sparsity::in_parts(&columns) {
            Some(parts) if PARTS_SAVE * parts.operations() < whole.operations() => parts,
            _ => whole,
        };
        (best.operations() < dense_operations(columns.len(), coordinates)).then_some(best)
    }

    /// In parts that have one column in common, each in the declared order.
    fn in_parts(columns: &[BTreeSet<usize>]) -> Option<Sparsity> {
        let mut rows_of: BTreeMap<usize, usize> = BTreeMap::new();
        columns.iter().flatten().for_each(|column| *rows_of.entry(*column).or_default() += 1);
        let (common, _) = rows_of.into_iter().max_by_key(|(column, rows)| (*rows, Reverse(*column)))?;
        let without: Vec<BTreeSet<usize>> =
            columns.iter().map(|row| row.iter().copied().filter(|column| *column != common).collect()).collect();
        let apart = neighbours(&without);
        let mut order: Vec<usize> = Vec::new();
        let mut parts: Vec<usize> = Vec::new();
        for row in 0..columns.len() {
            if !order.contains(&row) {
                let (mut part, _) = by_levels(&apart, row);
                part.sort_unstable();
                parts.extend(part.iter().map(|_| order.len()));
                order.extend(part);
            }
        }
        let mut part_of = vec![0; columns.len()];
        order.iter().zip(&parts).for_each(|(row, part)| part_of[*row] = *part);
        let mut within = neighbours(columns);
        within.iter_mut().zip(&part_of).for_each(|(others, part)| others.retain(|other| part_of[*other] == *part));
        let firsts = firsts(&order, &within);
        let has_parts = parts.last().is_some_and(|last| *last > 0);
        has_parts.then(|| Sparsity { common: Some(common), ..Sparsity::laid_out(columns, order, firsts, parts) })
    }

    /// In whichever order has the smaller envelope.
    fn whole(columns: &[BTreeSet<usize>]) -> Sparsity {
        let neighbours = neighbours(columns);
        let declared: Vec<usize> = (0..columns.len()).collect();
        let reordered = reverse_cuthill_mckee(&neighbours);
        let envelope =
            |order: &[usize]| firsts(order, &neighbours).iter().enumerate().map(|(k, first)| k - first).sum();
        let [by_declaration, by_order]: [usize; 2] = [envelope(&declared), envelope(&reordered)];
        let order = if SAVES * by_order < by_declaration { reordered } else { declared };
        let firsts = firsts(&order, &neighbours);
        let parts = vec![0; order.len()];
        Sparsity::laid_out(columns, order, firsts, parts)
    }

    fn laid_out(columns: &[BTreeSet<usize>], order: Vec<usize>, firsts: Vec<usize>, parts: Vec<usize>) -> Sparsity {
        let mut sparsity = Sparsity { rows: Vec::new(), common: None };
        for (k, ((constraint, first), part)) in order.into_iter().zip(firsts).zip(parts).enumerate() {
            let [entries, envelope] = sparsity.sizes();
            let columns = columns[constraint].iter().copied().collect();
            sparsity.rows.push(SparseRow { constraint, columns, entries, first, part, diagonal: envelope + k - first });
        }
        sparsity
    }

    /// The number of entries of its rows and of the envelope.
    pub(crate) fn sizes(&self) -> [usize; 2] {
        self.rows.last().map_or([0; 2], |row| [row.entries + row.columns.len(), row.diagonal + 1])
    }

    /// Multiplications of C_q C_q' and its factorisation, in units of those of dense rows.
    fn operations(&self) -> usize {
        let of_row = |(k, row): (usize, &SparseRow)| {
            let inner: usize = self.rows[row.first..=k].iter().map(|other| other.columns.len()).sum();
            // What a common column adds takes a few for each entry of the row.
            let common = if self.common.is_some() { 2 * WITHIN * (k - row.first + 1) } else { 0 };
            LOOK_UP * inner + WITHIN * (k - row.first) * (k - row.first + 1) / 2 + common
        };
        self.rows.iter().enumerate().map(of_row).sum()
    }
}

/// The same of m dense rows of n entries.
fn dense_operations(m: usize, n: usize) -> usize {
    m * (m + 1) / 2 * n + m * m * m / 6
}

/// For each row the others that have a column in common with it.
fn neighbours(rows: &[BTreeSet<usize>]) -> Vec<BTreeSet<usize>> {
    let others = |i: usize| {
        let is_neighbour = |j: &usize| *j != i && !rows[i].is_disjoint(&rows[*j]);
        (0..rows.len()).filter(is_neighbour).collect()
    };
    (0..rows.len()).map(others).collect()
}

/// For each row of an order the place of the first of its neighbours or of itself.
fn firsts(order: &[usize], neighbours: &[BTreeSet<usize>]) -> Vec<usize> {
    let mut place = vec![0; order.len()];
    order.iter().enumerate().for_each(|(k, row)| place[*row] = k);
    let first = |(k, row): (usize, &usize)| neighbours[*row].iter().map(|other| place[*other]).fold(k, usize::min);
    order.iter().enumerate().map(first).collect()
}

/// Each connected part from a peripheral row, level by level; all of it reversed.
fn reverse_cuthill_mckee(neighbours: &[BTreeSet<usize>]) -> Vec<usize> {
    let mut order: Vec<usize> = Vec::new();
    let mut is_placed = vec![false; neighbours.len()];
    while let Some(row) = (0..neighbours.len()).filter(|i| !is_placed[*i]).min_by_key(|i| neighbours[*i].len()) {
        let (mut part, mut levels) = by_levels(neighbours, row);
        // From the last row again, until none is farther away.
        while let Some(last) = part.last() {
            let (other, more) = by_levels(neighbours, *last);
            if more <= levels {
                break;
            }
            (part, levels) = (other, more);
        }
        part.iter().for_each(|row| is_placed[*row] = true);
        order.extend(part);
    }
    order.reverse();
    order
}

/// The rows that a row is connected with, the nearest first and of those the ones with fewer neighbours, and how many steps away
/// the last is.
fn by_levels(neighbours: &[BTreeSet<usize>], row: usize) -> (Vec<usize>, usize) {
    let mut level = vec![None; neighbours.len()];
    level[row] = Some(0);
    let (mut order, mut k) = (vec![row], 0);
    while let Some(row) = order.get(k).copied() {
        let mut next: Vec<usize> = neighbours[row].iter().copied().filter(|other| level[*other].is_none()).collect();
        next.sort_by_key(|other| neighbours[*other].len());
        next.iter().for_each(|other| level[*other] = level[row].map(|level: usize| level + 1));
        order.extend(next);
        k += 1;
    }
    let levels = order.last().and_then(|last| level[*last]).unwrap_or(0);
    (order, levels)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Rows that share a coordinate with the next one, declared in this order.
    fn chain(order: &[usize]) -> Vec<BTreeSet<usize>> {
        order.iter().map(|k| BTreeSet::from([*k, k + 1])).collect()
    }

    #[test]
    fn a_chain_has_a_band_however_it_is_declared() {
        let shuffled: Vec<usize> = (0..60).map(|k| 7 * k % 60).collect();
        for order in [(0..60).collect(), shuffled] {
            let sparsity = Sparsity::of(chain(&order), 61).expect("sparse");
            let widths = sparsity.rows.iter().enumerate().map(|(k, row)| k - row.first);
            assert_eq!(widths.max(), Some(1));
            let constraints: BTreeSet<usize> = sparsity.rows.iter().map(|row| row.constraint).collect();
            assert_eq!(constraints.len(), 60);
        }
    }

    #[test]
    fn the_declared_order_stays_where_it_is_as_good() {
        let sparsity = Sparsity::of(chain(&(0..60).collect::<Vec<_>>()), 61).expect("sparse");
        assert!(sparsity.rows.iter().enumerate().all(|(k, row)| row.constraint == k));
    }

    /// Legs of four rows, of which the last two have to do with column 0 too, declared one row of each leg after the other.
    #[test]
    fn parts_with_a_common_column_lie_side_by_side() {
        let row = |k: usize| {
            let (leg, at) = (k % 20, k / 20);
            let own = [1 + 4 * leg + at, 1 + 4 * leg + (at + 1) % 4];
            own.into_iter().chain((at > 1).then_some(0)).collect()
        };
        let sparsity = Sparsity::of((0..80).map(row).collect(), 81).expect("sparse");
        assert_eq!(sparsity.common, Some(0));
        for (k, row) in sparsity.rows.iter().enumerate() {
            assert_eq!((row.part, row.constraint), (k / 4 * 4, k / 4 + 20 * (k % 4)));
            assert!(row.first >= row.part);
        }
        assert_eq!(sparsity.sizes()[1], 20 * (1 + 2 + 2 + 4));
    }

    #[test]
    fn few_rows_and_full_rows_stay_dense() {
        assert!(Sparsity::of(chain(&[0, 1, 2, 3]), 5).is_none());
        assert!(Sparsity::of(vec![(0..61).collect(); 60], 61).is_none());
        assert!(Sparsity::of(vec![], 5).is_none());
    }
}
