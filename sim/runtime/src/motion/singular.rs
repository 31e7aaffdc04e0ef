//! Singular positions, where constraints that are independent elsewhere depend on each other, and how a motion passes them.
//!
//! Branches of the configuration space cross there. Speeds do not jump, so the motion continues on its own branch; but
//! with s the sine of the angle between a row of C_q and those before it, rounding of positions is amplified by 1/s and
//! that of speeds by 1/s^2. Steps are therefore placed so that such a position falls between stages.
//!
//! Sines are those of C_q D, with each coordinate in its scale, so they are the same for a linkage of 1 mm and for one
//! of 100 m.

use crate::motion::Motion;
use crate::motion::reduction::Reduction;
use crate::motion::rows::{Envelope, Rows, Sparse, first_met, is_sparse, may_have_turned, sparse_rows};
use crate::numerics::arrays::inner;
use crate::numerics::root::find_root;
use crate::state::failure::{Failure, constraint_name};
use crate::state::trajectory::State;
use sim_kernel::{Array, Mechanism};

/// A singular position that a run has passed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Singularity {
    /// The constraint that depends on those before it there.
    pub constraint: &'static str,
    /// When, in seconds.
    pub time: f64,
    /// The remaining sine of its angle to them; its row of C_q counts relative to its greatest length so far.
    pub sine: f64,
}

/// Below this sine a projection would make a step less accurate: rounding of 1e-16 times 1/s^2 is 1e-12.
pub(crate) const AT: f64 = 0.01;
/// Below this one reactions are lost: they follow from accelerations.
pub(crate) const IN: f64 = 1e-3;
/// Below this one accelerations may be more accurate if fitted to those on both sides, because they follow from
/// projected positions and speeds.
pub(crate) const BESIDE: f64 = 0.1;
/// A row of C_q this short, relative to its length, vanishes inside a step that was made.
const FOUND: f64 = 0.01;
/// A row this close to the space of those before it, as a sine, depends on them everywhere.
const DEPENDENT: f64 = 1e-9;

/// The rows of C_q D whose independence is tracked: those declared, or if some are redundant, fixed independent
/// combinations of them.
pub(crate) struct Followed<'a, M: Mechanism> {
    pub(super) motion: &'a Motion<M>,
    reduction: Option<Reduction<M>>,
}

