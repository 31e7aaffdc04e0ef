//! Corners of what time drives, as of a drive that starts at full speed: speeds jump there.
//!
//! The jump follows from the impulsive equations (Pfeiffer and Glocker, Multibody Dynamics with Unilateral Contacts, 1996, chapter
//! 8), at one position q, from t- to t+ on both sides of the corner:
//!
//! ```text
//! p(t+) - p(t-) + C_q' L = 0        C_q q'(t+) + C_t(t+) = C_q q'(t-) + C_t(t-)
//! ```
//!
//! with the generalised momentum p = M q' + b, of which b belongs to bodies that time moves. What drives does work: the change of
//! kinetic energy. Positions do not jump; a constraint that asks for it is refused.

use super::changes_in_time::{ASIDE, FARTHER, First, What, stays, tick};
use super::switching::first_known_change;
use crate::motion::Motion;
use crate::motion::equations::impulse;
use crate::motion::residuals::rates;
use crate::state::failure::{Failure, What as Why, constraint_name};
use crate::state::trajectory::{Sample, State};
use sim_kernel::{Array, Mechanism};

/// The part of a scale, or of the terms of a constraint, by which a jump of positions counts, and one of speeds in the longest step.
const LEAST_JUMP: f64 = 1e-9;

/// The change of speeds between two times on both sides of a corner, if it is one, in a motion whose longest step was so long.
///
/// # Errors
/// [`Why::Jump`], and as the equations of an impact.
pub(super) fn corner<M: Mechanism>(
    motion: &Motion<M>,
    state: &State<M>,
    times: [f64; 2],
    longest: f64,
) -> Result<Option<M::Q>, Failure> {
    let change = change(motion, state, times)?;
    Ok(change.filter(|change| motion.size(change) * longest > LEAST_JUMP))
}

/// The same of a corner that coordinates feel little, or not at all, where the kinetic energy would jump at the same speeds: what
/// drives a body does work there too.
///
/// # Errors
/// As [`corner`].
pub(super) fn corner_of_energy<M: Mechanism>(
    motion: &Motion<M>,
    state: &State<M>,
    times: [f64; 2],
) -> Result<Option<M::Q>, Failure> {
    let energy = |time: f64| motion.mechanism().kinetic_energy(time, &state.positions, &state.speeds);
    let apart = |times: [f64; 2]| (energy(times[1]) - energy(times[0])).abs();
    let near = apart(times);
    let (middle, half) = ((times[0] + times[1]) / 2.0, FARTHER * (times[1] - times[0]) / 2.0);
    if near <= LEAST_JUMP * energy(times[0]).max(energy(times[1]))
        || !stays(near, apart([middle - half, middle + half]))
    {
        return Ok(None);
    }
    Ok(Some(change(motion, state, times)?.unwrap_or_else(|| state.speeds.like(|_| 0.0))))
}

/// The change of speeds between two times; none where nothing that time drives jumps.
fn change<M: Mechanism>(motion: &Motion<M>, state: &State<M>, times: [f64; 2]) -> Result<Option<M::Q>, Failure> {
    let (mechanism, q) = (motion.mechanism(), &state.positions);
    let momentum = jump_of_momentum(mechanism, q, times);
    let opened = opened(motion, state, times)?;
    if momentum.iter().all(|part| *part == 0.0) && opened.iter().all(|part| *part == 0.0) {
        return Ok(None);
    }
    let jacobian = mechanism.constraint_linearization(times[1], q).jacobian;
    let (change, _) = impulse(mechanism, times[1], q, &jacobian, (&momentum, &opened))?;
    Ok(Some(change.like(|j| -change[j])))
}

