//! Least and greatest values along a sweep, located between its samples.

use super::driven::is_of_positions;
use super::inverse::AnyPrescribed;
use super::sweep::{Sweep, Swept};
use crate::failure::Failure;
use crate::root::{find_minimum, find_root};

/// A value, and where it is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Extreme {
    /// The value, in SI units.
    pub value: f64,
    /// The value of what is driven there, in SI units.
    pub at: f64,
}

/// The least and the greatest value of a quantity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Range {
    /// The least.
    pub least: Extreme,
    /// The greatest.
    pub greatest: Extreme,
}

impl Range {
    /// The one of larger magnitude.
    pub fn peak(&self) -> Extreme {
        if self.least.value.abs() > self.greatest.value.abs() { self.least } else { self.greatest }
    }

    /// From the least to the greatest: the stroke of a position.
    pub fn stroke(&self) -> f64 {
        self.greatest.value - self.least.value
    }
}

/// How a quantity divides a whole turn of the drive between its least and its greatest value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TimeRatio {
    /// The larger part over the smaller: the time ratio of a quick-return mechanism at constant speed.
    pub ratio: f64,
    /// The larger part, in radians.
    pub working: f64,
    /// The smaller part.
    pub returning: f64,
}

/// The extremes of everything along a sweep; `None` for what is not finite.
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
    /// For each output that is a function of positions, over a whole turn.
    pub time_ratios: Vec<Option<TimeRatio>>,
}

/// What a range is of.
#[derive(Clone, Copy)]
enum Watched {
    Output(usize),
    Multiplier(usize),
    Force(usize),
    /// dy/ds, of a rated output, by its place among these.
    Ratio(usize),
    /// |det [C_q; y_q]|.
    Determinant,
}

/// Finds them.
pub(super) fn find(swept: &Swept, sweep: &Sweep, transmission: &[f64]) -> Extremes {
    let description = swept.system.mechanism.description();
    let (outputs, constraints) = (0..description.outputs.len(), 0..description.constraints.len());
    let of = |watched: Watched| range(swept, watched);
    let ranges: Vec<_> = outputs.clone().map(|i| of(Watched::Output(i))).collect();
    let positions = positions(swept);
    let rated = |i: usize| description.rated_outputs.iter().position(|rated| *rated == i);
    let ratio = |i: usize| rated(i).filter(|_| positions[i]).and_then(|rate| of(Watched::Ratio(rate)));
    let turn = sweep.is_turn(description) && swept.failure.is_none();
    let time_ratio = |i: usize| ranges[i].filter(|_| positions[i] && turn).and_then(|range| divide(&range));
    // The index is the determinant in another scale, which any sample tells.
    let scale = swept.motion.iter().zip(transmission).find(|(motion, _)| motion.determinant != 0.0);
    let scale = scale.map_or(0.0, |(motion, index)| index / motion.determinant.abs());
    let scaled = |extreme: Extreme| Extreme { value: scale * extreme.value, ..extreme };
    Extremes {
        multipliers: constraints.map(|i| of(Watched::Multiplier(i))).collect(),
        forces: (0..swept.system.laws.len()).map(|k| of(Watched::Force(k))).collect(),
        transmission: of(Watched::Determinant)
            .map(|range| Range { least: scaled(range.least), greatest: scaled(range.greatest) }),
        ratios: outputs.clone().map(ratio).collect(),
        time_ratios: outputs.map(time_ratio).collect(),
        outputs: ranges,
    }
}

/// Which outputs are functions of positions.
fn positions(swept: &Swept) -> Vec<bool> {
    let mechanism = swept.system.mechanism;
    // A few places, in case one is special.
    let places: Vec<_> = swept.motion.iter().step_by(swept.motion.len().div_ceil(8).max(1)).collect();
    let is = |i: usize| places.iter().all(|motion| is_of_positions(mechanism, i, motion.time, &motion.positions));
    (0..mechanism.description().outputs.len()).map(is).collect()
}

/// The parts of a turn from the least value to the greatest and back.
fn divide(range: &Range) -> Option<TimeRatio> {
    let one = (range.greatest.at - range.least.at).abs();
    let other = std::f64::consts::TAU - one;
    let (working, returning) = (one.max(other), one.min(other));
    (range.stroke() > 0.0 && returning > 0.0).then(|| TimeRatio { ratio: working / returning, working, returning })
}

fn range(swept: &Swept, watched: Watched) -> Option<Range> {
    let values: Vec<f64> = swept.motion.iter().map(|motion| value(swept, watched, motion)).collect();
    if values.is_empty() || values.iter().any(|value| !value.is_finite()) {
        return None;
    }
    let least = locate(swept, watched, &values, 1.0);
    let greatest = locate(swept, watched, &values, -1.0);
    Some(Range { least, greatest })
}

/// The least value of `sign` times a quantity: around the sample that has it, by the root of its rate where a kernel
/// gives that, else by golden section.
fn locate(swept: &Swept, watched: Watched, values: &[f64], sign: f64) -> Extreme {
    let best = (0..values.len()).min_by(|a, b| (sign * values[*a]).total_cmp(&(sign * values[*b]))).unwrap_or(0);
    let place = |i: usize| swept.motion[i].time;
    let found = |value: f64, p: f64| Extreme { value, at: swept.system.laws[0].at(p) };
    let sampled = found(values[best], place(best));
    let (first, last) = (best.saturating_sub(1), (best + 1).min(values.len() - 1));
    let (from, length) = (place(first), place(last) - place(first));
    let at = |fraction: f64| {
        let p = from + fraction * length;
        swept.between(if p < place(best) { first } else { best }, p)
    };
    let turning = turning_place(swept, watched, first, last, &at);
    let refined = match turning {
        Some(fraction) => at(fraction).map(|motion| (fraction, value(swept, watched, &motion))),
        None => find_minimum(&mut |fraction| Ok(sign * value(swept, watched, &at(fraction)?)))
            .map(|(fraction, least)| (fraction, sign * least)),
    };
    match refined {
        Ok((fraction, value)) if sign * value <= sign * sampled.value || turning.is_some() => {
            found(value, from + fraction * length)
        }
        _ => sampled,
    }
}

/// Where the rate of an output changes its sign between two samples.
fn turning_place(
    swept: &Swept,
    watched: Watched,
    first: usize,
    last: usize,
    at: &dyn Fn(f64) -> Result<AnyPrescribed, Failure>,
) -> Option<f64> {
    let Watched::Output(output) = watched else { return None };
    let rated = swept.system.mechanism.description().rated_outputs.iter().position(|rated| *rated == output)?;
    let [before, after] = [first, last].map(|i| rate(swept, rated, &swept.motion[i]));
    let changes = before * after < 0.0;
    changes
        .then(|| {
            find_root(before, after, 1e-15, &mut |fraction| Ok::<f64, Failure>(rate(swept, rated, &at(fraction)?)))
        })?
        .ok()
}

fn rate(swept: &Swept, rated: usize, motion: &AnyPrescribed) -> f64 {
    swept.system.mechanism.output_rates(motion.at())[rated]
}

fn value(swept: &Swept, watched: Watched, motion: &AnyPrescribed) -> f64 {
    match watched {
        Watched::Output(i) => swept.system.mechanism.outputs(motion.at())[i],
        Watched::Multiplier(i) => motion.multipliers[i],
        Watched::Force(k) => motion.forces[k],
        Watched::Ratio(rated) => rate(swept, rated, motion) / swept.system.laws[0].rate,
        Watched::Determinant => motion.determinant.abs(),
    }
}
