//! A kernel at many states, for those who check numbers: what a run would use there.

use crate::model::erased::{Erased, Kernel, List, Model, OnHeap, Results, States};
use crate::motion::measured::mobility;
use crate::motion::measures::Measures;
use crate::motion::typed::accelerate;
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

/// Accelerations, multipliers and power at one of these states.
fn solve(mechanism: &Erased<OnHeap>, states: &States, state: usize) -> Option<Vec<f64>> {
    let at = states.at(state);
    let numbers = |numbers: &[f64]| List::with_len(mechanism.n(), |i| numbers.get(i).copied().unwrap_or(0.0));
    let (q, qd) = (numbers(at.positions), numbers(at.speeds));
    let mobility = mobility(mechanism, at.time, &q);
    mobility.check_regular(mechanism, at.time, &q).ok()?;
    let measures = Measures::with_mobility(mechanism, at.time, &q, &mobility);
    let open = mechanism.constraints(at.time, &q);
    if open.iter().zip(measures.constraints().iter()).any(|(open, size)| !(open.abs() <= NEAR * size)) {
        return None;
    }
    let found = accelerate(mechanism, at.time, &q, &qd).ok()?;
    Some([found.accelerations.as_ref(), found.multipliers.as_ref(), &[found.power]].concat())
}
