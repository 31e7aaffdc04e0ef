//! Poincaré sections: the states of a motion each time an event happens, and its period.

use crate::analysis::kinematics::Driven;
use crate::analysis::linearize::quaternions;
use crate::events::{Crossing, Occurrence};
use crate::model::At;
use crate::motion::Motion;
use crate::motion::measures::Measures;
use crate::run::run_while;
use crate::start::assemble::Start;
use crate::state::failure::Failure;
use crate::state::settings::{Rows, Settings, StopAt};
use crate::state::trajectory::{Phase, Sample, State, Trajectory};
use sim_kernel::{Array, Description, Mechanism};
use std::f64::consts::TAU;

/// The tolerance within which two states are the same, relative to the extent of each coordinate's own motion and to the
/// speeds that lead through it; and what the motion of a small one may be off by, relative to the largest of its kind.
const SAME: f64 = 1e-6;
const NOISE: f64 = 1e-9;
/// States that repeat after some crossings repeat so many times better than after fewer: otherwise they drift, or are known no better.
const BETTER: f64 = 100.0;

/// The specification of a section.
#[derive(Clone, Copy, Debug)]
pub struct Sectioning {
    /// The event, by index.
    pub event: usize,
    /// The direction in which its condition has to cross; any if none is given.
    pub crossing: Option<Crossing>,
    /// The number of occurrences after which the motion ends.
    pub count: usize,
}

/// The states in which a motion crosses a section.
#[derive(Clone, Debug)]
pub struct Section<M: Mechanism> {
    /// The mechanism with its parameters.
    pub mechanism: M,
    /// The states, with accelerations and reactions. It ends with a failure if the motion did.
    pub trajectory: Trajectory<M>,
    /// The period, if the states repeat.
    pub period: Option<Period>,
}

/// The period of a motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Period {
    /// Seconds from one return to the same state to the next, on average.
    pub seconds: f64,
    /// Crossings of the section until it returns: 1 for a simple cycle.
    pub crossings: usize,
}

/// Runs a mechanism until an event has happened this often, or until the end of its settings, and keeps the states at
/// the event: points of the return map (Guckenheimer and Holmes, Nonlinear Oscillations, 1983, sec. 1.5).
///
/// States are the same if coordinates (angles modulo whole turns) and speeds agree to a millionth. The millionth is
/// relative to 1 rad for angles, and for other coordinates to their largest value in the section, or to the distance
/// that their speeds cover between crossings; for speeds, to the largest in the section, or to those that cover this
/// distance in this time. So a period is found even in a section where the motion turns back, with speeds that are
/// rounding, and in one through the origin. Detecting a period takes at least three states.
///
/// A quaternion and its opposite are one attitude, with opposite rates; so each counts modulo its sign, unless a load or a
/// constraint on its entries takes the two for different ones, and the accelerations tell.
///
/// # Errors
/// If no start can be assembled, or no state sampled. A failure on the way does not lose the states.
pub fn poincare<M: Mechanism>(
    mechanism: M,
    start: &Start<M>,
    section: &Sectioning,
    settings: &Settings,
) -> Result<Section<M>, Failure> {
    poincare_while(mechanism, start, section, settings, &mut |_| true)
}

