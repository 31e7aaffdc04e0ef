//! Least and greatest values of all quantities along a curve, independent of the recorded rows.
//!
//! A step is halved until every quantity over it is a polynomial to a small fraction of its range. Candidates are the
//! turning points of the polynomials; the best of each quantity is located again at the end, to rounding.

use super::inverse::AnyPrescribed;
use super::path::Path;
use super::piece::Piece;
use super::range::Range;
use super::series::{NODES, Series, nodes};
use crate::state::failure::Failure;
use std::f64::consts::TAU;
use std::ops::Range as Indices;
use std::rc::Rc;

/// The largest error of a polynomial, as a fraction of the quantity's range; and in units of rounding times the
/// condition.
const RESOLVED: f64 = 1e-10;
const ROUNDING: f64 = 4.0 * f64::EPSILON;
/// An error that does not shrink when an interval is halved is noise, if it is at most so many times the rounding of
/// its sources. Rounding of accelerations is amplified by the square of the condition.
const SHRINKS: f64 = 0.7;
const NOISE: f64 = 16.0;
/// The number of halvings of a step. A quantity that is not smooth then has a corner, and is searched by comparison.
const MOST_HALVINGS: usize = 8;
/// The fraction of its range by which a value must be better than an earlier one.
const BETTER: f64 = 1e-11;
/// A value is as good as another if they differ by less than this fraction of the range, and it is elsewhere if what is driven
/// differs by more than this, in radians: a flat extreme is found no more accurately.
const AS_GOOD: f64 = 2.0 * RESOLVED;
const ELSEWHERE: f64 = 0.01;
/// How far a polynomial may be off at the ends, in units of its error.
const MISSED: f64 = 100.0;
/// Distances from a singular place, in half steps, and the factor by which an unbounded quantity grows from each to the
/// next.
const TOWARDS: [f64; 3] = [1e-2, 1e-3, 1e-4];
const GROWS: f64 = 2.5;
/// A singular place this close to the end of an interval, in half steps, is in it.
const BESIDE: f64 = 1e-4;
/// The fraction of its range by which what is recorded must be beyond what was found, and the interval in which it is then
/// searched, in half steps.
const WITNESSED: f64 = 1e-8;
const WITNESS_REACH: f64 = 0.01;
/// The number of positions kept for testing whether outputs are functions of positions.
const MOST_PLACES: usize = 8;

/// The indices of quantities in one list.
#[derive(Clone, Debug)]
pub(super) struct Layout {
    pub(super) outputs: Indices<usize>,
    pub(super) multipliers: Indices<usize>,
    pub(super) forces: Indices<usize>,
    /// dy/ds of outputs that have a rate.
    pub(super) ratios: Indices<usize>,
    /// The volume that the columns of [C_q; y_q] span.
    pub(super) volume: usize,
    /// The length of each column that no drive holds.
    pub(super) columns: Indices<usize>,
}

/// The ranges found along a curve: `None` for quantities that are unbounded or not finite.
#[derive(Clone, Debug)]
pub(super) struct Found {
    pub(super) layout: Layout,
    pub(super) ranges: Vec<Option<Range>>,
    /// Whether a quantity has its least or its greatest value in several places, which do not coincide after a turn of the drive.
    pub(super) is_repeated: Vec<bool>,
    /// Times and positions on the way.
    pub(super) places: Vec<(f64, Vec<f64>)>,
}

impl Path<'_> {
    /// Whether the driven quantity differs between places of two steps, after whole turns.
    fn are_apart(&self, one: (&Piece, f64), other: (&Piece, f64)) -> bool {
        let [one, other] = [one, other].map(|(piece, x)| self.system.laws[0].at(self.at(piece, x).1));
        let turns = (one - other) / TAU;
        (turns - turns.round()).abs() * TAU > ELSEWHERE
    }
}

/// A search along a curve.
pub(super) struct Search<'s> {
    pub(super) path: &'s Path<'s>,
    pub(super) layout: Layout,
    /// Which column each of the last quantities is.
    columns: Vec<usize>,
    tracked: Vec<Tracked>,
    places: Vec<(f64, Vec<f64>)>,
}

