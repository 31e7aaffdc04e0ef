//! Least and greatest values along a sweep.

use super::driven::{changes, is_of_positions};
use super::range::{Extreme, Range};
use super::search::Found;
use super::sweep::{Sweep, Swept};

/// The division of a whole turn of the drive between a quantity's least and greatest value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TimeRatio {
    /// The larger part over the smaller: the time ratio of a quick-return mechanism at constant speed.
    pub ratio: f64,
    /// The larger part, in radians.
    pub working: f64,
    /// The smaller part.
    pub returning: f64,
}

/// The extremes of all quantities along a sweep; `None` for those that are not finite everywhere, or that grow without
/// bound towards a pole, a limit position or a crossing.
#[derive(Clone, Debug, PartialEq)]
pub struct Extremes {
    /// Of each output.
    pub outputs: Vec<Option<Range>>,
    /// Of each multiplier.
    pub multipliers: Vec<Option<Range>>,
    /// Of the force of each drive and hold.
    pub forces: Vec<Option<Range>>,
    /// Of the transmission index.
    pub transmission: Option<Range>,
    /// For each output that is a function of positions and that the drive moves by more than rounding, dy/ds with s what is
    /// driven, at fixed time: the least magnitude of the mechanical advantage ds/dy is where this is greatest.
    pub ratios: Vec<Option<Range>>,
    /// Whether an output is such a function that the drive moves.
    pub is_rated: Vec<bool>,
    /// For each output that is a function of positions, over a whole turn after which it is where it was, if it has its least
    /// and its greatest value once in it.
    pub time_ratios: Vec<Option<TimeRatio>>,
}

/// Sorts what was found.
pub(super) fn extremes(swept: &Swept, sweep: &Sweep) -> Extremes {
    let description = swept.system.mechanism.description();
    let Found { layout, ranges, is_repeated, .. } = &swept.found;
    let of = |indices: &std::ops::Range<usize>| ranges[indices.clone()].to_vec();
    let outputs = of(&layout.outputs);
    let positions = positions(swept);
    let sizes: Vec<f64> = (0..outputs.len()).map(|i| size(swept, i, outputs[i].as_ref())).collect();
    let rated = |i: usize| description.rated_outputs.iter().position(|rated| *rated == i);
    let drive = swept.sizes.rows[swept.system.rows.len()];
    let ratio = |i: usize| {
        let ratio = ranges[layout.ratios.start + rated(i).filter(|_| positions[i])?];
        ratio.filter(|ratio| ratio.peak().value.abs() * drive > ROUNDING * sizes[i])
    };
    // One without bounds moves.
    let is_rated = |i: usize| {
        let known = rated(i).filter(|_| positions[i]).map(|rated| ranges[layout.ratios.start + rated].is_none());
        known.is_some_and(|has_no_bound| has_no_bound || ratio(i).is_some())
    };
    let turn = sweep.is_turn(description) && swept.failure.is_none();
    let of_turn = |range: &Range, i: usize| {
        turn && positions[i] && range.stroke() > ROUNDING * sizes[i] && !is_repeated[i] && returns(swept, i, range)
    };
    let time_ratio = |i: usize| outputs[i].filter(|range| of_turn(range, i)).and_then(|range| divide(&range));
    let largest = swept.found.largest_columns();
    let scaled = |extreme: Extreme| Extreme { value: (extreme.value.max(0.0).ln() - largest).exp(), ..extreme };
    let transmission = |range: Range| Range { least: scaled(range.least), greatest: scaled(range.greatest) };
    Extremes {
        multipliers: of(&layout.multipliers),
        forces: of(&layout.forces),
        transmission: ranges[layout.volume].map(transmission),
        ratios: (0..outputs.len()).map(ratio).collect(),
        is_rated: (0..outputs.len()).map(is_rated).collect(),
        time_ratios: (0..outputs.len()).map(time_ratio).collect(),
        outputs,
    }
}

impl Found {
    /// The logarithm of the product of the largest length of each column, which neither overflows nor underflows.
    pub(super) fn largest_columns(&self) -> f64 {
        let longest = |range: &Option<Range>| range.map_or(f64::NAN, |range| range.greatest.value.ln());
        self.ranges[self.layout.columns.clone()].iter().map(longest).sum()
    }
}

/// Which outputs are functions of positions, tested at several places in case one is special.
fn positions(swept: &Swept) -> Vec<bool> {
    let mechanism = swept.system.mechanism;
    let is = |i: usize| swept.found.places.iter().all(|(time, q)| is_of_positions(mechanism, i, *time, q));
    (0..mechanism.description().outputs.len()).map(is).collect()
}

/// What is this small beside the size of an output is rounding, and an output is where it was to this part of its stroke.
const ROUNDING: f64 = 1e-10;
const RETURNED: f64 = 1e-6;

/// The size of an output: its largest magnitude, or that of its changes with single coordinates, of which it may be a small
/// difference.
fn size(swept: &Swept, output: usize, range: Option<&Range>) -> f64 {
    let changes_at = |(time, q): &(f64, Vec<f64>)| -> f64 {
        let changes = changes(swept.system.mechanism, output, *time, q);
        changes.iter().zip(&swept.sizes.coordinates).map(|(change, size)| (change * size).abs()).sum()
    };
    let magnitude = range.map_or(0.0, |range| range.peak().value.abs());
    swept.found.places.iter().map(changes_at).fold(magnitude, f64::max)
}

/// Whether an output is in the end where it began: after a turn of a geared drive it may not be.
fn returns(swept: &Swept, output: usize, range: &Range) -> bool {
    let (Some(first), Some(last)) = (swept.motion.first(), swept.motion.last()) else { return false };
    let [begin, end] = [first, last].map(|motion| swept.system.mechanism.outputs(motion.at())[output]);
    (end - begin).abs() <= RETURNED * range.stroke()
}

/// A smaller part of a turn than this, in radians, is that between both sides of a jump, as of an angle that wraps.
const LEAST_PART: f64 = 1e-6;

/// The parts of a turn from the least value to the greatest and back.
fn divide(range: &Range) -> Option<TimeRatio> {
    let one = (range.greatest.at - range.least.at).abs();
    let other = std::f64::consts::TAU - one;
    let (working, returning) = (one.max(other), one.min(other));
    (range.stroke() > 0.0 && returning > LEAST_PART).then(|| TimeRatio {
        ratio: working / returning,
        working,
        returning,
    })
}
