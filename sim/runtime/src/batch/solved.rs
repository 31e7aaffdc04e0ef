//! A kernel at many states, for those who check numbers: what a run would use there.

use crate::model::At;
use crate::model::conditional::is_active;
use crate::model::erased::{Erased, Kernel, List, Model, OnHeap, Results, States};
use crate::motion::Motion;
use crate::motion::measured::mobility;
use crate::motion::measures::Measures;
use crate::state::settings::Stabilisation;
use crate::state::trajectory::State;
use sim_kernel::{Array, Mechanism};
use std::sync::Arc;

/// The largest residual of a constraint, relative to its size, at a position on the constraints.
const NEAR: f64 = 1e-6;

/// As [`Model::call_each`]; but where the planned elimination of [`Kernel::Dynamics`] refuses a pivot, accelerations,
/// multipliers and power are found as in a run: by complete pivoting, with reactions of least norm where constraints
/// are redundant. States remain refused that no run has: off the constraints, singular, or without a solution.
pub fn solve_each(model: &Arc<dyn Model>, kernel: Kernel, states: &States) -> Results {
    let mut results = model.call_each(kernel, states);
    if kernel == Kernel::Dynamics && !results.refused.is_empty() {
        let mechanism = Erased::of(model.clone());
        let width: usize = results.rows.iter().sum();
        let Results { numbers, refused, .. } = &mut results;
        refused.retain(|state| match solve(&mechanism, states, *state) {
            Some(solved) => {
                numbers[state * width..][..width].copy_from_slice(&solved);
                false
            }
            None => true,
        });
    }
    results
}

/// Accelerations, multipliers and power at one of these states, unless no run has it.
fn solve(mechanism: &Erased<OnHeap>, states: &States, state: usize) -> Option<Vec<f64>> {
    let At { time, positions, speeds, .. } = states.at(state);
    // What is omitted is zero.
    let numbers = |given: &[f64]| List::with_len(mechanism.n(), |j| given.get(j).copied().unwrap_or(0.0));
    let state = State { time, positions: numbers(positions), speeds: numbers(speeds), work: 0.0 };
    let mobility = mobility(mechanism, time, &state.positions);
    mobility.check_regular(mechanism, time, &state.positions).ok()?;
    let measures = Measures::with_mobility(mechanism, time, &state.positions, &mobility);
    if !is_closed(mechanism, &measures, &state) {
        return None;
    }
    let found = Motion::new(mechanism.clone(), Stabilisation::Projection, measures).sample(state).ok()?;
    Some([found.accelerations.as_ref(), found.multipliers.as_ref(), &[found.power]].concat())
}

/// Whether a state is on the constraints that hold.
fn is_closed<M: Mechanism>(mechanism: &M, measures: &Measures<M>, state: &State<M>) -> bool {
    let open = mechanism.constraints(state.time, &state.positions);
    let is_met = |row: usize| open[row].abs() <= NEAR * measures.constraints()[row];
    (0..mechanism.m()).all(|row| !is_active(mechanism, row) || is_met(row))
}
