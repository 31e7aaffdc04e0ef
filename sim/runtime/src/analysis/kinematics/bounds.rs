//! Whether a quantity has a bound where it is greatest or least, or grows without end towards a pole.

use super::search::{Candidate, Kind, Search};
use crate::numerics::root::find_minimum;
use crate::state::failure::Failure;

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
    /// Whether a quantity has no bound at an extreme: at an end of an interval, where it is no polynomial, or about a peak that is high
    /// above the ends of its step.
    pub(super) fn has_no_bound(&self, k: usize, candidate: &Candidate, sign: f64, (x, value): (f64, f64)) -> bool {
        let at = |x: f64| self.values_at(&candidate.piece, x).map_or(f64::INFINITY, |values| values[k].abs());
        let is_high = || {
            let [begin, end] = candidate.within.map(at);
            value.abs() > HIGH * begin.min(end)
        };
        match candidate.kind {
            Kind::End => self.is_growing(k, candidate, sign, x),
            Kind::Turn if !is_high() => false,
            Kind::Turn | Kind::Rough => self.is_growing(k, candidate, sign, self.summit(k, candidate, sign, x)),
        }
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
}
