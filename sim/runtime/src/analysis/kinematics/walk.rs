//! Steps along the curve, one after the other, over crossings and limit positions.

use super::crossing::{crossings, find_dip};
use super::path::{ACROSS, ALONG, Path, SMALLEST_STEP};
use super::piece::{Piece, Point};
use crate::state::failure::{Failure, What};

/// The longest step: a step of a crank is at most about a fiftieth of a turn.
const LONGEST_STEP: f64 = 0.25;
/// A step to the end of the curve need not be shorter.
const SHORT: f64 = 1e-3;
/// How far from the middle of a step another branch may cross: nodes are 0.13 of half a step away. For several
/// crossings their middle counts, if they lie so close together that most nodes are far from all of them.
const CENTRED: f64 = 0.02;
const TOGETHER: f64 = 0.5;
/// Half of the length of a step about a crossing, or a part of it, and the number of attempts to place it. It is as
/// long as possible: rounding is amplified by the square of the distance, and the motion is known from the ends of the
/// step.
const AROUND: f64 = 0.8;
const MOST_LAYINGS: usize = 4;
/// The amplification of rounding from which another branch may cross nearby.
const NEAR: f64 = 1e3;
/// The part of the tangent along p below which a limit position may be nearby.
const TURNING: f64 = 1e-3;

impl Path<'_> {
    /// The next step, of at most `length` in regular places; if another branch crosses, it does so in the middle.
    ///
    /// # Errors
    /// [`What::NotFollowed`] if no step is small enough.
    pub(super) fn next(&self, from: &Point, length: &mut f64) -> Result<Piece, Failure> {
        let (longest, to_the_end) = (length.min(LONGEST_STEP), self.to_the_end(from));
        let mut piece = self.followed(from, longest.min(to_the_end))?;
        // The motion beside a crossing is known from both sides of it, beyond the end too; and a limit position at the end is seen
        // from there.
        let is_nearby = piece.to.condition >= NEAR || piece.to.tangent[from.z.len() - 1] < TURNING;
        if to_the_end < longest && piece.crossings.is_empty() && is_nearby {
            piece = self.followed(from, longest).unwrap_or(piece);
        }
        *length = 1.5 * piece.length;
        Ok(self.with_limit_inside(self.with_limit(piece)))
    }

    /// A step whose limit position, if there is one, is not just after its beginning: what grows without bound towards it is seen
    /// from some way off.
    fn with_limit_inside(&self, piece: Piece) -> Piece {
        if !piece.limit.is_some_and(|x| x < 0.0) || !piece.crossings.is_empty() {
            return piece;
        }
        let base = self.behind(&piece.from, piece.length / 2.0);
        let placed = base.and_then(|base| self.step(&base, piece.length, ACROSS)).map(|placed| self.with_limit(placed));
        placed.filter(|placed| placed.limit.is_some()).unwrap_or(piece)
    }

    /// A step of at most this length, or one over a crossing.
    fn followed(&self, from: &Point, longest: f64) -> Result<Piece, Failure> {
        let mut tried = longest;
        while tried > SMALLEST_STEP {
            let Some(piece) = self.step(from, tried, ALONG) else {
                tried /= 2.0;
                continue;
            };
            let found = match find_dip(self, &piece) {
                Some(dip) if dip.is_crossing => self.across(from, tried * (1.0 + dip.x) / 2.0),
                Some(dip) if !dip.is_closed && dip.x <= 1.0 => None,
                _ => Some(piece),
            };
            if let Some(piece) = found {
                return Ok(piece);
            }
            tried /= 2.0;
        }
        let (q, p) = self.place(&from.z);
        let (mechanism, driven) = (self.system.mechanism, self.system.drive());
        Err(mechanism.failure(What::NotFollowed { driven }, self.system.time(p), &q))
    }

    /// A step with a crossing in its middle, or several near to each other, that is about so far ahead of a point, or one that
    /// ends well before it; `None` where the branch does not go straight on. It may begin before the point, never beyond it.
    fn across(&self, from: &Point, mut ahead: f64) -> Option<Piece> {
        let mut half = AROUND;
        while half > SMALLEST_STEP {
            if half < 0.9 * ahead {
                return self.step(from, ahead - half, ALONG);
            }
            // The prediction of a step is slightly off, so placing the middle takes a few trials.
            for _ in 0..MOST_LAYINGS {
                let around = half.max(ahead);
                let Some(mut piece) =
                    self.behind(from, around - ahead).and_then(|base| self.step(&base, 2.0 * around, ACROSS))
                else {
                    break;
                };
                let found = crossings(self, &piece);
                let (Some(first), Some(last)) = (found.first(), found.last()) else { break };
                let are_together = last.x - first.x <= TOGETHER;
                let middle = if are_together { (first.x + last.x) / 2.0 } else { first.x };
                let is_centred = middle.abs() <= CENTRED;
                let is_earlier_crossing = from.tangent.dot(&(&piece.to.z - &from.z)) < half / 2.0;
                if is_centred && are_together && !is_earlier_crossing {
                    piece.crossings = found.iter().map(|dip| dip.x).collect();
                    return found.iter().all(|dip| dip.is_closed).then_some(piece);
                }
                if is_centred || ahead + around * middle <= 0.0 {
                    break;
                }
                ahead += around * middle;
            }
            half /= 2.0;
        }
        None
    }

    /// The point of the curve at this distance behind another.
    fn behind(&self, point: &Point, distance: f64) -> Option<Point> {
        if distance <= SMALLEST_STEP {
            return Some(point.clone());
        }
        let back = Point { tangent: -&point.tangent, ..point.clone() };
        let found = self.step(&back, distance, ACROSS)?.to;
        Some(Point { tangent: -found.tangent, ..found })
    }

    /// The approximate distance to the end of the curve.
    fn to_the_end(&self, from: &Point) -> f64 {
        let n = from.z.len() - 1;
        let left = self.end / self.sizes.parameter - from.z[n];
        (1.02 * left / from.tangent[n]).max(SHORT)
    }

    /// A step with the limit position in it, if there is one.
    fn with_limit(&self, mut piece: Piece) -> Piece {
        let n = piece.from.z.len() - 1;
        let [before, after] = [&piece.from, &piece.to].map(|end| end.tangent[n]);
        // A turn at an end may be missed between the last node and that end.
        let at_an_end = (!(after > 0.0)).then_some(if before < after.abs() { -1.0 } else { 1.0 });
        let turn = piece.curve[n].turns().first().copied().or(at_an_end);
        piece.limit = turn.map(|turn| self.limit(&piece, turn));
        piece
    }

    /// A point of the curve some way before another, if branches may cross nearby: the motion beside a crossing is
    /// known from both sides of it.
    pub(super) fn before(&self, point: Point) -> Point {
        if point.condition < NEAR {
            return point;
        }
        let lengths = (0..8).map(|halvings| AROUND / f64::from(1 << halvings));
        lengths.into_iter().find_map(|length| self.behind(&point, length)).unwrap_or(point)
    }
}
