//! Explicit Runge-Kutta methods with fixed steps, projected onto the constraints after each step.

mod tableau;

pub use tableau::{RK4, Tableau};

use crate::failure::{Failure, What};
use crate::motion::accelerate;
use crate::project::{project_positions, project_velocities};
use crate::trajectory::{Sample, State};
use sim_kernel::{Array, Dynamics, Mechanism};

/// Integrates from a start on the constraints to `end` in equal steps. Every sample goes to `sink`, the start and
/// the end included; it holds the accelerations and multipliers of its own time.
///
/// # Errors
/// The first failure of a step. Samples before it have gone to `sink`.
pub fn integrate<M: Mechanism, const STAGES: usize>(
    mechanism: &M,
    tableau: &Tableau<STAGES>,
    start: State<M>,
    end: f64,
    steps: usize,
    mut sink: impl FnMut(Sample<M>),
) -> Result<(), Failure> {
    let span = end - start.time;
    let mut state = start;
    let mut first = accelerate(mechanism, state.time, &state.positions, &state.speeds)?;
    for step in 1..=steps {
        sink(sample(state, &first));
        // From the start each time, so that times do not accumulate rounding.
        let time = start.time + span * (step as f64 / steps as f64);
        let mut next = advance(mechanism, tableau, &state, &first, time)?;
        let linear = project_positions(mechanism, time, &mut next.positions)?;
        project_velocities::<M>(&linear, time, &next.positions, &mut next.speeds)?;
        first = accelerate(mechanism, time, &next.positions, &next.speeds)?;
        state = next;
    }
    sink(sample(state, &first));
    Ok(())
}

fn sample<M: Mechanism>(state: State<M>, dynamics: &Dynamics<f64, M::Q, M::L>) -> Sample<M> {
    Sample { state, accelerations: dynamics.accelerations, multipliers: dynamics.multipliers }
}

/// One step to `time` without projection; `first` is the right-hand side at its start.
#[inline]
fn advance<M: Mechanism, const STAGES: usize>(
    mechanism: &M,
    tableau: &Tableau<STAGES>,
    start: &State<M>,
    first: &Dynamics<f64, M::Q, M::L>,
    time: f64,
) -> Result<State<M>, Failure> {
    let h = time - start.time;
    let mut rates = [Rates::<M>::of(&start.speeds, first); STAGES];
    for stage in 1..STAGES {
        let inner = combine(start, h, &tableau.a[stage][..stage], &rates, start.time + tableau.c[stage] * h);
        let dynamics = accelerate(mechanism, inner.time, &inner.positions, &inner.speeds)?;
        rates[stage] = Rates::of(&inner.speeds, &dynamics);
    }
    let end = combine(start, h, &tableau.b, &rates, time);
    let finite = end.positions.iter().chain(end.speeds.iter()).chain([&end.work]).all(|value| value.is_finite());
    match finite {
        true => Ok(end),
        false => Err(Failure::at::<M>(
            What::NotFinite { quantity: "the state after this step".into() },
            start.time,
            &start.positions,
        )),
    }
}

/// The rate of a state at one stage.
#[derive(Clone, Copy)]
struct Rates<M: Mechanism> {
    speeds: M::Q,
    accelerations: M::Q,
    power: f64,
}

impl<M: Mechanism> Rates<M> {
    fn of(speeds: &M::Q, dynamics: &Dynamics<f64, M::Q, M::L>) -> Rates<M> {
        Rates { speeds: *speeds, accelerations: dynamics.accelerations, power: dynamics.power }
    }
}

/// `start + h * sum of weight * rate`.
#[inline]
fn combine<M: Mechanism>(start: &State<M>, h: f64, weights: &[f64], rates: &[Rates<M>], time: f64) -> State<M> {
    let sum = |rate: &dyn Fn(&Rates<M>) -> f64| -> f64 {
        weights.iter().zip(rates).map(|(weight, rates)| weight * rate(rates)).sum()
    };
    State {
        time,
        positions: M::Q::from_fn(|i| start.positions[i] + h * sum(&|rates| rates.speeds[i])),
        speeds: M::Q::from_fn(|i| start.speeds[i] + h * sum(&|rates| rates.accelerations[i])),
        work: start.work + h * sum(&|rates| rates.power),
    }
}
