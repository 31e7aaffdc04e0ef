//! How a state moves with a jump of what acts on it.
//!
//! A jump at a time that depends on parameters moves with them, and in between the rates are those before it instead of those
//! after it. At g(t, p) = 0 its time moves by dt = -g_p dp / g_t, and the state behind it by (f- - f+) dt. (Hiskens, Pai,
//! Trajectory sensitivity analysis of hybrid systems, IEEE Transactions on Circuits and Systems I 47, 2000: the jump
//! conditions, for a state that does not jump itself.)

use crate::state::trajectory::{Sample, State};
use sim_kernel::{Dual, Mechanism};

/// How far the time of what changes its form between two times moves, in seconds for a unit of the direction in which the
/// mechanism is differentiated; 0 if nothing changes.
///
/// # Errors
/// If changes that move apart fall together, as a sentence.
pub(super) fn moved<M: Mechanism<Dual>>(mechanism: &M, [from, to]: [f64; 2]) -> Result<f64, &'static str> {
    let functions = mechanism.description().switching;
    if functions.is_empty() {
        return Ok(0.0);
    }
    let values = |time: Dual| mechanism.switching_functions(time);
    let (before, after) = (values(Dual::constant(from)), values(Dual::constant(to)));
    let with_time = values(Dual::variable(to));
    let changes = |k: &usize| functions[*k].table.is_none() && before[*k].value * after[*k].value < 0.0;
    let move_of = |k: usize| -after[k].derivative / (with_time[k].derivative - after[k].derivative);
    let mut moves = (0..functions.len()).filter(changes).map(move_of);
    let first = moves.next().unwrap_or(0.0);
    // Rounding of a move that is found in two ways.
    let is_same = |other: f64| !((other - first).abs() > 1e-9 * first.abs());
    match moves.all(is_same) {
        true => Ok(first),
        false => Err("two sudden changes fall together here that do not move together"),
    }
}

/// The state behind a jump that moves so far, with what that adds to its derivative.
pub(super) fn behind<M: Mechanism<Dual>>(
    before: &Sample<M, Dual>,
    after: &Sample<M, Dual>,
    moved: f64,
) -> State<M, Dual> {
    let moved_by = |seconds: f64| Dual { value: 0.0, derivative: seconds };
    let time = after.state.time;
    after.state.changed(time, moved_by(moved), &before.rates()).changed(time, moved_by(-moved), &after.rates())
}
