//! A kernel at many states.

use super::model::{Kernel, Model};
use crate::model::At;

/// Many states: the numbers of one after those of another. What is empty is zero at all of them.
#[derive(Clone, Copy, Debug)]
pub struct States<'a> {
    /// t of each, in seconds. There are as many states as times.
    pub times: &'a [f64],
    /// q, n numbers a state.
    pub positions: &'a [f64],
    /// q', n numbers a state.
    pub speeds: &'a [f64],
    /// q'', n numbers a state.
    pub accelerations: &'a [f64],
    /// lambda, m numbers a state.
    pub multipliers: &'a [f64],
}

impl<'a> States<'a> {
    /// One of them.
    ///
    /// # Panics
    /// If there are not so many, or a state has fewer numbers than another.
    pub fn at(&self, state: usize) -> At<'a, f64> {
        let (count, time) = (self.times.len(), self.times[state]);
        let of = |numbers: &'a [f64]| {
            let width = numbers.len() / count;
            &numbers[state * width..][..width]
        };
        At {
            time,
            positions: of(self.positions),
            speeds: of(self.speeds),
            accelerations: of(self.accelerations),
            multipliers: of(self.multipliers),
        }
    }
}

/// A kernel's results at many states.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Results {
    /// The lengths of the rows of a result, which are the same at all states.
    pub rows: Vec<usize>,
    /// The numbers of all rows, those of one state after those of another.
    pub numbers: Vec<f64>,
    /// The states at which the kernel refuses a pivot: their numbers are not valid.
    pub refused: Vec<usize>,
}

/// A kernel at each of many states, one after the other.
pub(crate) fn one_by_one(model: &(impl Model + ?Sized), kernel: Kernel, states: &States) -> Results {
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
