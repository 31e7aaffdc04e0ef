//! A whole run: assemble, integrate, locate events, record, balance.

use crate::assemble::{Start, assemble};
use crate::control::{Control, Controller};
use crate::equations::residuals;
use crate::events::Occurrence;
use crate::failure::Failure;
use crate::inertia::check_inertias;
use crate::integrate::{
    Advance, Course, DOPRI5, Dop853, EULER, ExplicitRungeKutta, HEUN, RK3, RK4, Radau5, Steps, first_sample, integrate,
};
use crate::measures::Measures;
use crate::mobility::{Mobility, check_masses, mobility};
use crate::motion::Motion;
use crate::record::{DeadPoint, Recorder};
use crate::settings::{Method, Settings};
use crate::trajectory::{Sample, State, Trajectory};
use sim_kernel::Mechanism;
use std::sync::atomic::Ordering;
use std::time::{Duration, Instant};

/// Relative change of energy from which a result deserves doubt.
pub const DOUBTFUL_BALANCE: f64 = 1e-3;

/// What a run found.
#[derive(Clone, Debug)]
pub struct Run<M: Mechanism> {
    /// The mechanism with its parameters.
    pub mechanism: M,
    /// How it was run.
    pub settings: Settings,
    /// The motion, as far as it came.
    pub trajectory: Trajectory<M>,
    /// Events along it.
    pub events: Vec<Occurrence<M>>,
    /// Dead points along it: see [`crate::dead_points`].
    pub dead_points: Vec<DeadPoint<M>>,
    /// Degrees of freedom and dependent constraints at the start.
    pub mobility: Mobility,
    /// How many steps were made.
    pub steps: Steps,
    /// How many right-hand sides were evaluated, for steps, dense output and records.
    pub evaluations: u64,
    /// The largest |C_i| of any sample.
    pub position_residual: f64,
    /// The largest |(C_q q' + C_t)_i| of any sample.
    pub velocity_residual: f64,
    /// The largest change of kinetic energy minus work, what events take apart, relative to the largest kinetic energy of any
    /// sample or work of any step.
    pub energy_balance: f64,
    /// The kinetic energy that events have taken, in joules.
    pub energy_taken: f64,
    /// How long the integration took, with events and records.
    pub integration_time: Duration,
}

impl<M: Mechanism> Run<M> {
    /// The period of the motion: when the event called `period` first happens.
    pub fn period(&self) -> Option<f64> {
        self.events.iter().find(|event| event.name == "period").map(|event| event.state.time)
    }
}

/// Runs a mechanism from a start.
///
/// # Errors
/// If no start can be assembled, or it is singular. A failure on the way does not lose the run: it stands in its trajectory.
pub fn run<M: Mechanism>(mechanism: M, start: &Start<M>, settings: &Settings) -> Result<Run<M>, Failure> {
    run_with(mechanism, start, settings, None)
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
    run_with(mechanism, start, settings, Some(controller))
}

fn run_with<M: Mechanism>(
    mechanism: M,
    start: &Start<M>,
    settings: &Settings,
    controller: Option<&mut Controller<M>>,
) -> Result<Run<M>, Failure> {
    let first = assemble(&mechanism, start)?;
    check_masses(&mechanism, first.time, &first.positions)?;
    check_inertias(&mechanism, first.time, &first.positions)?;
    let mobility = mobility(&mechanism, first.time, &first.positions);
    mobility.check_regular::<M>(first.time, &first.positions)?;
    let mut recorder = Recorder::new(settings, first.time);
    recorder.make_room().map_err(|what| Failure::at::<M>(what, first.time, &first.positions))?;
    recorder.seek_dead_points(&mechanism, &first, &mobility);
    let (mut steps, mut evaluations) = (Steps::default(), 0);
    let clock = Instant::now();
    let control = Control::new(controller, first.time);
    let ended = run_phases(mechanism, first, settings, control, &mut recorder, &mut steps, &mut evaluations);
    recorder.finish();
    let dead_points = recorder.dead_points();
    let integration_time = clock.elapsed();
    let trajectory = Trajectory { samples: recorder.samples, phases: recorder.phases, failure: ended.err() };
    let (position_residual, velocity_residual) = largest_residuals(&mechanism, &trajectory);
    let energy_balance = energy_balance(&mechanism, &trajectory, recorder.largest_work);
    let energy_taken = trajectory.phases.last().map_or(0.0, |phase| phase.energy_taken);
    Ok(Run {
        mechanism,
        settings: *settings,
        trajectory,
        events: recorder.events.found,
        dead_points,
        mobility,
        steps,
        evaluations,
        position_residual,
        velocity_residual,
        energy_balance,
        energy_taken,
        integration_time,
    })
}

