//! A whole run: a simulation that is recorded, and its balance.

mod apart;
mod attempt;
mod change;
mod control;
mod save;
mod simulation;
mod unresolved;

pub use apart::{Apart, run_compared};
pub(crate) use attempt::Attempted;
pub use control::Controller;
pub use save::NotRestored;
pub use simulation::Simulation;
pub use unresolved::Unresolved;

use crate::events::Occurrence;
use crate::integrate::Steps;
use crate::motion::measured::mobility;
use crate::motion::measures::Measures;
use crate::motion::mobility::Mobility;
use crate::motion::residuals::residuals;
use crate::record::{DeadPoint, Recorder};
use crate::start::assemble::Start;
use crate::state::failure::{Failure, What};
use crate::state::settings::{Settings, Stepping};
use crate::state::trajectory::{State, Trajectory};
use control::Control;
use sim_kernel::{Array, Mechanism};
use std::time::{Duration, Instant};

/// Relative change of energy from which a result deserves doubt.
pub const DOUBTFUL_BALANCE: f64 = 1e-3;

/// A mechanism is at rest with speeds of this part of its scales in a second, and with moves of this part: what energy rounding
/// gives it is not compared with itself.
const AT_REST: f64 = 1e-7;

/// Changes of energy are compared with this part of the kinetic energy at least, and with so many times that of the tolerance, which is
/// relative to the speeds that are there.
const STEADY: f64 = 1e-6;
const TOLERANCES: f64 = 1e5;

/// The results of a run.
#[derive(Clone, Debug)]
pub struct Run<M: Mechanism> {
    /// The mechanism with its parameters.
    pub mechanism: M,
    /// Its settings.
    pub settings: Settings,
    /// The motion, as far as it came.
    pub trajectory: Trajectory<M>,
    /// Events along it.
    pub events: Vec<Occurrence<M>>,
    /// Dead points along it: see [`crate::dead_points`].
    pub dead_points: Vec<DeadPoint<M>>,
    /// Degrees of freedom and dependent constraints at the start.
    pub mobility: Mobility,
    /// When events have made constraints redundant that were not at the start; each set of constraints once.
    pub redundant_later: Vec<(f64, Mobility)>,
    /// The number of steps made.
    pub steps: Steps,
    /// The number of evaluations of the right-hand side, for steps, dense output and records.
    pub evaluations: u64,
    /// The largest |C_i| of any sample.
    pub position_residual: f64,
    /// The largest |(C_q q' + C_t)_i| of any sample.
    pub velocity_residual: f64,
    /// The largest change of kinetic energy minus work, apart from losses at events, relative to the largest kinetic
    /// energy of any sample or work of any step.
    pub energy_balance: f64,
    /// The same relative to what changes: the largest change of kinetic energy or work, or a small part of the kinetic energy. A
    /// wheel that turns steadily does not hide what is wrong beside it.
    pub energy_balance_of_changes: f64,
    /// The kinetic energy that events have taken, in joules.
    pub energy_taken: f64,
    /// The tolerance of the run that [`run_compared`] has compared it with.
    pub compared: Option<f64>,
    /// Where it is off beside that run.
    pub apart: Option<Apart>,
    /// The time of the integration, with events and records.
    pub integration_time: Duration,
}

impl<M: Mechanism> Run<M> {
    /// The period of the motion: when the event called `period` first happens.
    pub fn period(&self) -> Option<f64> {
        self.events.iter().find(|event| event.name == "period").map(|event| event.state.time)
    }
}

/// The dead points along a run of the coordinates whose values the declaration gives at the start, as many as there are
/// degrees of freedom: where det C_qd changes its sign, with C_qd the columns of the constraint Jacobian of all other
/// coordinates. None are found if the declaration gives fewer, or if constraints hold between speeds, keep the norm of
/// a quaternion (whose components may change sign at any time), or are switched by events; nor where C_q itself loses
/// rank: such a position is singular, and the motion passes it on its own branch. With several degrees of freedom they
/// are searched with at most 12 constraints.
pub fn dead_points<M: Mechanism>(run: &Run<M>) -> Vec<DeadPoint<M>> {
    run.dead_points.clone()
}

/// Runs a mechanism from a start.
///
/// # Errors
/// If no start can be assembled, or it is singular. A failure on the way does not lose the run; the trajectory contains
/// it.
pub fn run<M: Mechanism>(mechanism: M, start: &Start<M>, settings: &Settings) -> Result<Run<M>, Failure> {
    run_while(mechanism, start, settings, &mut |_| true)
}

/// The same for as long as `goes_on` says so, which is asked after each step, with the time that is reached. A run that
/// it ends has the failure [`What::Interrupted`].
///
/// # Errors
/// As [`run`].
#[inline(never)]
pub fn run_while<M: Mechanism>(
    mechanism: M,
    start: &Start<M>,
    settings: &Settings,
    goes_on: &mut dyn FnMut(f64) -> bool,
) -> Result<Run<M>, Failure> {
    run_with(mechanism, start, settings, None, goes_on)
}

/// Runs a mechanism whose inputs a controller sets.
///
/// # Errors
/// As [`run`].
pub fn run_controlled<M: Mechanism>(
    mechanism: M,
    start: &Start<M>,
    settings: &Settings,
    controller: &mut Controller<M>,
) -> Result<Run<M>, Failure> {
    run_with(mechanism, start, settings, Some(controller), &mut |_| true)
}