/// The same for as long as `goes_on` says so, as [`run_while`].
///
/// # Errors
/// As [`poincare`].
#[inline(never)]
pub fn poincare_while<M: Mechanism>(
    mechanism: M,
    start: &Start<M>,
    section: &Sectioning,
    settings: &Settings,
    goes_on: &mut dyn FnMut(f64) -> bool,
) -> Result<Section<M>, Failure> {
    // Crossings in both directions alternate.
    let most = if section.crossing.is_some() { 2 * section.count } else { section.count };
    let stop = Some(StopAt { event: section.event, occurrence: most });
    let settings = &Settings { rows: Rows::Even(1), stop, ..*settings };
    let found = run_while(mechanism.clone(), start, settings, goes_on)?;
    let is_wanted = |event: &&Occurrence<M>| {
        event.event == section.event && section.crossing.is_none_or(|crossing| event.crossing == crossing)
    };
    let (mut samples, mut phases) = (Vec::new(), Vec::new());
    let quaternions = quaternions(&mechanism);
    let mut unsigned = quaternions.clone();
    for event in found.events.iter().filter(is_wanted).take(section.count) {
        let phase = phase_before(&found.trajectory, &event.state);
        let mechanism = phase.map_or(&mechanism, |phase| &phase.mechanism);
        phases.extend(phase.map(|phase| Phase { first: samples.len(), ..phase.clone() }));
        let measures = Measures::at(mechanism, event.state.time, &event.state.positions);
        let motion = Motion::new(mechanism.clone(), settings.stabilisation, measures);
        let sample = motion.sample(event.state.clone())?;
        unsigned.retain(|four| is_sign_nothing(&motion, &sample, four));
        samples.push(sample);
    }
    let states: Vec<At<f64>> = samples.iter().map(At::sample).collect();
    let period = period(mechanism.description(), &quaternions, &unsigned, &states);
    Ok(Section { mechanism, period, trajectory: Trajectory { samples, phases, failure: found.trajectory.failure } })
}

/// The phase that an event ends or lies in.
fn phase_before<'t, M: Mechanism>(trajectory: &'t Trajectory<M>, state: &State<M>) -> Option<&'t Phase<M>> {
    let begins = |phase: &Phase<M>| trajectory.samples[phase.first].state.time;
    let later = trajectory.phases.partition_point(|phase| begins(phase) < state.time);
    trajectory.phases.get(later.saturating_sub(1))
}

/// Whether the mechanism accelerates alike from a state and from the one with the opposite of a quaternion.
fn is_sign_nothing<M: Mechanism>(motion: &Motion<M>, sample: &Sample<M>, four: &[usize; 4]) -> bool {
    let opposite = |values: &M::Q| values.like(|j| if four.contains(&j) { -values[j] } else { values[j] });
    let State { positions, speeds, .. } = &sample.state;
    let other = State { positions: opposite(positions), speeds: opposite(speeds), ..sample.state.clone() };
    let expected = opposite(&sample.accelerations);
    let expected = expected.as_ref();
    let largest = expected.iter().fold(0.0, |largest: f64, value| largest.max(value.abs()));
    motion.sample(other).is_ok_and(|other| {
        let mut pairs = other.accelerations.as_ref().iter().zip(expected);
        pairs.all(|(found, expected)| (found - expected).abs() <= NOISE * largest)
    })
}

/// The least number of crossings after which all states repeat; some quaternions count modulo their signs.
fn period(
    description: &'static Description,
    quaternions: &[[usize; 4]],
    unsigned: &[[usize; 4]],
    states: &[At<f64>],
) -> Option<Period> {
    let between = states.last()?.time - states.first()?.time;
    let usual = between / (states.len() - 1).max(1) as f64;
    let kinds = kinds(description, quaternions);
    let largest = |is_of: &dyn Fn(Kind) -> bool| Extent::of(states, usual, |j| is_of(kinds[j]));
    let turning = |kind: Kind| {
        let found = largest(&|other| other == kind);
        Extent { positions: 1.0, speeds: found.speeds.max(1.0 / usual) }
    };
    let (of_angles, of_quaternions) = (turning(Kind::Angle), turning(Kind::OfQuaternion));
    let of_others = largest(&|kind| kind != Kind::Angle);
    let own: Vec<Extent> = (0..kinds.len()).map(|j| Extent::of(states, usual, |i| i == j)).collect();
    let apart = |a: &At<f64>, b: &At<f64>| {
        let signs = signs(unsigned, a.positions, b.positions);
        let parts = kinds.iter().zip(&own).enumerate().map(|(j, (kind, own))| {
            let apart = b.positions[j] - signs[j] * a.positions[j];
            let faster = b.speeds[j] - signs[j] * a.speeds[j];
            match kind {
                Kind::Angle => {
                    let apart = apart - TAU * (apart / TAU).round();
                    own.within(&of_angles).parts(&of_angles, [apart, faster])
                }
                Kind::OfQuaternion => own.parts(&of_quaternions, [apart, faster]),
                Kind::Other => own.parts(&of_others, [apart, faster]),
            }
        });
        parts.fold(0.0, f64::max)
    };
    // What drifts is the same as the last time, but not as the first.
    let of_states = |k: usize| (k..states.len()).map(|i| apart(&states[i % k], &states[i])).fold(0.0, f64::max);
    let off = |k: usize| of_states(k).max(of_times(states, k));
    let (mut least, mut crossings) = (f64::INFINITY, 1..states.len().div_ceil(2));
    let crossings = crossings.find(|k| {
        let off = off(*k);
        let repeats = off <= 1.0 && off * BETTER <= least;
        least = least.min(off);
        repeats
    })?;
    let returns = (states.len() - 1) / crossings;
    let seconds = (states[returns * crossings].time - states[0].time) / returns as f64;
    Some(Period { seconds, crossings })
}

