//! A kernel at many states, one after the other.

use super::each::{Results, States};
use super::model::{Kernel, Model};

/// A kernel at each of many states, one after the other.
pub(crate) fn one_by_one(model: &dyn Model, kernel: Kernel, states: &States) -> Results {
    let prepared = matches!(kernel, Kernel::Dynamics | Kernel::Velocities).then(|| model.prepare());
    let mut results = Results::default();
    for state in 0..states.times.len() {
        let Results { rows, numbers, refused } = &mut results;
        let mut found = |row: usize, values: &[f64]| {
            if state == 0 {
                debug_assert_eq!(row, rows.len());
                rows.push(values.len());
            }
            numbers.extend_from_slice(values);
        };
        let is_refused = match &prepared {
            Some(prepared) => prepared.call(kernel, states.at(state), &mut found),
            None => model.call(kernel, states.at(state), &mut found),
        };
        if is_refused {
            refused.push(state);
        }
    }
    results
}
