//! What a sweep at rest cannot compute.
//!
//! Time stands still in such a sweep, so whatever moves with t has no speed either. Forces of inertia are left out and
//! constraints are taken as they are at time 0. But kernels have the whole velocity of a point, with its part by t: where a
//! load or an output depends on both t and speeds, nobody can tell whether it depends on such a part.

use super::stand_in::{TIMES, elsewhere};
use crate::model::{At, Differentiable};
use crate::state::failure::{Failure, What};

/// Refuses a load or an output that may feel how fast something moves with t.
///
/// # Errors
/// [`What::MovedByTime`].
pub(super) fn check_at_rest(mechanism: &dyn Differentiable, q: &[f64]) -> Result<(), Failure> {
    let description = mechanism.description();
    let loads = |At { time, positions, speeds, .. }: At<f64>| mechanism.generalized_forces(time, positions, speeds);
    let load = first_doubtful(q, |at| loads(at).as_slice().to_vec())
        .map(|j| format!("the load along `{}`", description.coordinates[j].position.name));
    let output =
        || first_doubtful(q, |at| mechanism.outputs(at)).map(|i| format!("output `{}`", description.outputs[i].name));
    match load.or_else(output) {
        Some(what) => Err(mechanism.failure(What::MovedByTime { what }, 0.0, q)),
        None => Ok(()),
    }
}

/// The first of some values that depends on t at rest, and also on speeds or accelerations.
fn first_doubtful(q: &[f64], values: impl Fn(At<f64>) -> Vec<f64>) -> Option<usize> {
    // Without symmetry, so that no even function hides its dependence.
    let rates: Vec<f64> = (0..q.len()).map(|j| 0.37 + 0.11 * j as f64).collect();
    let still = vec![0.0; q.len()];
    let places = [q.to_vec(), elsewhere(q)];
    let at = |place: usize, time: usize, rates: &[f64]| {
        let (time, positions) = (TIMES[time], &places[place]);
        values(At { time, positions, speeds: rates, accelerations: rates, multipliers: &[] })
    };
    let found = [0, 1].map(|place| {
        let resting = [0, 1, 2].map(|time| at(place, time, &still));
        let moving = [0, 1, 2].map(|time| at(place, time, &rates));
        (resting, moving)
    });
    let by_time =
        |k: usize| found.iter().any(|([first, others @ ..], _)| others.iter().any(|it| differ(it[k], first[k])));
    let by_rates = |k: usize| {
        found.iter().any(|(resting, moving)| resting.iter().zip(moving).any(|(rest, moved)| differ(rest[k], moved[k])))
    };
    (0..found[0].0[0].len()).find(|k| by_time(*k) && by_rates(*k))
}

/// Whether two values differ; where neither is a number they do not.
fn differ(a: f64, b: f64) -> bool {
    a != b && !(a.is_nan() && b.is_nan())
}
