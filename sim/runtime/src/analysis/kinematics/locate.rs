//! The place of an extreme, to rounding.

use super::piece::Piece;
use super::range::Extreme;
use super::search::{Candidate, Kind, Search, grows};
use super::series::{Series, nodes};
use crate::numerics::root::{find_minimum, find_root};
use crate::state::failure::Failure;

/// The relative amount by which a value may be worse than its polynomial.
const CORNER: f64 = 1e-12;
/// Distances from a pole, in parts of the interval around it, and the factor by which a quantity grows from the first to the
/// place that is found by comparison, which is as close as comparison comes.
const TOWARDS: [f64; 5] = [1e-1, 1e-2, 1e-3, 1e-4, 1e-5];
const UNBOUNDED: f64 = 1e6;
/// Distances from a place, in half steps, over which a quantity must grow if it has no bound there. Its growth from one to the next goes
/// on undiminished, as that of a logarithm, but for this part; it is more than this part of the quantity; and it goes on at the place
/// itself, which is known far better, for so many distances more.
const DECADES: [f64; 5] = [1e-2, 1e-3, 1e-4, 1e-5, 1e-6];
const LASTS: f64 = 0.9;
const KNOWN: f64 = 1e-6;
const GOES_ON: f64 = 2.0;
/// A peak that is so many times as high as the ends of its step may be a pole between the nodes of its polynomial.
const HIGH: f64 = 1e4;

