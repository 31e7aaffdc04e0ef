//! Whether constraints keep the condition of an event as it is.

use crate::motion::Motion;
use crate::state::trajectory::{Sample, State};
use nalgebra::{DMatrix, DVector};
use sim_kernel::{Array, Mechanism};

/// Differences are over this part of a value and of what counts as 1.
const PART: f64 = 1e-6;
/// The part of a gradient that is rounding: it is of differences.
const ALONG: f64 = 1e-4;
/// The part of the longest of several rows of length 1 below which what they span is rounding.
const SPANNED: f64 = 1e-8;

/// Whether constraints keep a condition as it is: its gradient by accelerations, or by speeds or positions if it does not depend on
/// what comes before, is a sum of their rows. A reaction is kept by none.
pub(super) fn is_held<M: Mechanism>(motion: &Motion<M>, sample: &Sample<M>, event: usize) -> bool {
    let (mechanism, sizes) = (motion.mechanism(), motion.measures().coordinates());
    let (State { time, positions, speeds, .. }, qdd, lambda) =
        (&sample.state, &sample.accelerations, &sample.multipliers);
    let value = |q: &M::Q, qd: &M::Q, qdd: &M::Q, lambda: &M::L| mechanism.events(*time, q, qd, qdd, lambda)[event];
    let more = lambda.like(|row| lambda[row] + lambda[row].abs().max(1.0));
    if value(positions, speeds, qdd, &more) != value(positions, speeds, qdd, lambda) {
        return false;
    }
    let by_accelerations = gradient(qdd, sizes, |qdd| value(positions, speeds, qdd, lambda));
    let by_speeds = gradient(speeds, sizes, |qd| value(positions, qd, qdd, lambda));
    match () {
        () if by_accelerations.amax() > 0.0 => is_sum_of_rows(mechanism, &sample.state, sizes, &by_accelerations, true),
        () if by_speeds.amax() > 0.0 => is_sum_of_rows(mechanism, &sample.state, sizes, &by_speeds, true),
        () => holds_positions(mechanism, &sample.state, sizes, event),
    }
}

/// The same of a condition on positions, with the constraints of a mechanism that may hold others than the motion's.
pub(super) fn holds_positions<M: Mechanism>(mechanism: &M, state: &State<M>, sizes: &M::Q, event: usize) -> bool {
    let (zero, none) = (state.positions.like(|_| 0.0), M::L::repeat(mechanism.m(), 0.0));
    let value = |q: &M::Q| mechanism.events(state.time, q, &state.speeds, &zero, &none)[event];
    is_sum_of_rows(mechanism, state, sizes, &gradient(&state.positions, sizes, value), false)
}

/// The change of a value by each of what it depends on, n, in the changes that count as 1.
fn gradient<Q: Array<f64>>(at: &Q, sizes: &Q, value: impl Fn(&Q) -> f64) -> DVector<f64> {
    DVector::from_fn(at.len(), |j, _| {
        let step = PART * at[j].abs().max(sizes[j]);
        let beside = |by: f64| value(&at.like(|k| if k == j { at[k] + by } else { at[k] }));
        (beside(step) - beside(-step)) / (2.0 * step) * sizes[j]
    })
}

/// Whether a gradient is not zero and a sum of the rows of C_q, of those between speeds too if asked for.
fn is_sum_of_rows<M: Mechanism>(
    mechanism: &M,
    state: &State<M>,
    sizes: &M::Q,
    gradient: &DVector<f64>,
    of_speeds: bool,
) -> bool {
    let jacobian = mechanism.constraint_jacobian(state.time, &state.positions);
    let between_speeds = mechanism.description().speed_constraints;
    let row = |row: usize| DVector::from_fn(gradient.len(), |j, _| jacobian[row][j] * sizes[j]);
    let counts = |row: &usize| of_speeds || !between_speeds.contains(row);
    let rows = (0..mechanism.m()).filter(counts).map(row).filter_map(|row| row.try_normalize(0.0));
    let rows: Vec<DVector<f64>> = rows.collect();
    if rows.is_empty() || gradient.amax() == 0.0 {
        return false;
    }
    let columns = DMatrix::from_columns(&rows);
    let share = columns.clone().svd(true, true).solve(gradient, SPANNED);
    share.is_ok_and(|share| (columns * share - gradient).amax() <= ALONG * gradient.amax())
}