/// The motion from one event that changes something to the next, and from one period of the controller to the next; each is
/// integrated afresh.
fn run_phases<M: Mechanism>(
    mut mechanism: M,
    mut state: State<M>,
    settings: &Settings,
    mut control: Control<M>,
    recorder: &mut Recorder<M>,
    steps: &mut Steps,
    evaluations: &mut u64,
) -> Result<(), Failure> {
    let begin = state.time;
    let mut is_phase = true;
    let mut measures = Measures::of_independent(&mechanism, state.time, &state.positions);
    loop {
        if is_phase {
            let found = mobility(&mechanism, state.time, &state.positions);
            found.check_regular::<M>(state.time, &state.positions)?;
            measures = Measures::with_mobility(&mechanism, state.time, &state.positions, &found);
        }
        mechanism = control.ask(mechanism, &state, |mechanism| {
            Motion::new(*mechanism, settings.stabilisation, measures).sample(state)
        })?;
        let span = settings.until(control.holds_until(settings.end), begin);
        let motion = Motion::new(mechanism, settings.stabilisation, measures);
        motion.start(&state);
        let ended = first_sample(&motion, state).and_then(|sample| {
            if is_phase {
                recorder.start(&motion, sample)?;
            }
            match recorder.goes_on() {
                true => integrate_by(settings.method, &motion, &span, sample, steps, recorder),
                false => Ok(()),
            }
        });
        *evaluations += motion.evaluations();
        ended?;
        (mechanism, state, is_phase) = match (recorder.next_phase(), recorder.reached()) {
            (Some((mechanism, state)), _) => (mechanism, state, true),
            (None, Some(reached)) if reached.time < settings.end => (mechanism, reached, false),
            _ => return Ok(()),
        };
    }
}

fn integrate_by<M: Mechanism>(
    method: Method,
    motion: &Motion<M>,
    settings: &Settings,
    start: Sample<M>,
    steps: &mut Steps,
    recorder: &mut Recorder<M>,
) -> Result<(), Failure> {
    let explicit = |tableau| ExplicitRungeKutta::new(tableau);
    match method {
        Method::Euler => integrate_with(&mut explicit(&EULER), motion, settings, start, steps, recorder),
        Method::Heun => integrate_with(&mut explicit(&HEUN), motion, settings, start, steps, recorder),
        Method::Rk3 => integrate_with(&mut explicit(&RK3), motion, settings, start, steps, recorder),
        Method::Rk4 => integrate_with(&mut explicit(&RK4), motion, settings, start, steps, recorder),
        Method::Dopri5 => integrate_with(&mut explicit(&DOPRI5), motion, settings, start, steps, recorder),
        Method::Dop853 => integrate_with(&mut Dop853::new(), motion, settings, start, steps, recorder),
        Method::Radau5 => integrate_with(&mut Radau5::new(), motion, settings, start, steps, recorder),
    }
}

fn integrate_with<M: Mechanism>(
    method: &mut dyn Advance<M>,
    motion: &Motion<M>,
    settings: &Settings,
    start: Sample<M>,
    steps: &mut Steps,
    recorder: &mut Recorder<M>,
) -> Result<(), Failure> {
    let Settings { end, stepping, interrupt, .. } = *settings;
    let course = Course { begin: recorder.begin(), end, stepping, interrupt };
    integrate(motion, method, &course, start, steps, |step| {
        if let Some(progress) = settings.progress {
            progress.store(step.to.state.time.to_bits(), Ordering::Relaxed);
        }
        recorder.watch(step)
    })
}

fn largest_residuals<M: Mechanism>(mechanism: &M, trajectory: &Trajectory<M>) -> (f64, f64) {
    trajectory.with_mechanisms(mechanism).fold((0.0, 0.0), |(position, velocity), (mechanism, sample)| {
        let (p, v) = residuals(&mechanism, &sample.state);
        (larger(position, p), larger(velocity, v))
    })
}

/// `largest` is the largest work between samples: a mechanism may be at rest in all of them.
fn energy_balance<M: Mechanism>(mechanism: &M, trajectory: &Trajectory<M>, mut largest: f64) -> f64 {
    let (mut change, mut start) = (0.0f64, None);
    for (index, (mechanism, sample)) in trajectory.with_mechanisms(mechanism).enumerate() {
        let state = &sample.state;
        let kinetic = mechanism.kinetic_energy(state.time, &state.positions, &state.speeds);
        let taken = trajectory.phase_of(index).map_or(0.0, |phase| phase.energy_taken);
        let balance = kinetic - state.work + taken;
        largest = larger(larger(largest, kinetic), state.work.abs());
        change = larger(change, (balance - *start.get_or_insert(balance)).abs());
    }
    if largest == 0.0 { 0.0 } else { change / largest }
}

/// The larger of two numbers; NaN, which `f64::max` would drop, stays.
fn larger(a: f64, b: f64) -> f64 {
    if a.is_nan() || a > b { a } else { b }
}
