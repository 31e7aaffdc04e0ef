//! A column that parts of the rows have in common.
//!
//! Where parts of the rows have a single column in common, c, what that adds to their products between parts
//! is c_k c_j, and every part leaves less of it to the next ones: eliminating a part with the matrix M = A A' + a c c' and the
//! factors L D L' leaves
//!
//! ```text
//! a - a^2 c' M^-1 c   of a,   and   c_k v_j,  v = a D^-1 L^-1 c,   of L in the rows k of all later parts
//! ```
//!
//! (a semiseparable matrix: Vandebril, Van Barel and Mastronardi, Matrix Computations and Semiseparable Matrices, 2008, chapter 4).
//! Each part keeps its share of c c' on its way, so the pivots are those of all rows in this order.

use sim_kernel::{Array, Mechanism, Scalar, SparseRow};

/// The column that parts of the rows have in common.
#[inline(always)]
pub(super) fn common_column<S: Scalar, M: Mechanism<S>>(mechanism: &M) -> Option<usize> {
    mechanism.description().common_column
}

/// What parts of the rows have in common.
#[derive(Clone, Debug)]
pub(super) struct Common<L> {
    /// c.
    pub(super) entries: L,
    /// v.
    pub(super) shares: L,
}

/// What is left of c c' on the way through the parts.
pub(super) struct Left<M: Mechanism<S>, S: Scalar> {
    /// The first row of the part.
    part: usize,
    /// a.
    left: S,
    /// L^-1 c.
    pub(super) turned: M::L,
    /// c' M^-1 c, as far as the part is eliminated.
    taken: S,
}

impl<S: Scalar, M: Mechanism<S>> Left<M, S> {
    /// Nothing where there are no parts.
    #[inline]
    pub(super) fn of(mechanism: &M) -> Option<Left<M, S>> {
        let one = S::from_f64(1.0);
        let all = || Left { part: 0, left: one, turned: M::L::repeat(mechanism.m(), S::ZERO), taken: S::ZERO };
        common_column(mechanism).map(|_| all())
    }

    /// Adds a c_k c_j to the entries of a row, from its first one on.
    #[inline]
    pub(super) fn add(&mut self, row: &SparseRow, common: &[S], own: &mut [S]) {
        if row.part != self.part {
            let left = self.left * (S::from_f64(1.0) - self.left * self.taken);
            (self.part, self.taken) = (row.part, S::ZERO);
            // Where a part has taken all of it rounding is left.
            self.left = S::select(left.greater(S::ZERO), left, S::ZERO);
        }
        let Some(last) = common.last() else { return };
        let share = self.left * *last;
        own.iter_mut().zip(common).for_each(|(own, common)| *own = *own + share * *common);
    }

    /// The row's entry of v, given that of L^-1 c and the inverse of its pivot.
    #[inline]
    pub(super) fn take(&mut self, k: usize, turned: S, inverse: S) -> S {
        self.turned[k] = turned;
        self.taken = self.taken + turned * turned * inverse;
        self.left * turned * inverse
    }
}

/// A sum over rows, part by part in either direction.
pub(super) struct Total<S> {
    /// The first row of the part of the last term.
    part: usize,
    /// Of this part, and of those before it.
    own: S,
    others: S,
}

impl<S: Scalar> Total<S> {
    /// Nothing where there are no parts.
    #[inline]
    pub(super) fn of<M: Mechanism<S>>(mechanism: &M) -> Option<Total<S>> {
        common_column(mechanism).map(|_| Total { part: 0, own: S::ZERO, others: S::ZERO })
    }

    #[inline]
    pub(super) fn add(&mut self, row: &SparseRow, term: S) {
        if row.part != self.part {
            self.others = self.others + self.own;
            (self.part, self.own) = (row.part, S::ZERO);
        }
        self.own = self.own + term;
    }

    /// Of the parts other than that of a row.
    #[inline]
    pub(super) fn of_other_parts(&self, row: &SparseRow) -> S {
        if row.part == self.part { self.others } else { self.others + self.own }
    }
}
