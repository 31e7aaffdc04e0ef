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
use crate::motion::rows::{Rows, Sparse, is_sparse, may_have_turned, mixed_pivots, sparse_rows};
use crate::numerics::arrays::inner;
use crate::numerics::root::find_root;
use crate::state::failure::{Failure, constraint_name};
use crate::state::trajectory::{Sample, State};
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
/// A row of C_q this short, relative to its length, vanishes within the error of the prediction.
const FORETOLD: f64 = 0.1;
/// The same where it was found inside a step that was made.
const FOUND: f64 = 0.01;
/// A row this close to the space of those before it, as a sine, depends on them everywhere.
const DEPENDENT: f64 = 1e-9;
/// The least distance before a singular position at which the step over it may start, in units of the longest.
const APPROACH: f64 = 0.9;

/// The factors by which a step over a singular position is lengthened if its end would lie beside the next one, or
/// beside this one because that is just ahead: they keep it in wide gaps between stages.
const LONGER: [f64; 4] = [1.25, 2.6, 18.0, 64.0];
/// The fraction of the least sine that is sufficient at its end.
const FAR_ENOUGH: f64 = 0.7;
/// The factor by which an insufficient sine must grow at another end, for the step to be lengthened.
const MUCH_FARTHER: f64 = 2.0;

/// The horizon for predicting the sines at the ends of steps, in steps as long as the last.
const FORESIGHT: f64 = 3.0;
/// The predicted sine below which the way ahead is searched.
const LOOK: f64 = 0.3;
/// The tolerance of the time to a singular position beyond the next step, as predicted from the sine and its rate: a
/// sine that falls to zero does so linearly in the end.
const UNEVEN: f64 = 2.0;

/// How far the way over a singular position is searched, in lengths of the step over it.
const REACH: f64 = 1.5;

/// If a step changes the sine by less than this fraction, the sine tells the distance of the position.
const EVEN: f64 = 0.02;
/// The falling sine below which the way ahead is then searched: a step over a singular position begins at about half of
/// it.
const LOOK_EVENLY: f64 = 0.2;

/// Whether a singular position may lie within the next steps, after two that ended at these sines. Before there have
/// been two, it may.
#[inline]
pub(crate) fn may_be_ahead([before, now]: [f64; 2]) -> bool {
    let falls = before - now;
    match falls.abs() < EVEN * now {
        true => falls > 0.0 && now < LOOK_EVENLY,
        false => before.is_infinite() || now - FORESIGHT * falls < LOOK,
    }
}

/// The placement of steps over singular positions.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Lie {
    /// The longest ordinary step, in seconds.
    pub(crate) longest: f64,
    /// The place in a step that is farthest from its stages.
    pub(crate) gap: f64,
    /// The least sine at the ends of a step over a singular position; the step may be lengthened for it.
    pub(crate) least_sine: f64,
}

impl Lie {
    /// The possible length of a step over a singular position, if the sine falls by this much over the longest ordinary
    /// step.
    fn length(&self, falls: f64) -> f64 {
        let needed = self.least_sine / (APPROACH * self.gap * falls) * self.longest;
        if needed > self.longest { needed } else { self.longest }
    }
}

/// The way ahead within about a step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Ahead {
    /// No singular position.
    Nothing,
    /// One that a step to this time leads up to, so that the next one leads over it.
    UpTo(f64),
    /// One that a step to this time leads over.
    Over(f64),
}

/// How to continue from a sample so that stages avoid the singular position ahead, if there is one.
pub(crate) fn look_ahead<M: Mechanism>(motion: &Motion<M>, from: &Sample<M>, lie: &Lie) -> Ahead {
    let now = from.state.time;
    match singularity_ahead(motion, from, lie) {
        None => Ahead::Nothing,
        Some((ahead, h)) if ahead <= lie.gap * h => Ahead::Over(now + far_enough(motion, from, lie, ahead / lie.gap)),
        Some((ahead, h)) => Ahead::UpTo(now + ahead - APPROACH * lie.gap * h),
    }
}

/// The length of a step over a singular position whose end is far enough from any.
fn far_enough<M: Mechanism>(motion: &Motion<M>, from: &Sample<M>, lie: &Lie, length: f64) -> f64 {
    let followed = Followed::at(motion, &from.state);
    let least_sine = |longer: f64| {
        let ahead = longer * length;
        let parts = followed.parts(from.state.time + ahead, &foretold(&from.state, &from.accelerations, ahead));
        followed.weakest(&parts).map_or(f64::INFINITY, |(_, sine)| sine)
    };
    let mut best = (1.0, least_sine(1.0));
    for longer in LONGER {
        if best.1 >= FAR_ENOUGH * lie.least_sine {
            break;
        }
        let sine = least_sine(longer);
        if sine >= MUCH_FARTHER * best.1 {
            best = (longer, sine);
        }
    }
    best.0 * length
}

/// The positions at this time after a state, predicted from positions, speeds and accelerations.
pub(crate) fn foretold<M: Mechanism>(state: &State<M>, accelerations: &M::Q, ahead: f64) -> M::Q {
    state.positions.like(|i| state.positions[i] + ahead * (state.speeds[i] + ahead / 2.0 * accelerations[i]))
}