impl Search<'_> {
    /// A candidate at its place, the least of `sign` times the quantity; nothing at a pole.
    pub(super) fn located(&self, k: usize, candidate: &Candidate, sign: f64) -> Option<Extreme> {
        let turn = || self.root_of_rate(k, candidate).or_else(|| self.turn_around(k, candidate));
        let x = if candidate.kind == Kind::Turn { turn()? } else { candidate.x };
        let Some(found) = self.extreme_at(k, &candidate.piece, x) else {
            // In a limit position there is no motion; what is bounded there is known from the way to it.
            let (is_limit, p) = (candidate.piece.limit.is_some(), self.path.at(&candidate.piece, x).1);
            return is_limit
                .then(|| Extreme { value: candidate.value, at: self.path.system.laws[0].at(self.path.within(p)) });
        };
        // A quantity worse than its polynomial has a corner there.
        let is_worse = sign * (found.value - candidate.value) > CORNER * candidate.value.abs();
        if !is_worse && candidate.kind != Kind::Rough {
            return (!self.has_no_bound(k, candidate, sign, (x, found.value))).then_some(found);
        }
        let better = self.corner(k, candidate, sign).filter(|(_, better)| sign * better.value < sign * found.value);
        let (x, found) = better.unwrap_or((x, found));
        let is_pole = || {
            self.is_pole(k, candidate, (x, found.value))
                || self.is_growing(k, candidate, sign, self.summit(k, candidate, sign, x))
        };
        (!is_pole()).then_some(found)
    }

    /// Whether a quantity has no bound at an end of an interval, or about a peak that is high above the ends of its step.
    fn has_no_bound(&self, k: usize, candidate: &Candidate, sign: f64, (x, value): (f64, f64)) -> bool {
        if candidate.kind == Kind::End {
            return self.is_growing(k, candidate, sign, x);
        }
        let at = |x: f64| self.values_at(&candidate.piece, x).map_or(f64::INFINITY, |values| values[k].abs());
        let [begin, end] = candidate.within.map(at);
        value.abs() > HIGH * begin.min(end) && self.is_growing(k, candidate, sign, self.summit(k, candidate, sign, x))
    }

    /// The place about another where a quantity is farthest.
    fn summit(&self, k: usize, candidate: &Candidate, sign: f64, mut x: f64) -> f64 {
        let Candidate { piece, within, reach, .. } = candidate;
        for width in [1.0, 1.0, 1.0, 1e-3, 1e-6].map(|part| part * reach) {
            let [from, to] = [(x - width).max(within[0]), (x + width).min(within[1])];
            let place = |s: f64| from + s * (to - from);
            let value = |x: f64| Ok::<f64, Failure>(sign * self.values_at(piece, x)?[k]);
            x = find_minimum(&mut |s| value(place(s))).map_or(x, |(s, _)| place(s));
        }
        x
    }

    /// Whether the growth of a quantity towards a place goes on from one decade of the distance to the next, on either side, by more than
    /// rounding.
    fn is_growing(&self, k: usize, candidate: &Candidate, sign: f64, x: f64) -> bool {
        let Candidate { piece, within, .. } = candidate;
        let there = self.values_at(piece, x).map_or(f64::INFINITY, |values| values[k]);
        let grows = |side: f64| {
            let places = DECADES.map(|distance| x + side * distance);
            let is_inside = places.iter().all(|place| (within[0]..=within[1]).contains(place));
            let rows: Vec<Vec<f64>> = match is_inside {
                true => places.iter().map(|x| self.values_at(piece, *x).ok()).collect::<Option<_>>()?,
                false => return None,
            };
            let growth: Vec<f64> = rows.windows(2).map(|pair| sign * (pair[0][k] - pair[1][k])).collect();
            let is_known = growth[0] > (KNOWN * rows[0][k].abs()).max(self.noise(k, piece, &rows[..1]));
            let [.., last] = growth.as_slice() else { return None };
            let goes_on = !there.is_finite() || sign * (rows[DECADES.len() - 1][k] - there) >= GOES_ON * last;
            Some(is_known && goes_on && growth.windows(2).all(|pair| pair[1] >= LASTS * pair[0]))
        };
        [-1.0, 1.0].into_iter().filter_map(grows).any(|grows| grows)
    }

    /// Whether a quantity grows without bound towards a place at which it has this value, as tan(x) does towards a right angle.
    /// What is rounding grows too.
    fn is_pole(&self, k: usize, candidate: &Candidate, (x, value): (f64, f64)) -> bool {
        let values = |distance: f64| self.values_at(&candidate.piece, x + distance * candidate.reach).ok();
        let is_pole = |side: f64| {
            let rows: Vec<Vec<f64>> =
                TOWARDS.into_iter().map(|distance| values(side * distance)).collect::<Option<_>>()?;
            let size = |row: usize| rows[row][k].abs();
            let is_known = size(0) > self.noise(k, &candidate.piece, &rows[..1]);
            // What rises steeply may be smooth where it is highest.
            let grows = [0, 2].into_iter().all(|first| grows([size(first), size(first + 1), size(first + 2)]));
            Some(is_known && grows && value.abs() > UNBOUNDED * size(0))
        };
        [-1.0, 1.0].into_iter().filter_map(is_pole).any(|is_pole| is_pole)
    }

    fn extreme_at(&self, k: usize, piece: &Piece, x: f64) -> Option<Extreme> {
        let p = self.path.within(self.path.at(piece, x).1);
        let value = self.values(&self.path.motion(piece, x, p).ok()?)[k];
        value.is_finite().then(|| Extreme { value, at: self.path.system.laws[0].at(p) })
    }

    /// The extreme near a candidate by comparison alone, with its place.
    fn corner(&self, k: usize, candidate: &Candidate, sign: f64) -> Option<(f64, Extreme)> {
        let Candidate { piece, within, x, reach, .. } = candidate;
        let [from, to] = [(x - 0.3 * reach).max(within[0]), (x + 0.3 * reach).min(within[1])];
        let place = |s: f64| from + s * (to - from);
        let found = find_minimum(&mut |s| Ok::<f64, Failure>(sign * self.values_at(piece, place(s))?[k]));
        let x = place(found.ok()?.0);
        Some((x, self.extreme_at(k, piece, x)?))
    }

    /// The zero of the rate of an output that has one, next to a candidate.
    fn root_of_rate(&self, k: usize, candidate: &Candidate) -> Option<f64> {
        let rated = self.path.system.mechanism.description().rated_outputs.iter().position(|output| *output == k)?;
        let (system, width) = (self.path.system, 0.01 * candidate.reach);
        let place = |s: f64| (candidate.x + width * (2.0 * s - 1.0)).clamp(-1.0, 1.0);
        let rate = |s: f64| Ok::<f64, Failure>(self.path.motion_at(&candidate.piece, place(s))?.slopes(system)[rated]);
        let (before, after) = (rate(0.0).ok()?, rate(1.0).ok()?);
        (before * after < 0.0).then(|| find_root(before, after, 1e-15, &mut { rate }).ok().map(place))?
    }

    /// The turning point of a polynomial through nodes close around a candidate.
    fn turn_around(&self, k: usize, candidate: &Candidate) -> Option<f64> {
        let last = candidate.piece.limit.unwrap_or(1.0);
        let width = 0.5 * candidate.reach;
        let (from, to) = ((candidate.x - width).max(-1.0), (candidate.x + width).min(last));
        let place = |x: f64| from + (to - from) * (1.0 + x) / 2.0;
        let at = |node: f64| Some(self.values_at(&candidate.piece, place(node)).ok()?[k]);
        let values: Vec<f64> = nodes().into_iter().map(at).collect::<Option<_>>()?;
        let turns = Series::through(std::array::from_fn(|node| values[node])).turns();
        let off = |x: &f64| (place(*x) - candidate.x).abs();
        let nearest = turns.into_iter().min_by(|a, b| off(a).total_cmp(&off(b)));
        Some(nearest.map_or(candidate.x, place))
    }
}
