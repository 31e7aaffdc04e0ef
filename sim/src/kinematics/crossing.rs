//! Where other branches cross the one that is followed: where F_z loses rank, whatever its order.
//!
//! The sign of a determinant would miss a rank that falls by two. Beside a crossing the smallest singular value falls as the
//! distance to it; it is looked for on the curve's polynomial, which passes it smoothly.

use super::path::{Path, Piece};
use crate::root::find_minimum;
use std::convert::Infallible;

/// Where the rank is looked at, as places of a step: also beyond its end, so that none ends just before a crossing.
const LOOKS: [f64; 6] = [-1.0, -0.33, 0.33, 1.0, 1.3, 1.6];
/// What is worth a search, as a part of the largest there.
const LOW: f64 = 0.5;
/// A singular value this small beside its largest in the step is zero.
const ZERO: f64 = 1e-6;
/// How far equations without units may be open where the branch goes straight through a crossing. Where links differ by a part
/// of 1e-11 the curve bends away instead.
const OPEN: f64 = 1e-11;

/// A place where F_z comes near to a lower rank.
#[derive(Clone, Copy, Debug)]
pub(super) struct Dip {
    pub(super) x: f64,
    /// Whether the rank is lower there.
    pub(super) is_crossing: bool,
    /// Whether the equations hold there, as they do on a branch.
    pub(super) is_closed: bool,
}

/// The first dip of a step, if it has one.
pub(super) fn find_dip(path: &Path, piece: &Piece) -> Option<Dip> {
    let at = |x: f64| match x {
        -1.0 => piece.from.regularity,
        1.0 => piece.to.regularity,
        _ => path.regularity(piece, x),
    };
    let values = LOOKS.map(at);
    let largest = values[..4].iter().copied().fold(0.0, f64::max);
    let is_low = |i: &usize| values[*i] <= LOW * largest && values[*i] < values[*i - 1] && values[*i] <= values[*i + 1];
    let low = (1..LOOKS.len() - 1).find(is_low)?;
    let [from, to] = [LOOKS[low - 1], LOOKS[low + 1]];
    // Twice, as the first search ends at the root of rounding.
    let (x, _) = least(path, piece, [from, to]);
    let (x, value) = least(path, piece, [x - 1e-7, x + 1e-7]);
    Some(Dip { x, is_crossing: value <= ZERO * largest, is_closed: path.open(piece, x) <= OPEN })
}

fn least(path: &Path, piece: &Piece, [from, to]: [f64; 2]) -> (f64, f64) {
    let place = |s: f64| from + s * (to - from);
    let found = find_minimum(&mut |s| Ok::<f64, Infallible>(path.regularity(piece, place(s))));
    let Ok((s, value)) = found;
    (place(s), value)
}