impl<'a, M: Mechanism> Followed<'a, M> {
    /// The rows at a state.
    pub(crate) fn at(motion: &'a Motion<M>, state: &State<M>) -> Followed<'a, M> {
        let measures = motion.measures();
        let reduction = measures.is_redundant().then(|| {
            let jacobian = motion.mechanism().constraint_jacobian(state.time, &state.positions);
            Reduction::new(motion.mechanism(), &jacobian, measures, measures.rank())
        });
        Followed { motion, reduction }
    }

    /// The part of each row at a position that is orthogonal to those before it.
    #[inline]
    pub(crate) fn parts(&self, time: f64, q: &M::Q) -> M::LQ {
        self.independent(&self.rows(time, q))
    }

    /// The same; of sparse rows by their factors, which cost as much as a projection.
    pub(super) fn parts_at(&self, time: f64, q: &M::Q) -> Parts<M> {
        let mechanism = self.motion.mechanism();
        if self.is_sparse() {
            let (entries, mut factors) = (self.entries(time, q), Sparse::no_factors(mechanism));
            if Sparse::factorise(mechanism, &entries, &mut factors).is_ok() {
                return Parts::Factored { entries, factors };
            }
        }
        Parts::All(self.parts(time, q))
    }

    /// Whether the rows are sparse: combinations of redundant ones are not.
    pub(super) fn is_sparse(&self) -> bool {
        is_sparse(self.motion.mechanism()) && self.reduction.is_none()
    }

    /// The entries of sparse rows at a position.
    pub(super) fn entries(&self, time: f64, q: &M::Q) -> M::Entries {
        let mechanism = self.motion.mechanism();
        let linear = Sparse::linearization(mechanism, time, q);
        Sparse::columns(mechanism, &linear.jacobian, self.motion.measures())
    }

    /// Whether a row may have reversed between two positions. For sparse rows this takes time linear in their number.
    pub(crate) fn may_have_passed(&self, states: [&State<M>; 2]) -> bool {
        if !self.is_sparse() {
            return true;
        }
        let [from, to] = states.map(|state| self.entries(state.time, &state.positions));
        may_have_turned(self.motion.mechanism(), &from, &to)
    }

    /// The part of each of these rows that is orthogonal to those before it.
    fn independent(&self, rows: &M::LQ) -> M::LQ {
        match self.is_sparse() {
            true => independent_sparse(self.motion.mechanism(), rows),
            false => independent_parts(rows, |k| (k, 0)),
        }
    }

    fn rows(&self, time: f64, q: &M::Q) -> M::LQ {
        let jacobian = self.motion.mechanism().constraint_jacobian(time, q);
        let columns = self.motion.measures().columns(self.motion.mechanism(), &jacobian);
        match &self.reduction {
            Some(reduction) => reduction.rows(&columns),
            None => columns,
        }
    }

    /// The length of the independent part of a row, relative to its greatest length so far; for combinations, relative
    /// to the greatest length so far of the shortest part.
    pub(super) fn sine(&self, row: usize, part: &M::Q) -> f64 {
        let square = inner(part, part);
        match self.reduction {
            None => (square / self.motion.longest()[row]).sqrt(),
            Some(_) => self.motion.relative(square.sqrt()),
        }
    }

    /// The row closest to depending on those before it, among those that are not redundant, with its sine.
    pub(super) fn weakest(&self, parts: &M::LQ) -> Option<(usize, f64)> {
        let sines = (0..parts.len()).map(|row| (row, self.sine(row, &parts[row]))).filter(|(_, sine)| *sine > 0.0);
        sines.min_by(|(_, a), (_, b)| a.total_cmp(b))
    }

    /// The constraint of a row, or the one with the largest part in it.
    fn constraint(&self, row: usize) -> &'static str {
        constraint_name(
            self.motion.mechanism(),
            self.reduction.as_ref().map_or(row, |reduction| reduction.leading(row)),
        )
    }

    /// The singular position between two times, if there is one: there the independent part of a row reverses. `at`
    /// gives the state at a time.
    pub(crate) fn passed(
        &self,
        [from, to]: [f64; 2],
        [before, after]: [&M::LQ; 2],
        at: &mut dyn FnMut(f64) -> Result<State<M>, Failure>,
    ) -> Result<Option<Singularity>, Failure> {
        let time = |fraction: f64| from + fraction * (to - from);
        let mut parts = |fraction: f64| at(time(fraction)).map(|state| self.parts(state.time, &state.positions));
        for row in 0..before.len() {
            let along = |parts: &M::LQ| inner(&parts[row], &before[row]);
            let found = root_between(along(before), along(after), 1e-12, &mut |s| Ok(along(&parts(s)?)))?;
            let Some(fraction) = found else { continue };
            let sine = self.sine(row, &parts(fraction)?[row]);
            if sine < FOUND {
                return Ok(Some(Singularity { constraint: self.constraint(row), time: time(fraction), sine }));
            }
        }
        Ok(None)
    }
}

/// The parts of rows at a position that are orthogonal to those before them.
pub(super) enum Parts<M: Mechanism> {
    All(M::LQ),
    /// To be found from the factors of sparse rows. One that vanishes keeps half of its digits then.
    Factored {
        entries: M::Entries,
        factors: Envelope<M>,
    },
}

impl<M: Mechanism> Parts<M> {
    /// That of one row.
    pub(super) fn of(&self, mechanism: &M, row: usize) -> M::Q {
        match self {
            Parts::All(parts) => parts[row].clone(),
            Parts::Factored { entries, factors } => factors.part(mechanism, entries, row),
        }
    }
}

