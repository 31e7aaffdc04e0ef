//! Where other branches cross the one that is followed: where F_z loses rank, whatever its order.
//!
//! The sign of a determinant would miss a rank that falls by two. Near a crossing the smallest singular value is
//! proportional to the distance, so crossings are seen from afar. They are located on the curve's polynomial, which
//! passes them smoothly.
//!
//! A step is placed with the crossing in its middle, far from all nodes, and as long as possible, because rounding
//! falls with the square of the distance. Crossings that lie together share a step, and no step ends beside one. The
//! branch goes straight on if the equations hold in the crossing on the polynomial. Where they do not, the curve bends
//! there and is followed in smaller steps.

use super::path::Path;
use super::piece::Piece;
use crate::numerics::root::find_minimum;
use std::convert::Infallible;

/// The number of places at which the rank is checked, the first one, and their distance in half steps. They extend
/// beyond the end of a step, so that none ends just before a crossing, and before its beginning, so that a crossing
/// just after it has neighbours.
const LOOKS: usize = 16;
const FIRST: f64 = -1.4;
const APART: f64 = 0.2;
/// A dip worth a search, as a fraction of its neighbours.
const LOW: f64 = 0.5;
/// A singular value this small relative to its largest in the step is zero.
const ZERO: f64 = 1e-6;
/// Crossings nearer to each other than this, in half steps, are one.
const SAME: f64 = 1e-6;
/// The distance from the middle of a step up to which crossings are near it.
const NEAR: f64 = 1.5;
/// The largest number of distinct crossings in a step.
const MOST_CROSSINGS: usize = 6;
/// The largest dimensionless residual with which the branch goes straight through a crossing. If links differ by a
/// fraction of 1e-11 the curve bends away instead.
const OPEN: f64 = 1e-11;

/// A place where F_z is close to a lower rank.
#[derive(Clone, Copy, Debug)]
pub(super) struct Dip {
    pub(super) x: f64,
    /// Whether the rank is lower there.
    pub(super) is_crossing: bool,
    /// Whether the equations hold there, as they do on a branch.
    pub(super) is_closed: bool,
}

/// The first crossing in a step or beyond its end, or the first dip where the equations do not hold.
pub(super) fn find_dip(path: &Path, piece: &Piece) -> Option<Dip> {
    dips(path, piece, &|x| path.volume(piece, x)).find(|dip| dip.x >= -1.0 && (dip.is_crossing || !dip.is_closed))
}

/// All crossings in a step or near its ends, in order, however close to each other: known ones are divided out.
pub(super) fn crossings(path: &Path, piece: &Piece) -> Vec<Dip> {
    let mut known: Vec<Dip> = Vec::new();
    for _ in 0..MOST_CROSSINGS {
        let without =
            |x: f64| path.volume(piece, x) - known.iter().map(|dip| (x - dip.x).abs().max(SAME).ln()).sum::<f64>();
        let is_new = |dip: &Dip| {
            dip.is_crossing && dip.x.abs() <= NEAR && known.iter().all(|other| (dip.x - other.x).abs() > SAME)
        };
        let Some(dip) = dips(path, piece, &without).find(is_new) else { break };
        known.push(dip);
    }
    known.sort_by(|a, b| a.x.total_cmp(&b.x));
    known
}

/// The dips of a step, in order. They are located by the logarithm of the product of all singular values: beside a
/// branch that only comes near, the smallest singular value is small throughout.
fn dips<'p>(path: &'p Path, piece: &'p Piece, volume: &'p dyn Fn(f64) -> f64) -> impl Iterator<Item = Dip> + 'p {
    let place = |i: usize| FIRST + APART * i as f64;
    let logarithms: [f64; LOOKS] = std::array::from_fn(|i| volume(place(i)));
    let largest = logarithms.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let values = logarithms.map(|volume| (volume - largest).exp());
    let is_low = move |i: &usize| {
        let [before, here, after] = [values[i - 1], values[*i], values[i + 1]];
        here < before && here <= after && here <= LOW * before.max(after)
    };
    let dip = move |i: usize| {
        let (x, _) = least([place(i - 1), place(i + 1)], &|x| (volume(x) - largest).exp());
        // Twice, as the first search ends at the root of rounding.
        let (x, value) = least([x - 1e-7, x + 1e-7], &|x| path.regularity(piece, x));
        let regular = piece.from.regularity.max(piece.to.regularity);
        Dip { x, is_crossing: value <= ZERO * regular, is_closed: path.open(piece, x) <= OPEN }
    };
    (1..LOOKS - 1).filter(is_low).map(dip)
}

fn least([from, to]: [f64; 2], of: &dyn Fn(f64) -> f64) -> (f64, f64) {
    let place = |s: f64| from + s * (to - from);
    let Ok((s, value)) = find_minimum(&mut |s| Ok::<f64, Infallible>(of(place(s))));
    (place(s), value)
}
