//! Poincaré sections: the states of a motion each time an event happens, and its period.

use crate::any::At;
use crate::assemble::Start;
use crate::events::{Crossing, Occurrence};
use crate::failure::Failure;
use crate::kinematics::Driven;
use crate::measures::Measures;
use crate::motion::Motion;
use crate::run::run;
use crate::settings::{Rows, Settings, StopAt};
use crate::trajectory::{Phase, State, Trajectory};
use sim_kernel::{Description, Mechanism};
use std::f64::consts::TAU;

/// A part of a motion's extent, within which two states are the same.
const SAME: f64 = 1e-6;

/// What is asked of a section.
#[derive(Clone, Copy, Debug)]
pub struct Sectioning {
    /// The event, by index.
    pub event: usize,
    /// In which direction its condition has to cross; any, if none is given.
    pub crossing: Option<Crossing>,
    /// After how many of its occurrences the motion ends.
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

/// How a motion repeats.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Period {
    /// Seconds from one return to the same state to the next, on average.
    pub seconds: f64,
    /// Crossings of the section until it returns: 1 for a simple cycle.
    pub crossings: usize,
}

/// Runs a mechanism until an event has happened so often, or until the end of its settings, and keeps the states where it
/// did: points of the return map (Guckenheimer and Holmes, Nonlinear Oscillations, 1983, sec. 1.5).
///
/// States are the same where coordinates, angles but for whole turns, and speeds agree to a millionth of their extent. A
/// periodic motion is told from three states on.
///
/// # Errors
/// If no start can be assembled, or no state sampled. What ends the motion on the way does not lose the states.
pub fn poincare<M: Mechanism>(
    mechanism: M,
    start: &Start<M>,
    section: &Sectioning,
    settings: &Settings,
) -> Result<Section<M>, Failure> {
    // Crossings in both directions alternate.
    let most = if section.crossing.is_some() { 2 * section.count } else { section.count };
    let stop = Some(StopAt { event: section.event, occurrence: most });
    let found = run(mechanism, start, &Settings { rows: Rows::Even(1), stop, ..*settings })?;
    let is_wanted = |event: &&Occurrence<M>| {
        event.event == section.event && section.crossing.is_none_or(|crossing| event.crossing == crossing)
    };
    let (mut samples, mut phases) = (Vec::new(), Vec::new());
    for event in found.events.iter().filter(is_wanted).take(section.count) {
        let phase = phase_before(&found.trajectory, &event.state);
        let mechanism = phase.map_or(mechanism, |phase| phase.mechanism);
        phases.extend(phase.map(|phase| Phase { first: samples.len(), ..*phase }));
        let measures = Measures::at(&mechanism, event.state.time, &event.state.positions);
        samples.push(Motion::new(&mechanism, settings.stabilisation, measures).sample(event.state)?);
    }
    let states: Vec<At<f64>> = samples.iter().map(At::sample).collect();
    Ok(Section {
        mechanism,
        period: period(const { &M::DESCRIPTION }, &states),
        trajectory: Trajectory { samples, phases, failure: found.trajectory.failure },
    })
}

/// The phase that an event ends or lies in.
fn phase_before<'t, M: Mechanism>(trajectory: &'t Trajectory<M>, state: &State<M>) -> Option<&'t Phase<M>> {
    let begins = |phase: &Phase<M>| trajectory.samples[phase.first].state.time;
    let later = trajectory.phases.partition_point(|phase| begins(phase) < state.time);
    trajectory.phases.get(later.saturating_sub(1))
}

/// The least number of crossings after which all states are the same again.
fn period(description: &'static Description, states: &[At<f64>]) -> Option<Period> {
    let extent = |value: &dyn Fn(&At<f64>) -> f64| states.iter().fold(0.0f64, |most, at| most.max(value(at).abs()));
    let n = description.coordinates.len();
    let is_angle = |j: &usize| Driven::Coordinate(*j).turn(description).is_some();
    let (angles, others): (Vec<usize>, Vec<usize>) = (0..n).partition(is_angle);
    let largest_speed = |of: &[usize]| of.iter().map(|j| extent(&|state| state.speeds[*j])).fold(0.0, f64::max);
    let largest_position = others.iter().map(|j| extent(&|state| state.positions[*j])).fold(0.0, f64::max);
    let (turning, moving) = (largest_speed(&angles), largest_speed(&others));
    let is_same = |a: &At<f64>, b: &At<f64>| {
        (0..n).all(|j| {
            let (apart, faster) = (b.positions[j] - a.positions[j], (b.speeds[j] - a.speeds[j]).abs());
            match is_angle(&j) {
                true => (apart - TAU * (apart / TAU).round()).abs() <= SAME && faster <= SAME * turning,
                false => apart.abs() <= SAME * largest_position && faster <= SAME * moving,
            }
        })
    };
    let repeats = |k: &usize| states.iter().zip(&states[*k..]).all(|(a, b)| is_same(a, b));
    let crossings = (1..states.len().div_ceil(2)).find(repeats)?;
    let returns = (states.len() - 1) / crossings;
    let seconds = (states[returns * crossings].time - states[0].time) / returns as f64;
    Some(Period { seconds, crossings })
}