/// A root in (0, 1) of a function that falls from a positive value to a negative one, if it does.
pub(super) fn root_between(
    first: f64,
    last: f64,
    tolerance: f64,
    f: &mut dyn FnMut(f64) -> Result<f64, Failure>,
) -> Result<Option<f64>, Failure> {
    if first > 0.0 && last < 0.0 { find_root(first, last, tolerance, f).map(Some) } else { Ok(None) }
}

/// The constraint closest to depending on those before it, among those that are not redundant, with its sine.
pub(crate) fn weakest_constraint<M: Mechanism>(motion: &Motion<M>, state: &State<M>) -> Option<(&'static str, f64)> {
    let followed = Followed::at(motion, state);
    let rows = followed.rows(state.time, &state.positions);
    motion.lengthen(|row| inner(&rows[row], &rows[row]));
    let parts = followed.independent(&rows);
    if followed.reduction.is_some() {
        let lengths = parts.iter().map(|part| inner(part, part).sqrt()).filter(|length| *length > 0.0);
        motion.widen(lengths.fold(f64::INFINITY, f64::min));
    }
    followed.weakest(&parts).map(|(row, sine)| (followed.constraint(row), sine))
}

/// The part of each sparse row that is orthogonal to those before it in the order of elimination.
fn independent_sparse<M: Mechanism>(mechanism: &M, rows: &M::LQ) -> M::LQ {
    let order = sparse_rows(mechanism);
    independent_parts(rows, |k| (order[k].constraint, first_met(mechanism, &order[k])))
}

/// The part of each row that is orthogonal to those before it; zero for one that depends on them everywhere. The k-th
/// row is given with the index of the first row that it need not be orthogonal to.
fn independent_parts<A: Array<Q>, Q: Array<f64>>(jacobian: &A, row: impl Fn(usize) -> (usize, usize)) -> A {
    let mut parts = jacobian.clone();
    for k in 0..jacobian.len() {
        let (i, first) = row(k);
        let mut part = parts[i].clone();
        // Twice, to remove the rounding of the first subtraction.
        for (j, _) in (first..k).chain(first..k).map(&row) {
            let square = inner(&parts[j], &parts[j]);
            if square > 0.0 {
                let share = inner(&parts[j], &part) / square;
                part = part.like(|k| part[k] - share * parts[j][k]);
            }
        }
        let is_dependent = inner(&part, &part) <= DEPENDENT * DEPENDENT * inner(&jacobian[i], &jacobian[i]);
        parts[i] = if is_dependent { part.like(|_| 0.0) } else { part };
    }
    parts
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::motion::rows::examples::{Chain, Driven, Engine};
    use nalgebra::{DMatrix, DVector};

    /// What is left of each row beside all of those before it, by singular values. Rows depend where their sine is below 1e-9;
    /// none is near that but the one that is declared twice.
    fn check<M: Mechanism>(mechanism: &M) {
        let (n, order) = (mechanism.n(), sparse_rows(mechanism));
        for k in 0..40 {
            let q = M::Q::with_len(n, |i| (f64::from(k) * 1.7 + i as f64 * 2.3).sin() * 3.0);
            let rows = mechanism.constraint_jacobian(0.0, &q);
            let parts = independent_sparse(mechanism, &rows);
            let of = |k: usize| DVector::from_fn(n, |j, _| rows[order[k].constraint][j]);
            for k in 1..order.len() {
                let before = DMatrix::from_columns(&(0..k).map(of).collect::<Vec<_>>());
                let along = before.svd(true, false).u.unwrap_or_default();
                let left = of(k) - &along * (along.transpose() * of(k));
                let part = DVector::from_column_slice(parts[order[k].constraint].as_ref());
                assert!((part - left).norm() < 1e-8, "{k}");
            }
        }
    }

    #[test]
    fn parts_of_sparse_rows_are_what_projection_leaves() {
        check(&Chain::<f64>::default());
        check(&Engine::<f64>::default());
        check(&Driven::<f64>::default());
    }
}