/// The least and greatest value of a quantity so far.
#[derive(Clone, Default)]
struct Tracked {
    least: Option<Candidate>,
    greatest: Option<Candidate>,
    has_no_bound: bool,
    noise: f64,
}

/// A value that may be the least or the greatest.
#[derive(Clone)]
pub(super) struct Candidate {
    pub(super) value: f64,
    pub(super) piece: Rc<Piece>,
    /// The part of the step that belongs to the sweep.
    pub(super) within: [f64; 2],
    pub(super) x: f64,
    /// The interval around it in which the quantity is known.
    pub(super) reach: f64,
    pub(super) kind: Kind,
    /// Whether the quantity is as good elsewhere.
    is_repeated: bool,
}

#[derive(Clone, Copy, PartialEq)]
pub(super) enum Kind {
    /// The polynomial turns there.
    Turn,
    /// The value of a node, where there is no polynomial.
    Rough,
    /// An end of the interval.
    End,
}

/// Quantities searched in an interval, each with the error of its polynomial over an interval twice as long.
type Pending = Vec<(usize, f64)>;

/// Whether a quantity of these sizes, each at a tenth of the distance of the one before, grows without bound.
pub(super) fn grows([far, nearer, near]: [f64; 3]) -> bool {
    !(nearer < GROWS * far) && !(near < GROWS * nearer)
}