/// The time to the first singular position within about a step, predicted from positions, speeds and accelerations, and
/// the possible length of a step over it.
fn singularity_ahead<M: Mechanism>(motion: &Motion<M>, from: &Sample<M>, lie: &Lie) -> Option<(f64, f64)> {
    let state = &from.state;
    let followed = Followed::at(motion, state);
    let rows = followed.may_reverse(from, lie);
    if rows.is_empty() {
        return None;
    }
    let parts = |rows: &[usize], ahead: f64| {
        followed.parts_of(rows, state.time + ahead, &foretold(&from.state, &from.accelerations, ahead))
    };
    let (here, next) = (parts(&rows, 0.0), parts(&rows, lie.longest));
    let of_row = |(k, row): (usize, usize)| {
        let here = &here[k];
        let along = |part: &M::Q| inner(part, here);
        let part = |ahead: f64| parts(&[row], ahead).swap_remove(0);
        let sine = followed.sine(row, here);
        let falls = sine * (1.0 - along(&next[k]) / along(here));
        if !may_be_ahead([sine + falls, sine]) {
            return None;
        }
        let (slope, h) = (falls / lie.longest, lie.length(falls));
        let reach = REACH * h;
        let root =
            root_between(along(here), along(&part(reach)), 1e-4, &mut |s| Ok(along(&part(s * reach)))).ok()??;
        let ahead = root * reach;
        let is_even = (1.0 / UNEVEN..=UNEVEN).contains(&(ahead * slope / sine));
        let is_found = followed.sine(row, &part(ahead)) < FORETOLD && (ahead <= lie.longest || is_even);
        is_found.then_some((ahead, h))
    };
    rows.iter().copied().enumerate().filter_map(of_row).min_by(|(a, _), (b, _)| a.total_cmp(b))
}

/// The rows of C_q D whose independence is tracked: those declared, or if some are redundant, fixed independent
/// combinations of them.
pub(crate) struct Followed<'a, M: Mechanism> {
    motion: &'a Motion<M>,
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

    /// The same of some rows. For sparse rows they follow from their factors, which costs as much as a projection; a
    /// part that vanishes keeps half of its digits then.
    fn parts_of(&self, rows: &[usize], time: f64, q: &M::Q) -> Vec<M::Q> {
        let mechanism = self.motion.mechanism();
        if let Some(entries) = self.entries(time, q) {
            let mut factors = Sparse::no_factors(mechanism);
            if Sparse::factorise(mechanism, &entries, &mut factors).is_ok() {
                return rows.iter().map(|row| factors.part(mechanism, &entries, *row)).collect();
            }
        }
        let parts = self.parts(time, q);
        rows.iter().map(|row| parts[*row].clone()).collect()
    }

    /// The entries of sparse rows at a position, if they are tracked as they are.
    fn entries(&self, time: f64, q: &M::Q) -> Option<M::Entries> {
        let mechanism = self.motion.mechanism();
        (is_sparse(mechanism) && self.reduction.is_none()).then(|| {
            let linear = Sparse::linearization(mechanism, time, q);
            Sparse::columns(mechanism, &linear.jacobian, self.motion.measures())
        })
    }

    /// Whether a row may have reversed between two positions. For sparse rows this takes time linear in their number.
    pub(crate) fn may_have_passed(&self, states: [&State<M>; 2]) -> bool {
        match states.map(|state| self.entries(state.time, &state.positions)) {
            [Some(from), Some(to)] => may_have_turned(self.motion.mechanism(), &from, &to),
            _ => true,
        }
    }

    /// The rows that may reverse on the way ahead. For sparse rows this takes time linear in their number and excludes
    /// almost all.
    fn may_reverse(&self, from: &Sample<M>, lie: &Lie) -> Vec<usize> {
        let (mechanism, state) = (self.motion.mechanism(), &from.state);
        let all = 0..mechanism.m();
        let entries = |ahead: f64| self.entries(state.time + ahead, &foretold(state, &from.accelerations, ahead));
        let Some(here) = entries(0.0) else { return all.collect() };
        let none = || M::L::repeat(mechanism.m(), f64::NAN);
        let along = |ahead: f64| entries(ahead).map_or_else(none, |there| mixed_pivots(mechanism, &here, &there));
        let (squares, next, beyond) = (along(0.0), along(lie.longest), along(REACH * lie.longest));
        let longest = self.motion.longest();
        let may_reverse = |row: &usize| {
            let sine = (squares[*row] / longest[*row]).sqrt();
            let falls = sine * (1.0 - next[*row] / squares[*row]);
            let length = lie.length(falls);
            let is_clear = match () {
                _ if !falls.is_finite() => false,
                _ if !may_be_ahead([sine + falls, sine]) => true,
                _ if length > lie.longest => along(REACH * length)[*row] > 0.0,
                _ => beyond[*row] > 0.0,
            };
            !is_clear
        };
        all.filter(may_reverse).collect()
    }

    /// The part of each of these rows that is orthogonal to those before it.
    fn independent(&self, rows: &M::LQ) -> M::LQ {
        let sparse_rows = sparse_rows(self.motion.mechanism());
        match sparse_rows.is_empty() || self.reduction.is_some() {
            true => independent_parts(rows, |k| (k, 0)),
            false => independent_parts(rows, |k| (sparse_rows[k].constraint, sparse_rows[k].first)),
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
    fn sine(&self, row: usize, part: &M::Q) -> f64 {
        let square = inner(part, part);
        match self.reduction {
            None => (square / self.motion.longest()[row]).sqrt(),
            Some(_) => self.motion.relative(square.sqrt()),
        }
    }

    /// The row closest to depending on those before it, among those that are not redundant, with its sine.
    fn weakest(&self, parts: &M::LQ) -> Option<(usize, f64)> {
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

/// A root in (0, 1) of a function that falls from a positive value to a negative one, if it does.
fn root_between(
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
