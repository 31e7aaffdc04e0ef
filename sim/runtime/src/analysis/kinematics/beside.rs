//! The motion beside crossings, from the nodes of a step on both sides.

use super::series::{NODES, Series};
use crate::numerics::nearest::{Known, nearest_polynomial};

/// The accuracy of quantities that pass through a crossing, relative to their largest value; a pole has none.
const SMOOTH: f64 = 1e-6;

/// A quantity at the nodes of a step with a crossing.
pub(super) struct Beside {
    known: Vec<Known<[f64; 1]>>,
    pub(super) has_pole: bool,
}

impl Beside {
    /// The values at nodes.
    pub(super) fn new(known: Vec<Known<[f64; 1]>>, crossings: &[f64]) -> Beside {
        let largest = known.iter().fold(0.0f64, |most, known| most.max(known.values[0].abs()));
        let values: Vec<f64> = known.iter().map(|known| known.values[0]).collect();
        let mut beside = Beside { known, has_pole: false };
        let foretold = || crossings.iter().fold(0.0f64, |most, x| most.max(beside.at(*x).1));
        let lacking = <[_; NODES]>::try_from(values)
            .map_or_else(|_| foretold(), |values: [f64; NODES]| Series::through(values).tail());
        beside.has_pole = !(lacking <= SMOOTH * largest);
        beside
    }

    /// Its value and approximate error.
    pub(super) fn at(&self, x: f64) -> (f64, f64) {
        let (value, off) = nearest_polynomial(&self.known, x, [0.0], |value| value[0].abs());
        (value[0], off)
    }
}
