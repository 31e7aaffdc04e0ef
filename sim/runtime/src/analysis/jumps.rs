//! How a state moves with a jump of what acts on it.
//!
//! A jump at a time that depends on parameters moves with them, and in between the rates are those before it instead of those
//! after it. At g(t, p) = 0 its time moves by dt = -g_p dp / g_t, and the state behind it by (f- - f+) dt. (Hiskens, Pai,
//! Trajectory sensitivity analysis of hybrid systems, IEEE Transactions on Circuits and Systems I 47, 2000: the jump
//! conditions, for a state that does not jump itself.) Of a jump at a position or speed, g depends on the state: what its
//! derivative adds counts too, and g_t is the rate of g along the motion before the jump.

use crate::integrate::{form, stays};
use crate::numerics::signs::crosses;
use crate::state::trajectory::{Sample, State};
use sim_kernel::{Array, Dual, Mechanism, Switching, Table};

/// Why a jump is refused.
pub(super) const TOGETHER: &str = "two sudden changes fall together here that do not move together";

/// Which rows of tables count as changes of form.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Rows {
    /// None: steps end there, and what tables say is continuous.
    None,
    /// Those at which a slope jumps.
    Corners,
    /// All.
    All,
}

/// Whether a table has a row between two arguments at which its slope jumps.
fn has_corner(table: &Table, [from, to]: [f64; 2]) -> bool {
    let slope = |x: f64| table.at::<f64, 2>(x)[1];
    let (from, to) = (from.min(to), from.max(to));
    let rows = std::iter::successors(Some(table.next_row(from)), |row| Some(table.next_row(*row)));
    rows.take_while(|row| *row <= to).any(|row| {
        let [before, after] = [table.last_row(row).max(row - 1.0), table.next_row(row).min(row + 1.0)];
        let [near, far] =
            [1e-9, 0.5].map(|part| [slope(row + part * (before - row)), slope(row + part * (after - row))]);
        (near[1] - near[0]).abs() > 1e-6 * (far[0].abs() + far[1].abs())
    })
}

/// How far the time of what changes its form between two times moves, in seconds for a unit of the direction in which the
/// mechanism is differentiated; 0 if nothing changes.
///
/// # Errors
/// If changes that move apart fall together, as a sentence.
pub(super) fn moved<M: Mechanism<Dual>>(mechanism: &M, [from, to]: [f64; 2], rows: Rows) -> Result<f64, &'static str> {
    let functions = mechanism.description().switching;
    if functions.is_empty() {
        return Ok(0.0);
    }
    let values = |time: Dual| mechanism.switching_functions(time);
    let (before, after) = (values(Dual::constant(from)), values(Dual::constant(to)));
    let with_time = values(Dual::variable(to));
    let changes = |k: &usize| {
        let (function, values) = (&functions[*k], [before[*k].value, after[*k].value]);
        match function.table {
            Some(table) => match rows {
                Rows::None => false,
                Rows::Corners => has_corner(table, values),
                Rows::All => form(function, values[0]) != form(function, values[1]),
            },
            // One that is zero at an end counts in both steps: it adds nothing where rates are of one side.
            None => !function.kind.is_smooth() && form(function, values[0]) != form(function, values[1]),
        }
    };
    let move_of = |k: usize| -after[k].derivative / (with_time[k].derivative - after[k].derivative);
    let mut moves = (0..functions.len()).filter(changes).map(move_of);
    let first = moves.next().unwrap_or(0.0);
    match moves.all(|other| are_same(first, other)) {
        true => Ok(first),
        false => Err(TOGETHER),
    }
}

/// Whether something changes its form between two times; what is smooth does not.
pub(super) fn changes_between<M: Mechanism<Dual>>(mechanism: &M, times: [f64; 2]) -> bool {
    let functions = mechanism.description().switching;
    if functions.is_empty() {
        return false;
    }
    let [before, after] = times.map(|time| mechanism.switching_functions(Dual::constant(time)));
    let may_change = |function: &Switching| function.table.is_some() || !function.kind.is_smooth();
    let changes = |k: usize| form(&functions[k], before[k].value) != form(&functions[k], after[k].value);
    (0..functions.len()).any(|k| may_change(&functions[k]) && changes(k))
}

/// What rates differ by where nothing jumps, as a part of them.
const ROUNDING: f64 = 1e-9;

