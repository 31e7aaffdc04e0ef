//! A whole run: assemble, integrate, locate events, balance.

use crate::assemble::{Start, assemble};
use crate::events::{Occurrence, locate_events};
use crate::failure::{Failure, What};
use crate::integrate::{RK4, integrate};
use crate::motion::residuals;
use crate::trajectory::Trajectory;
use sim_kernel::Mechanism;
use std::time::{Duration, Instant};

/// The times of a run: from 0 to `end` in `steps` equal steps.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Grid {
    /// The end, in seconds.
    pub end: f64,
    /// How many steps.
    pub steps: usize,
}

/// Relative change of energy from which a result deserves doubt.
pub const DOUBTFUL_BALANCE: f64 = 1e-3;

/// What a run found.
#[derive(Clone, Debug)]
pub struct Run<M: Mechanism> {
    /// The mechanism with its parameters.
    pub mechanism: M,
    /// The times asked for.
    pub grid: Grid,
    /// The motion, as far as it came.
    pub trajectory: Trajectory<M>,
    /// Events along it.
    pub events: Vec<Occurrence<M>>,
    /// The largest |C_i| of any sample.
    pub position_residual: f64,
    /// The largest |(C_q q' + C_t)_i| of any sample.
    pub velocity_residual: f64,
    /// The largest change of kinetic energy minus work, relative to the largest kinetic energy or work.
    pub energy_balance: f64,
    /// How long the integration alone took.
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
pub fn run<M: Mechanism>(mechanism: M, start: &Start<M>, grid: Grid) -> Result<Run<M>, Failure> {
    let first = assemble(&mechanism, start)?;
    let mut samples = Vec::new();
    let room = grid.steps.checked_add(1).is_some_and(|n| samples.try_reserve_exact(n).is_ok());
    if !room {
        return Err(Failure::at::<M>(What::TooManySteps { steps: grid.steps }, 0.0, &first.positions));
    }
    let clock = Instant::now();
    let ended = integrate(&mechanism, &RK4, first, grid.end, grid.steps, |sample| samples.push(sample));
    let integration_time = clock.elapsed();
    let mut trajectory = Trajectory { samples, failure: ended.err() };
    let (events, event_failure) = locate_events(&mechanism, &trajectory.samples);
    if trajectory.failure.is_none() {
        trajectory.failure = event_failure;
    }
    let (mut position_residual, mut velocity_residual) = (0.0f64, 0.0f64);
    for sample in &trajectory.samples {
        let (position, velocity) = residuals(&mechanism, &sample.state);
        position_residual = larger(position_residual, position);
        velocity_residual = larger(velocity_residual, velocity);
    }
    let energy_balance = energy_balance(&mechanism, &trajectory);
    Ok(Run {
        mechanism,
        grid,
        trajectory,
        events,
        position_residual,
        velocity_residual,
        energy_balance,
        integration_time,
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