/// Checks that an equal step between two times leads over no corner; one at which constraints say all speeds does no harm.
///
/// # Errors
/// [`Why::CornerInEqualStep`], and as [`corner`].
pub(super) fn check_equal_step<M: Mechanism>(
    motion: &Motion<M>,
    state: &State<M>,
    [now, until]: [f64; 2],
) -> Result<(), Failure> {
    let mechanism = motion.mechanism();
    let functions = mechanism.description().switching;
    if functions.iter().all(|function| function.kind.is_smooth()) {
        return Ok(());
    }
    let (mut from, aside) = (now, ASIDE * tick(now, until));
    while let Some(First { time, what }) = first_known_change(mechanism, functions, from, until) {
        let sides = [(time - aside).max(now), time + aside];
        let may_be = matches!(what, What::Zero | What::Row);
        let found = if may_be { corner(motion, state, sides, until - now)? } else { None };
        if found.is_some() && motion.measures().rank() < mechanism.n() {
            return Err(Failure::at(mechanism, Why::CornerInEqualStep { time }, now, &state.positions));
        }
        from = time;
    }
    Ok(())
}

/// The jump of the momentum of bodies that time moves: b(t+) - b(t-), each b_i by half the difference of the kinetic energies at the
/// speeds 1 and -1 of its coordinate.
fn jump_of_momentum<M: Mechanism>(mechanism: &M, q: &M::Q, times: [f64; 2]) -> M::Q {
    let energy = |time: f64, i: usize, speed: f64| {
        mechanism.kinetic_energy(time, q, &q.like(|j| if i == j { speed } else { 0.0 }))
    };
    if times.iter().all(|time| energy(*time, 0, 0.0) == 0.0) {
        return q.like(|_| 0.0);
    }
    let [before, after] = times.map(|time| q.like(|i| (energy(time, i, 1.0) - energy(time, i, -1.0)) / 2.0));
    q.like(|i| after[i] - before[i])
}

/// The jump of the rates of the constraints, whose positions do not jump.
fn opened<M: Mechanism>(motion: &Motion<M>, state: &State<M>, times: [f64; 2]) -> Result<M::L, Failure> {
    let (mechanism, q) = (motion.mechanism(), &state.positions);
    let [before, after] = times.map(|time| mechanism.constraints(time, q));
    let (sizes, terms) = (motion.measures().constraints(), mechanism.constraint_magnitudes(times[1], q));
    let jump = |row: usize| after[row] - before[row];
    let jumped = (0..mechanism.m()).find(|row| jump(*row).abs() > LEAST_JUMP * sizes[*row].max(terms[*row]));
    if let Some(row) = jumped {
        let what = Why::Jump { constraint: constraint_name(mechanism, row), by: jump(row) };
        return Err(Failure::at(mechanism, what, times[1], q));
    }
    Ok(jump_of_rates(mechanism, state, times))
}

fn jump_of_rates<M: Mechanism>(mechanism: &M, state: &State<M>, times: [f64; 2]) -> M::L {
    let linear = |time: f64| mechanism.constraint_linearization(time, &state.positions);
    let [before, after] = times.map(|time| rates(mechanism, &linear(time), &state.speeds));
    after.like(|row| after[row] - before[row])
}

/// How far what time drives is at another time from what it is at the time of a state: next to nothing on the same side of a corner.
pub(super) fn apart<M: Mechanism>(motion: &Motion<M>, state: &State<M>, time: f64) -> f64 {
    let (mechanism, times) = (motion.mechanism(), [state.time, time]);
    let momentum = jump_of_momentum(mechanism, &state.positions, times);
    let parts = momentum.iter().map(|part| part.abs()).sum::<f64>();
    let [here, there] = times.map(|time| mechanism.kinetic_energy(time, &state.positions, &state.speeds));
    (there - here).abs() + parts + jump_of_rates(mechanism, state, times).iter().map(|rate| rate.abs()).sum::<f64>()
}

/// The sample at a time behind a corner, where speeds have changed by so much.
///
/// # Errors
/// As the projection and the right-hand side.
pub(super) fn behind_corner<M: Mechanism>(
    motion: &Motion<M>,
    from: &Sample<M>,
    time: f64,
    change: &M::Q,
) -> Result<Sample<M>, Failure> {
    motion.prepare(from, time);
    let mut state = from.state.changed(time, time - from.state.time, &from.rates());
    state.speeds = state.speeds.like(|j| from.state.speeds[j] + change[j]);
    motion.keep(&mut state)?;
    let energy = |state: &State<M>| motion.mechanism().kinetic_energy(state.time, &state.positions, &state.speeds);
    state.work += energy(&state) - energy(&from.state);
    motion.sample_in_place(state)
}
