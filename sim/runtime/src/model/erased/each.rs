//! Many states, and what a kernel gives there.

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