fn run_with<M: Mechanism>(
    mechanism: M,
    start: &Start<M>,
    settings: &Settings,
    controller: Option<&mut Controller<M>>,
    goes_on: &mut dyn FnMut(f64) -> bool,
) -> Result<Run<M>, Failure> {
    let mut simulation = Simulation::new(mechanism.clone(), start, settings)?;
    let first = simulation.state().clone();
    let mobility = simulation.mobility().clone();
    let mut recorder = Recorder::new(settings, first.time);
    recorder.make_room().map_err(|what| Failure::at(&mechanism, what, first.time, &first.positions))?;
    recorder.seek_dead_points(&mechanism, &first, &mobility);
    let clock = Instant::now();
    let ended = record(&mut simulation, settings.end, Control::new(controller, first.time), &mut recorder, goes_on);
    recorder.finish();
    let dead_points = recorder.dead_points();
    let integration_time = clock.elapsed();
    let trajectory = Trajectory { samples: recorder.samples, phases: recorder.phases, failure: ended.err() };
    let (position_residual, velocity_residual) = largest_residuals(&mechanism, &trajectory);
    let rounding = energy_at_rest(&mechanism, &first, simulation.measures());
    let [energy_balance, energy_balance_of_changes] =
        energy_balances(&mechanism, &trajectory, [recorder.largest_work.max(rounding), steady_part(settings)]);
    let (energy_taken, evaluations) = (simulation.energy_taken(), simulation.evaluations());
    let (events, steps) = simulation.conclude();
    let redundant_later = redundant_later(&mechanism, &trajectory, &mobility);
    Ok(Run {
        mechanism,
        settings: *settings,
        trajectory,
        events,
        dead_points,
        redundant_later,
        mobility,
        steps,
        evaluations,
        position_residual,
        velocity_residual,
        energy_balance,
        energy_balance_of_changes,
        energy_taken,
        compared: None,
        apart: None,
        integration_time,
    })
}

/// Advances a motion to its end, from one period of the controller to the next.
fn record<M: Mechanism>(
    simulation: &mut Simulation<M>,
    end: f64,
    mut control: Control<M>,
    recorder: &mut Recorder<M>,
    goes_on: &mut dyn FnMut(f64) -> bool,
) -> Result<(), Failure> {
    loop {
        control.ask(simulation)?;
        let has_moved = simulation.advance(control.holds_until(end), recorder)?;
        if !has_moved && simulation.has_ended() {
            return Ok(());
        }
        let State { time, positions, .. } = simulation.state();
        if !goes_on(*time) {
            return Err(Failure::at(simulation.mechanism(), What::Interrupted, *time, positions));
        }
    }
}

/// As [`Run::redundant_later`].
fn redundant_later<M: Mechanism>(mechanism: &M, trajectory: &Trajectory<M>, first: &Mobility) -> Vec<(f64, Mobility)> {
    let (mut seen, mut found) = (vec![mechanism.activities().as_ref().to_vec()], Vec::new());
    for phase in &trajectory.phases {
        let (active, sample) = (phase.mechanism.activities().as_ref().to_vec(), trajectory.samples.get(phase.first));
        let Some(sample) = sample.filter(|_| !seen.contains(&active)) else { continue };
        seen.push(active);
        let here = mobility(&phase.mechanism, sample.state.time, &sample.state.positions);
        if !here.dependent.is_empty() && here.dependent != first.dependent {
            found.push((sample.state.time, here));
        }
    }
    found
}

fn largest_residuals<M: Mechanism>(mechanism: &M, trajectory: &Trajectory<M>) -> (f64, f64) {
    trajectory.with_mechanisms(mechanism).fold((0.0, 0.0), |(position, velocity), (mechanism, sample)| {
        let (p, v) = residuals(&mechanism, &sample.state);
        (larger(position, p), larger(velocity, v))
    })
}

/// The energy of a mechanism at rest: that of its speeds, and the work of its loads.
fn energy_at_rest<M: Mechanism>(mechanism: &M, start: &State<M>, measures: &Measures<M>) -> f64 {
    let State { time, positions, speeds, .. } = start;
    let scales = measures.coordinates();
    let forces = mechanism.generalized_forces(*time, positions, speeds);
    let work: f64 = forces.iter().zip(scales.iter()).map(|(force, scale)| (force * scale).abs()).sum();
    let kinetic = mechanism.kinetic_energy(*time, positions, &scales.apply(|scale| AT_REST * *scale));
    kinetic + AT_REST * work
}

/// The part of the kinetic energy that counts as a change.
fn steady_part(settings: &Settings) -> f64 {
    match settings.stepping {
        Stepping::Equal(_) => STEADY,
        Stepping::Adaptive(tolerance) => STEADY.max(TOLERANCES * tolerance.relative),
    }
}

/// Both balances of energy. `least` is the largest work between samples, as a mechanism may be at rest in all of them, or what
/// kinetic energy is rounding.
fn energy_balances<M: Mechanism>(mechanism: &M, trajectory: &Trajectory<M>, [least, steady]: [f64; 2]) -> [f64; 2] {
    let (mut change, mut largest, mut moved, mut start) = (0.0f64, least, least, None);
    for (index, (mechanism, sample)) in trajectory.with_mechanisms(mechanism).enumerate() {
        let state = &sample.state;
        let kinetic = mechanism.kinetic_energy(state.time, &state.positions, &state.speeds);
        let taken = trajectory.phase_of(index).map_or(0.0, |phase| phase.energy_taken);
        let balance = kinetic - state.work + taken;
        let (begun, at_first) = *start.get_or_insert((balance, kinetic));
        largest = larger(larger(largest, kinetic), state.work.abs());
        moved = larger(larger(moved, (kinetic - at_first).abs()), state.work.abs());
        change = larger(change, (balance - begun).abs());
    }
    [largest, moved.max(steady * largest)].map(|size| if size == 0.0 { 0.0 } else { change / size })
}

/// The larger of two numbers; NaN, which `f64::max` would drop, stays.
fn larger(a: f64, b: f64) -> f64 {
    if a.is_nan() || a > b { a } else { b }
}
