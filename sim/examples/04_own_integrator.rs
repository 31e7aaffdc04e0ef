//! 4. An integrator of one's own: the equations of motion and the projection are functions.
//!
//! Velocity Verlet with projected constraints, of order 2: halving the step divides the error by four.
//!
//! `cargo run --release --example 04_own_integrator`

use models::FourBar;
use sim::{Array, Failure, Measures, Mechanism, State, accelerate, assemble, declared_start, project};

/// One step of size h.
fn verlet<M: Mechanism>(mechanism: &M, measures: &Measures<M>, state: &mut State<M>, h: f64) -> Result<(), Failure> {
    let before = accelerate(mechanism, state.time, &state.positions, &state.speeds)?.accelerations;
    for i in 0..before.len() {
        state.positions[i] += h * state.speeds[i] + h * h / 2.0 * before[i];
        state.speeds[i] += h * before[i];
    }
    state.time += h;
    let after = accelerate(mechanism, state.time, &state.positions, &state.speeds)?.accelerations;
    for i in 0..before.len() {
        state.speeds[i] += h / 2.0 * (after[i] - before[i]);
    }
    // Back onto C(q, t) = 0 and C_q q' + C_t = 0.
    project(mechanism, measures, state)
}

/// Angle and speed of the crank.
fn crank_after(time: f64, steps: usize) -> Result<[f64; 2], Failure> {
    let mechanism = FourBar::default();
    let mut state = assemble(&mechanism, &declared_start(&mechanism))?;
    let measures = Measures::at(&mechanism, state.time, &state.positions);
    for _ in 0..steps {
        verlet(&mechanism, &measures, &mut state, time / steps as f64)?;
    }
    Ok([state.positions[0], state.speeds[0]])
}

fn main() -> Result<(), Failure> {
    let [angle, speed] = crank_after(0.2, 64_000)?;
    for steps in [500, 1000, 2000, 4000] {
        let [a, s] = crank_after(0.2, steps)?;
        println!("{steps:>5} steps: off by {:.2e} rad and {:.2e} rad/s", (a - angle).abs(), (s - speed).abs());
    }
    Ok(())
}