impl<'s> Search<'s> {
    pub(super) fn new(path: &'s Path<'s>) -> Search<'s> {
        let (system, description) = (path.system, path.system.mechanism.description());
        let columns: Vec<usize> = system.dependent_columns().collect();
        let mut first = 0;
        let mut take = |len: usize| {
            first += len;
            first - len..first
        };
        let layout = Layout {
            outputs: take(description.outputs.len()),
            multipliers: take(description.constraints.len()),
            forces: take(system.laws.len()),
            ratios: take(description.rated_outputs.len()),
            volume: take(1).start,
            columns: take(columns.len()),
        };
        Search { path, tracked: vec![Tracked::default(); layout.columns.end], layout, columns, places: Vec::new() }
    }

    /// Every quantity of a motion.
    pub(super) fn values(&self, motion: &AnyPrescribed) -> Vec<f64> {
        let system = self.path.system;
        let mut values = system.mechanism.outputs(motion.at());
        values.extend(&motion.multipliers);
        values.extend(&motion.forces);
        values.extend(motion.ratios(system));
        values.push(motion.volume);
        values.extend(self.columns.iter().map(|j| motion.columns[*j]));
        values
    }

    pub(super) fn values_at(&self, piece: &Piece, x: f64) -> Result<Vec<f64>, Failure> {
        Ok(self.values(&self.path.motion_at(piece, x)?))
    }

    /// Records the extremes of a step between two of its places.
    ///
    /// # Errors
    /// As [`Path::motion`].
    pub(super) fn look(&mut self, piece: &Rc<Piece>, within: [f64; 2]) -> Result<(), Failure> {
        if self.places.len() < MOST_PLACES {
            let (q, p) = self.path.at(piece, within[0]);
            self.places.push((self.path.system.time(p), q));
        }
        if within[0] < within[1] {
            let all = (0..self.tracked.len()).filter(|k| !self.tracked[*k].has_no_bound);
            let all: Pending = all.map(|k| (k, f64::INFINITY)).collect();
            let parts = self.between_breaks(piece, within);
            return parts.into_iter().try_for_each(|part| self.halves(piece, within, part, all.clone(), 0));
        }
        if self.tracked.iter().all(|tracked| tracked.least.is_none()) {
            let values = self.values_at(piece, within[0])?;
            (0..values.len()).for_each(|k| self.offer(k, (piece, within), (values[k], within[0], 0.0, Kind::End)));
        }
        Ok(())
    }

    /// The same for some quantities in an interval.
    fn halves(
        &mut self,
        piece: &Rc<Piece>,
        within: [f64; 2],
        [from, to]: [f64; 2],
        pending: Pending,
        halvings: usize,
    ) -> Result<(), Failure> {
        let place = |x: f64| from + (to - from) * (1.0 + x) / 2.0;
        let at = |node: f64| self.values_at(piece, place(node));
        let rows: Vec<Vec<f64>> = nodes().into_iter().map(at).collect::<Result<_, _>>()?;
        // In a limit position itself there is no motion.
        let ends = [-1.0, 1.0].map(|end| at(end).ok());
        let (mut open, reach) = (Pending::new(), (to - from) / 2.0);
        for (k, lacked) in pending {
            let values: [f64; NODES] = std::array::from_fn(|node| rows[node][k]);
            if values.iter().any(|value| !value.is_finite()) {
                self.tracked[k].has_no_bound = true;
                continue;
            }
            let series = Series::through(values);
            let at_ends = ends.each_ref().map(|end| end.as_ref().map(|values| values[k]));
            if self.is_resolved(k, &series, (&values, at_ends), lacked, (piece, &rows)) {
                let turns = series.turns().into_iter().map(|x| (x, Kind::Turn));
                // Beside an end that was made by halving there may be a corner.
                let end = |x: f64| (x, if within.contains(&place(x)) { Kind::End } else { Kind::Rough });
                for (x, kind) in turns.chain([end(-1.0), end(1.0)]) {
                    self.offer(k, (piece, within), (series.at(x), place(x), reach, kind));
                }
            } else if halvings == MOST_HALVINGS {
                let known_ends = [-1.0, 1.0].into_iter().zip(at_ends).filter_map(|(end, value)| Some((end, value?)));
                for (node, value) in nodes().into_iter().zip(values).chain(known_ends) {
                    self.offer(k, (piece, within), (value, place(node), reach, Kind::Rough));
                }
            } else {
                open.push((k, series.tail()));
            }
        }
        self.drop_unbounded(piece, [from, to], &mut open)?;
        if open.is_empty() {
            return Ok(());
        }
        let middle = (from + to) / 2.0;
        self.halves(piece, within, [from, middle], open.clone(), halvings + 1)?;
        self.halves(piece, within, [middle, to], open, halvings + 1)
    }

    /// Whether a polynomial represents a quantity to the tolerance.
    fn is_resolved(
        &mut self,
        k: usize,
        series: &Series,
        (values, at_ends): (&[f64; NODES], [Option<f64>; 2]),
        lacked: f64,
        (piece, rows): (&Piece, &[Vec<f64>]),
    ) -> bool {
        let of = |candidate: &Option<Candidate>| candidate.as_ref().map(|candidate| candidate.value);
        let known = [of(&self.tracked[k].least), of(&self.tracked[k].greatest)];
        let all = values.iter().copied().chain(known.into_iter().flatten());
        let (least, greatest) = all
            .fold([f64::INFINITY, f64::NEG_INFINITY].into(), |(least, greatest): (f64, f64), v| {
                (least.min(v), greatest.max(v))
            });
        let (range, largest) = (greatest - least, least.abs().max(greatest.abs()));
        let rounding = ROUNDING * (100.0 + piece.condition());
        let bound = (RESOLVED * range + rounding * largest).max(2.0 * self.tracked[k].noise);
        let noise = self.noise(k, piece, rows);
        // A corner between the last node and an end leaves no trace in the coefficients.
        let most_off = MISSED * bound.max(series.tail()).max(noise);
        let is_off =
            |(end, value): (f64, Option<f64>)| value.is_some_and(|value| (series.at(end) - value).abs() > most_off);
        if [-1.0, 1.0].into_iter().zip(at_ends).any(is_off) {
            return false;
        }
        if series.tail() <= bound {
            return true;
        }
        if lacked.is_finite() && series.tail() > SHRINKS * lacked && series.tail() <= noise {
            self.tracked[k].noise = series.tail();
            return true;
        }
        false
    }

    /// The rounding of a quantity over a piece, from those that it is computed with.
    pub(super) fn noise(&self, k: usize, piece: &Piece, rows: &[Vec<f64>]) -> f64 {
        let group = rows.iter().flat_map(|row| &row[self.group(k)]).fold(0.0f64, |most, value| most.max(value.abs()));
        NOISE * ROUNDING * (100.0 + piece.condition().powi(2)) * group
    }

    /// The quantities that one is computed from.
    fn group(&self, k: usize) -> Indices<usize> {
        let Layout { outputs, multipliers, forces, ratios, columns, .. } = &self.layout;
        let reactions = multipliers.start..forces.end;
        let all = [outputs, &reactions, ratios, columns];
        all.into_iter().find(|group| group.contains(&k)).cloned().unwrap_or(k..k + 1)
    }

    /// Removes quantities that grow without bound towards a singular place.
    fn drop_unbounded(&mut self, piece: &Piece, [from, to]: [f64; 2], open: &mut Pending) -> Result<(), Failure> {
        if open.is_empty() {
            return Ok(());
        }
        let within = from - BESIDE..=to + BESIDE;
        let singular = piece.crossings.iter().copied().chain(piece.limit).filter(|x| within.contains(x));
        for (singular, side) in singular.flat_map(|x| [(x, -1.0), (x, 1.0)]) {
            let places = TOWARDS.map(|distance| singular + side * distance);
            if places.iter().any(|x| !(-1.0..=1.0).contains(x)) || piece.limit.is_some_and(|limit| places[0] > limit) {
                continue;
            }
            let rows: Vec<Vec<f64>> = places.iter().map(|x| self.values_at(piece, *x)).collect::<Result<_, _>>()?;
            let sizes = |k: usize| [0, 1, 2].map(|row| rows[row][k].abs());
            open.iter().filter(|(k, _)| grows(sizes(*k))).for_each(|(k, _)| self.tracked[*k].has_no_bound = true);
        }
        open.retain(|(k, _)| !self.tracked[*k].has_no_bound);
        Ok(())
    }

    /// Keeps what is recorded at a place of a step where it is beyond all that was found: in a pulse between the nodes.
    pub(super) fn witness(&mut self, piece: &Rc<Piece>, within: [f64; 2], x: f64, motion: &AnyPrescribed) {
        let values = self.values(motion);
        for (k, value) in values.into_iter().enumerate().filter(|(_, value)| value.is_finite()) {
            let (Some(least), Some(greatest)) = (&self.tracked[k].least, &self.tracked[k].greatest) else { continue };
            let slack = WITNESSED * (greatest.value - least.value).max(value.abs());
            if value < least.value - slack || value > greatest.value + slack {
                self.offer(k, (piece, within), (value, x, WITNESS_REACH, Kind::Rough));
            }
        }
    }

    /// Keeps a value if it is better than the best so far; among equals, the first.
    fn offer(
        &mut self,
        k: usize,
        (piece, within): (&Rc<Piece>, [f64; 2]),
        (value, x, reach, kind): (f64, f64, f64, Kind),
    ) {
        let (path, tracked) = (self.path, &mut self.tracked[k]);
        let new = |is_repeated| Candidate { value, piece: piece.clone(), within, x, reach, kind, is_repeated };
        let (Some(least), Some(greatest)) = (&mut tracked.least, &mut tracked.greatest) else {
            (tracked.least, tracked.greatest) = (Some(new(false)), Some(new(false)));
            return;
        };
        let range = greatest.value - least.value;
        for (known, sign) in [(least, 1.0), (greatest, -1.0)] {
            let is_as_good = (value - known.value).abs() <= AS_GOOD * range;
            let is_repeated = is_as_good && (known.is_repeated || path.are_apart((piece, x), (&known.piece, known.x)));
            // If a turning point is as good as an end, within the error of polynomials, it is preferred.
            let beats = if kind == Kind::Turn && known.kind != kind { -BETTER } else { BETTER };
            if sign * value < sign * known.value - beats * range {
                *known = new(is_repeated);
            } else {
                known.is_repeated |= is_repeated;
            }
        }
    }

    /// The extremes found, located to rounding.
    pub(super) fn conclude(self) -> Found {
        let range = |k: usize| {
            let tracked = &self.tracked[k];
            let bounds = tracked.least.as_ref().zip(tracked.greatest.as_ref()).filter(|_| !tracked.has_no_bound);
            let (least, greatest) = bounds?;
            Some(Range { least: self.located(k, least, 1.0)?, greatest: self.located(k, greatest, -1.0)? })
        };
        let is_repeated = |tracked: &Tracked| {
            [&tracked.least, &tracked.greatest].into_iter().flatten().any(|candidate| candidate.is_repeated)
        };
        Found {
            ranges: (0..self.tracked.len()).map(range).collect(),
            is_repeated: self.tracked.iter().map(is_repeated).collect(),
            layout: self.layout.clone(),
            places: self.places,
        }
    }
}