/// By how much the times differ that it takes from each state to the one so many crossings later, as parts of the tolerance: what a
/// load does that changes with time is no part of the states.
fn of_times(states: &[At<f64>], crossings: usize) -> f64 {
    let mut taken = states.iter().zip(&states[crossings..]).map(|(from, to)| to.time - from.time);
    let first = taken.next().unwrap_or_default();
    taken.map(|time| part(time - first, SAME * first)).fold(0.0, f64::max)
}

/// A difference as a part of a tolerance, which may be zero.
fn part(difference: f64, tolerance: f64) -> f64 {
    if difference == 0.0 { 0.0 } else { difference.abs() / tolerance }
}

/// What a coordinate is.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Kind {
    Angle,
    OfQuaternion,
    Other,
}

fn kinds(description: &'static Description, quaternions: &[[usize; 4]]) -> Vec<Kind> {
    let kind = |j: usize| match Driven::Coordinate(j).turn(description) {
        _ if quaternions.iter().any(|four| four.contains(&j)) => Kind::OfQuaternion,
        Some(_) => Kind::Angle,
        None => Kind::Other,
    };
    (0..description.coordinates.len()).map(kind).collect()
}

/// For each coordinate the sign that brings its quaternion from one position to the side of that at another, if its sign is
/// nothing.
fn signs(unsigned: &[[usize; 4]], a: &[f64], b: &[f64]) -> Vec<f64> {
    let mut signs = vec![1.0; a.len()];
    for four in unsigned {
        let inner: f64 = four.iter().map(|j| a[*j] * b[*j]).sum();
        four.iter().for_each(|j| signs[*j] = 1.0f64.copysign(inner));
    }
    signs
}

/// The extent and speed of coordinates of one kind.
struct Extent {
    positions: f64,
    speeds: f64,
}

impl Extent {
    /// In the section, and from one state of it to the next, which takes this long.
    fn of(states: &[At<f64>], between: f64, is_of_kind: impl Fn(usize) -> bool) -> Extent {
        let largest = |values: &[f64]| {
            let of_kind = values.iter().enumerate().filter(|(j, _)| is_of_kind(*j));
            of_kind.fold(0.0f64, |largest, (_, value)| largest.max(value.abs()))
        };
        let over = |values: &dyn Fn(&At<f64>) -> f64| states.iter().map(values).fold(0.0, f64::max);
        let (positions, speeds) = (over(&|at| largest(at.positions)), over(&|at| largest(at.speeds)));
        Extent { positions: positions.max(speeds * between), speeds: speeds.max(positions / between) }
    }

    /// No more than another: an angle may go round many times.
    fn within(&self, other: &Extent) -> Extent {
        Extent { positions: self.positions.min(other.positions), speeds: self.speeds.min(other.speeds) }
    }

    /// A difference of positions and one of speeds of a coordinate with this extent, beside what all of its kind have, as parts of
    /// what cannot tell states apart; the larger.
    fn parts(&self, kind: &Extent, [positions, speeds]: [f64; 2]) -> f64 {
        let of_positions = part(positions, SAME * self.positions + NOISE * kind.positions);
        of_positions.max(part(speeds, SAME * self.speeds + NOISE * kind.speeds))
    }
}
