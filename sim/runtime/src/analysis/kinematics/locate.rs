//! The place of an extreme, to rounding.

use super::piece::Piece;
use super::range::Extreme;
use super::search::{Candidate, Kind, Search};
use super::series::{Series, nodes};
use crate::numerics::root::{find_minimum, find_root};
use crate::state::failure::Failure;

/// The relative amount by which a value may be worse than its polynomial.
const CORNER: f64 = 1e-12;
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
        let better = match is_worse || candidate.kind == Kind::Rough {
            true => self.corner(k, candidate, sign).filter(|(_, better)| sign * better.value < sign * found.value),
            false => None,
        };
        let (x, found) = better.unwrap_or((x, found));
        (!self.has_no_bound(k, candidate, sign, (x, found.value))).then_some(found)
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