/// Whether accelerations or the power jump between two samples next to each other, beside two that are some times as far apart: what is
/// continuous differs there by as many times as much. Coordinates have these sizes. Each is looked at for itself: unlike the next step, a
/// derivative is wrong by a jump that is small beside the accelerations of others.
pub(super) fn rates_jump<M: Mechanism<Dual>>(
    near: &[Sample<M, Dual>; 2],
    far: &[Sample<M, Dual>; 2],
    sizes: &M::Q,
) -> bool {
    let jumps = |of: &dyn Fn(&Sample<M, Dual>) -> f64, floor: f64| {
        let [[before, after], [earlier, later]] = [near, far].map(|ends| ends.each_ref().map(of));
        let difference = (after - before).abs();
        difference > floor.max(ROUNDING * before.abs().max(after.abs())) && stays(difference, (later - earlier).abs())
    };
    let scaled = |end: &Sample<M, Dual>, j: usize| (end.accelerations[j].value / sizes[j].value).abs();
    let n = near[0].accelerations.as_ref().len();
    let largest = (0..n).flat_map(|j| near.iter().map(move |end| scaled(end, j))).fold(0.0, f64::max);
    (0..n).any(|j| jumps(&|end| end.accelerations[j].value, NOISE * largest * sizes[j].value))
        || jumps(&|end| end.power.value, 0.0)
}

/// What accelerations differ by, as a part of the largest in the sizes of coordinates, where nothing acts on their coordinates.
const NOISE: f64 = 1e-13;

/// Whether moves differ by rounding, as one that is found in two ways.
pub(super) fn are_same(first: f64, other: f64) -> bool {
    !((other - first).abs() > 1e-9 * first.abs())
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

/// A jump of loads at a position or speed.
pub(super) struct MovedJump<M: Mechanism> {
    /// Just before and behind it.
    pub(super) samples: [Sample<M>; 2],
    /// How far its time moves, in seconds for a unit of the direction.
    pub(super) moved: f64,
}

/// How far the times move at which these conditions of loads change their signs, right behind a sample.
pub(super) fn moved_by_state<M: Mechanism<Dual>>(
    mechanism: &M,
    before: &Sample<M, Dual>,
    conditions: &[usize],
) -> Vec<f64> {
    let (state, rates) = (&before.state, before.rates());
    let along = |numbers: &M::Q, rates: &M::Q| {
        numbers.like(|i| Dual { derivative: numbers[i].derivative + rates[i].value, ..numbers[i] })
    };
    let (positions, speeds) = (along(&state.positions, &rates.positions), along(&state.speeds, &rates.speeds));
    let at_this_time = mechanism.load_conditions(state.time, &state.positions, &state.speeds);
    let later = mechanism.load_conditions(Dual::variable(state.time.value), &positions, &speeds);
    let moved = |k: &usize| -at_this_time[*k].derivative / (later[*k].derivative - at_this_time[*k].derivative);
    conditions.iter().map(moved).collect()
}

/// The conditions of loads that change their signs between two samples; rows of tables are no jumps.
pub(super) fn changed<M: Mechanism<Dual>>(mechanism: &M, ends: [&Sample<M, Dual>; 2]) -> Vec<usize> {
    let conditions = mechanism.description().load_conditions;
    if conditions.is_empty() {
        return Vec::new();
    }
    let [before, after] =
        ends.map(|end| mechanism.load_conditions(end.state.time, &end.state.positions, &end.state.speeds));
    let of_loads = |k: &usize| conditions[*k].table.is_none() && conditions[*k].kind.is_of_loads();
    let changes = |k: &usize| of_loads(k) && crosses([before[*k].value, after[*k].value]);
    (0..conditions.len()).filter(changes).collect()
}

/// The state behind a jump of loads, with what its move adds to its derivative.
pub(super) fn behind_jump<M: Mechanism, L: Mechanism<Dual>>(
    state: &State<L, Dual>,
    MovedJump { samples: [before, after], moved }: &MovedJump<M>,
) -> State<L, Dual> {
    let (before, after) = (before.rates(), after.rates());
    let add = |number: Dual, [before, after]: [f64; 2]| Dual {
        derivative: number.derivative + (before - after) * moved,
        ..number
    };
    State {
        time: state.time,
        // Speeds do not jump.
        positions: state.positions.clone(),
        speeds: state.speeds.like(|i| add(state.speeds[i], [before.speeds[i], after.speeds[i]])),
        work: add(state.work, [before.work, after.work]),
    }
}
