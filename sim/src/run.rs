//! A whole run: assemble, integrate, locate events, record, balance.

use crate::assemble::{Start, assemble};
use crate::events::{EventSearch, Occurrence};
use crate::failure::{Failure, What};
use crate::integrate::{
    Advance, Course, DOPRI5, Dop853, EULER, ExplicitRungeKutta, HEUN, RK3, RK4, Radau5, Step, Steps, integrate,
};
use crate::mobility::{Mobility, check_masses, mobility};
use crate::motion::{Motion, residuals};
use crate::settings::{Method, Rows, Settings, StopAt};
use crate::trajectory::{Sample, Trajectory};
use sim_kernel::Mechanism;
use std::ops::ControlFlow;
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
    /// The largest change of kinetic energy minus work, relative to the largest kinetic energy or work.
    pub energy_balance: f64,
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
/// If no start can be assembled. A failure on the way does not lose the run: it stands in its trajectory.
pub fn run<M: Mechanism>(mechanism: M, start: &Start<M>, settings: &Settings) -> Result<Run<M>, Failure> {
    let first = assemble(&mechanism, start)?;
    check_masses(&mechanism, first.time, &first.positions)?;
    let mobility = mobility(&mechanism, first.time, &first.positions);
    let motion = Motion::with_redundant(&mechanism, settings.stabilisation, mobility.dependent.len());
    let mut recorder = Recorder::new(settings, first.time);
    recorder.make_room().map_err(|what| Failure::at::<M>(what, first.time, &first.positions))?;
    let mut steps = Steps::default();
    let clock = Instant::now();
    let ended = motion.prepare(&first).and_then(|()| motion.sample(first)).and_then(|sample| {
        recorder.samples.push(sample);
        integrate_by(settings.method, &motion, settings, sample, &mut steps, &mut recorder)
    });
    let integration_time = clock.elapsed();
    let evaluations = motion.evaluations();
    let trajectory = Trajectory { samples: recorder.samples, failure: ended.err() };
    let (position_residual, velocity_residual) = largest_residuals(&mechanism, &trajectory);
    let energy_balance = energy_balance(&mechanism, &trajectory);
    Ok(Run {
        mechanism,
        settings: *settings,
        trajectory,
        events: recorder.events.found,
        mobility,
        steps,
        evaluations,
        position_residual,
        velocity_residual,
        energy_balance,
        integration_time,
    })
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
        Method::Euler => integrate_with(explicit(&EULER), motion, settings, start, steps, recorder),
        Method::Heun => integrate_with(explicit(&HEUN), motion, settings, start, steps, recorder),
        Method::Rk3 => integrate_with(explicit(&RK3), motion, settings, start, steps, recorder),
        Method::Rk4 => integrate_with(explicit(&RK4), motion, settings, start, steps, recorder),
        Method::Dopri5 => integrate_with(explicit(&DOPRI5), motion, settings, start, steps, recorder),
        Method::Dop853 => integrate_with(Dop853::new(), motion, settings, start, steps, recorder),
        Method::Radau5 => integrate_with(Radau5::new(), motion, settings, start, steps, recorder),
    }
}

fn integrate_with<M: Mechanism>(
    mut method: impl Advance<M>,
    motion: &Motion<M>,
    settings: &Settings,
    start: Sample<M>,
    steps: &mut Steps,
    recorder: &mut Recorder<M>,
) -> Result<(), Failure> {
    let course = Course { end: settings.end, stepping: settings.stepping, interrupt: settings.interrupt };
    integrate(motion, &mut method, &course, start, steps, |step| {
        if let Some(progress) = settings.progress {
            progress.store(step.to.state.time.to_bits(), Ordering::Relaxed);
        }
        recorder.watch(step)
    })
}

/// Watches the steps of a run: finds events, and keeps what is to be recorded.
struct Recorder<M: Mechanism> {
    samples: Vec<Sample<M>>,
    events: EventSearch<M>,
    rows: Rows,
    stop: Option<StopAt>,
    begin: f64,
    end: f64,
    /// The next row, of those at equal intervals.
    next: usize,
    expected: usize,
}

