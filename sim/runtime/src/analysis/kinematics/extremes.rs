//! Least and greatest values along a sweep.

use super::driven::{changes, is_of_positions};
use super::range::{Extreme, Range};
use super::search::Found;
use super::sweep::{Sweep, Swept};
use crate::motion::lengths::measure;

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
    /// For each output that is a function of positions, dy/ds with s what is driven: the least magnitude of the
    /// mechanical advantage ds/dy is where this is greatest.
    pub ratios: Vec<Option<Range>>,
    /// For each output that is a function of positions, over a whole turn after which it is where it was.
    pub time_ratios: Vec<Option<TimeRatio>>,
}

/// Sorts what was found.
pub(super) fn extremes(swept: &Swept, sweep: &Sweep) -> Extremes {
    let description = swept.system.mechanism.description();
    let Found { layout, ranges, .. } = &swept.found;
    let of = |indices: &std::ops::Range<usize>| ranges[indices.clone()].to_vec();
    let outputs = of(&layout.outputs);
    let positions = positions(swept);
    let rated = |i: usize| description.rated_outputs.iter().position(|rated| *rated == i);
    let ratio = |i: usize| rated(i).filter(|_| positions[i]).and_then(|rate| ranges[layout.ratios.start + rate]);
    let turn = sweep.is_turn(description) && swept.failure.is_none();
    let of_turn =
        |i: usize| outputs[i].filter(|range| positions[i] && turn && moves_and_returns(swept, i, range.stroke()));
    let time_ratio = |i: usize| of_turn(i).and_then(|range| divide(&range));
    let largest = swept.found.largest_columns();
    let scaled = |extreme: Extreme| Extreme { value: (extreme.value.max(0.0).ln() - largest).exp(), ..extreme };
    let transmission = |range: Range| Range { least: scaled(range.least), greatest: scaled(range.greatest) };
    Extremes {
        multipliers: of(&layout.multipliers),
        forces: of(&layout.forces),
        transmission: ranges[layout.volume].map(transmission),
        ratios: (0..outputs.len()).map(ratio).collect(),
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

/// A smaller stroke than this part of an output's changes with single coordinates is rounding, and an output is where it was to
/// this part of its stroke.
const LEAST_STROKE: f64 = 1e-10;
const RETURNED: f64 = 1e-6;

/// Whether an output moves, and is in the end where it began: after a turn of a geared drive it may not be.
fn moves_and_returns(swept: &Swept, output: usize, stroke: f64) -> bool {
    let mechanism = swept.system.mechanism;
    let size = |(time, q): &(f64, Vec<f64>)| -> f64 {
        let (coordinates, _) = measure(mechanism, *time, q);
        changes(mechanism, output, *time, q).iter().zip(coordinates).map(|(change, size)| (change * size).abs()).sum()
    };
    let size = swept.found.places.iter().map(size).fold(0.0, f64::max);
    let (Some(first), Some(last)) = (swept.motion.first(), swept.motion.last()) else { return false };
    let [begin, end] = [first, last].map(|motion| mechanism.outputs(motion.at())[output]);
    stroke > LEAST_STROKE * size && (end - begin).abs() <= RETURNED * stroke
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
