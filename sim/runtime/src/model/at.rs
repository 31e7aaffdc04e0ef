//! A place in the motion of a type-erased mechanism.

use crate::state::trajectory::{Sample, State};
use sim_kernel::{Dual, Interval, Mechanism};

/// Time, coordinates, speeds, accelerations and multipliers, as numbers of any kind. Omitted ones are zero.
#[derive(Clone, Copy, Debug)]
pub struct At<'a, S> {
    /// t, in seconds.
    pub time: S,
    /// q.
    pub positions: &'a [S],
    /// q'.
    pub speeds: &'a [S],
    /// q''.
    pub accelerations: &'a [S],
    /// lambda.
    pub multipliers: &'a [S],
}

impl<'a, S> At<'a, S> {
    /// Without accelerations and multipliers.
    pub(crate) fn moving(time: S, positions: &'a [S], speeds: &'a [S]) -> At<'a, S> {
        At { time, positions, speeds, accelerations: &[], multipliers: &[] }
    }
}

impl<'a> At<'a, f64> {
    /// A state, without accelerations and multipliers.
    pub(crate) fn state<M: Mechanism>(state: &'a State<M>) -> At<'a, f64> {
        At::moving(state.time, state.positions.as_ref(), state.speeds.as_ref())
    }

    /// A sample.
    pub fn sample<M: Mechanism>(sample: &'a Sample<M>) -> At<'a, f64> {
        let (accelerations, multipliers) = (sample.accelerations.as_ref(), sample.multipliers.as_ref());
        At { accelerations, multipliers, ..At::state(&sample.state) }
    }
}

/// A number as an interval that does not change.
pub(crate) fn exactly(value: f64) -> Dual<Interval> {
    Dual::constant(Interval::exactly(value))
}

/// Numbers that do not change.
pub(crate) fn constants(values: &[f64]) -> Vec<Dual> {
    values.iter().map(|value| Dual::constant(*value)).collect()
}