impl<M: Mechanism> Recorder<M> {
    fn new(settings: &Settings, begin: f64) -> Recorder<M> {
        let expected = match (settings.rows, settings.stepping) {
            (Rows::Even(count), _) => count,
            (Rows::Steps, crate::settings::Stepping::Equal(count)) => count,
            (Rows::Steps, crate::settings::Stepping::Adaptive(_)) => 1024,
        };
        Recorder {
            samples: Vec::new(),
            events: EventSearch::new(begin),
            rows: settings.rows,
            stop: settings.stop,
            begin,
            end: settings.end,
            next: 1,
            expected,
        }
    }

    fn make_room(&mut self) -> Result<(), What> {
        let rows = self.expected.checked_add(2);
        match rows.is_some_and(|rows| self.samples.try_reserve_exact(rows).is_ok()) {
            true => Ok(()),
            false => Err(What::TooManyRows { rows: self.expected }),
        }
    }

    fn watch<A: Advance<M>>(&mut self, step: &mut Step<M, A>) -> Result<ControlFlow<()>, Failure> {
        self.events.search(step)?;
        let stop = self.stopping_state();
        self.record(step, stop.map_or(step.to.state.time, |state| state.time))?;
        let Some(state) = stop else { return Ok(ControlFlow::Continue(())) };
        let last = self.samples.last().map_or(self.begin, |sample| sample.state.time);
        if state.time > last {
            self.samples.push(step.motion.sample(state)?);
        }
        Ok(ControlFlow::Break(()))
    }

    /// Where the event that ends the run has happened.
    fn stopping_state(&mut self) -> Option<crate::State<M>> {
        let stop = self.stop?;
        let name = M::DESCRIPTION.events.get(stop.event)?;
        let mut occurrences = self.events.found.iter().enumerate().filter(|(_, event)| event.name == *name);
        let (at, event) = occurrences.nth(stop.occurrence.checked_sub(1)?)?;
        let state = event.state;
        self.events.found.truncate(at + 1);
        Some(state)
    }

    fn record<A: Advance<M>>(&mut self, step: &mut Step<M, A>, until: f64) -> Result<(), Failure> {
        match self.rows {
            Rows::Steps if until == step.to.state.time => self.samples.push(*step.to),
            Rows::Steps => {}
            Rows::Even(count) => {
                while self.next <= count {
                    let time = self.begin + (self.end - self.begin) * (self.next as f64 / count as f64);
                    if time > until {
                        break;
                    }
                    let is_end = time == step.to.state.time;
                    let sample = if is_end { *step.to } else { step.sample(time)? };
                    self.samples.push(sample);
                    self.next += 1;
                }
            }
        }
        Ok(())
    }
}

fn largest_residuals<M: Mechanism>(mechanism: &M, trajectory: &Trajectory<M>) -> (f64, f64) {
    trajectory.samples.iter().fold((0.0, 0.0), |(position, velocity), sample| {
        let (p, v) = residuals(mechanism, &sample.state);
        (larger(position, p), larger(velocity, v))
    })
}

fn energy_balance<M: Mechanism>(mechanism: &M, trajectory: &Trajectory<M>) -> f64 {
    let (mut largest, mut change, mut start) = (0.0f64, 0.0f64, None);
    for sample in &trajectory.samples {
        let state = &sample.state;
        let kinetic = mechanism.kinetic_energy(state.time, &state.positions, &state.speeds);
        let balance = kinetic - state.work;
        largest = larger(larger(largest, kinetic), state.work.abs());
        change = larger(change, (balance - *start.get_or_insert(balance)).abs());
    }
    if largest == 0.0 { 0.0 } else { change / largest }
}

/// The larger of two numbers; NaN, which `f64::max` would drop, stays.
fn larger(a: f64, b: f64) -> f64 {
    if a.is_nan() || a > b { a } else { b }
}
