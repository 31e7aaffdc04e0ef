//! Where generalised speeds determine the speeds well enough to be integrated.
//!
//! Where u ceases to determine q', N in q' = N u + n grows without bound, and the error of a step of order p grows as
//! N^(p+1), long before digits are lost. So a step is made in u only if N is near its best value so far, at the step's
//! start, middle and end. A constant N always is.

use crate::motion::measures::Measures;
use crate::motion::project::project;
use crate::numerics::arrays::inner;
use crate::numerics::solve::Definite;
use crate::state::slot::Slot;
use crate::state::trajectory::{Sample, State};
use sim_kernel::{Array, Mechanism};

/// The least fraction of the longest distance so far between a row of W, or of the rows that hold by construction, and
/// the rows before it. With 0.7, equal steps of order 4 near the singularity are fifty times worse than in rates; with
/// 0.95 ten times, as where N is best.
const LEAST_PART: f64 = 0.95;

/// Whether generalised speeds are declared.
#[inline(always)]
pub(crate) fn has_generalized_speeds<M: Mechanism>(mechanism: &M) -> bool {
    mechanism.rows_left().is_some()
}

/// Whether generalised speeds determine the speeds well in a step from a sample to a time: at its start, and in its
/// middle and at its end, as predicted. `farthest` keeps the squares of the longest distances so far.
pub(crate) fn determine_speeds<M: Mechanism>(
    mechanism: &M,
    measures: &Measures<M>,
    (from, time): (&Sample<M>, f64),
    farthest: &Slot<M::Q>,
) -> bool {
    let Some(left) = mechanism.rows_left() else { return false };
    let state = &from.state;
    let distances_at =
        |positions, time| distances(mechanism, measures, &State { time, positions, ..state.clone() }, left);
    let lengthen = |by: &M::Q| {
        let longest = farthest.take();
        farthest.set(longest.like(|row| longest[row].max(by[row])));
    };
    if farthest.get().iter().all(|square| *square == 0.0) {
        around(mechanism, measures, state).for_each(|beside| lengthen(&distances_at(beside.positions, beside.time)));
    }
    let here = distances_at(state.positions.clone(), state.time);
    lengthen(&here);
    let longest = farthest.get();
    let are_apart = |found: &M::Q| (0..found.len()).all(|row| found[row] > LEAST_PART * LEAST_PART * longest[row]);
    let ahead = |fraction: f64| {
        let h = fraction * (time - state.time);
        let moved = |j: usize| state.positions[j] + h * (state.speeds[j] + h / 2.0 * from.accelerations[j]);
        distances_at(state.positions.like(moved), state.time + h)
    };
    are_apart(&here) && [0.5, 1.0].into_iter().all(|fraction| are_apart(&ahead(fraction)))
}

/// States beside the first one, which may lie close to the singularity.
fn around<M: Mechanism>(mechanism: &M, measures: &Measures<M>, state: &State<M>) -> impl Iterator<Item = State<M>> {
    [-1.0, -0.5, 0.5, 1.0].into_iter().filter_map(|side| {
        let positions = state.positions.like(|j| state.positions[j] + side * measures.coordinates()[j]);
        let mut beside = State { positions, ..state.clone() };
        project(mechanism, measures, &mut beside).ok().map(|()| beside)
    })
}

/// The squared distance of each row from those before it; 0 where it depends on them.
fn distances<M: Mechanism>(mechanism: &M, measures: &Measures<M>, state: &State<M>, left: &[usize]) -> M::Q {
    let rows = rows(mechanism, measures, state, left);
    let products = rows.like(|i| rows[i].like(|j| inner(&rows[i], &rows[j])));
    let Ok(factors) = Definite::<M::QQ, M::Q>::new(products) else { return state.positions.like(|_| 0.0) };
    state.positions.like(|row| match factors.row(row).1 {
        0.0 => 0.0,
        inverse => 1.0 / inverse,
    })
}

/// W, and below it the rows of C_q that hold by construction; n x n, for changes that count as 1.
fn rows<M: Mechanism>(mechanism: &M, measures: &Measures<M>, state: &State<M>, left: &[usize]) -> M::QQ {
    let (time, q, none) = (state.time, &state.positions, state.positions.like(|_| 0.0));
    let jacobian = mechanism.constraint_jacobian(time, q);
    let held = (0..mechanism.m()).filter(|row| !left.contains(row));
    let speeds = (mechanism.n() + left.len()).saturating_sub(mechanism.m());
    let drift = mechanism.velocity_variables(time, q, &none);
    let mut rows = M::QQ::repeat(mechanism.n(), none.clone());
    for j in 0..mechanism.n() {
        let size = measures.coordinates()[j];
        let mut alone = none.clone();
        alone[j] = size;
        let variables = mechanism.velocity_variables(time, q, &alone);
        (0..speeds).for_each(|i| rows[i][j] = variables[i] - drift[i]);
        held.clone().enumerate().for_each(|(i, row)| rows[speeds + i][j] = size * jacobian[row][j]);
    }
    rows
}
