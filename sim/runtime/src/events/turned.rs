//! Whether events have turned conditions back.

use super::conditions::tolerance;
use super::described::{struck, through};
use super::held::holds_positions;
use super::onset::Onset;
use super::{Crossing, Occurrence};
use crate::motion::Motion;
use crate::motion::residuals::rates;
use crate::state::trajectory::State;
use sim_kernel::{Array, Mechanism};

/// The speed at which a condition turns back, relative to that at which it came, that is not rounding.
const TURNED: f64 = 1e-3;
/// A change of a condition's rate that is rounding, relative to it: rates are differences over the accuracy of times.
const KEPT: f64 = 1e-6;

/// Whether a condition that crosses zero by the speeds of one state turns back by those of another, at the same time and place.
pub(super) fn is_turned_back<M: Mechanism>(
    mechanism: &M,
    states: [&State<M>; 2],
    (event, crossing): (usize, Crossing),
    span: f64,
) -> bool {
    let described = &mechanism.description().events[event];
    let through = match crossing {
        Crossing::Rising => 1.0,
        Crossing::Falling => -1.0,
        Crossing::Touching => return false,
    };
    let [before, after] = states.map(|state| through * change(mechanism, state, event, span));
    !described.on_forces && before > 0.0 && after < -TURNED * before
}

/// Whether a condition holds at a start and leaves against the direction in which its event counts.
pub(super) fn turns_back<M: Mechanism>(mechanism: &M, onset: &Onset<M>, index: usize) -> bool {
    let through = through(&mechanism.description().events[index]);
    through.is_some_and(|through| onset.holds(index) && onset.leaving(index) == -through)
}

/// Whether the blow of an event that has just happened has not done what it is for, by the state now, in which its condition leaves
/// through zero again. It has changed the rate of its condition, which stands still, or the struck constraints close again. Or there
/// was no rate to change, and the condition is pressed through those constraints. A condition that only says where a blow is given, as
/// a place at which a brake is applied, may go on; so may one whose speed has been set, as of a train that stops for a moment.
pub(super) fn hits_in_vain<M: Mechanism>(
    motion: &Motion<M>,
    last: &Occurrence<M>,
    (now, rests): (&State<M>, bool),
    span: f64,
) -> bool {
    let Some(given) = &last.change else { return false };
    let mechanism = motion.mechanism();
    let change = |state: &State<M>| change(mechanism, state, last.event, span);
    let (was, kept) = (change(&last.state), change(&given.state));
    let hits = struck(&mechanism.description().events[last.event]);
    if hits.is_empty() {
        return false;
    }
    if (kept - was).abs() <= KEPT * was.abs() {
        let holds = |conditional: &usize| mechanism.activities()[*conditional] == 1.0;
        let with_struck = struck_too(mechanism, &hits);
        let sizes = motion.measures().coordinates();
        return rests && !hits.iter().all(holds) && holds_positions(&with_struck, now, sizes, last.event);
    }
    let mut closing = closing(mechanism, &hits, &last.state).into_iter().zip(closing(mechanism, &hits, now));
    change(now).abs() <= TURNED * was.abs() || closing.any(|(was, is)| was * is > KEPT * was * was)
}

/// The change of a condition about a state, by its speeds.
fn change<M: Mechanism>(mechanism: &M, state: &State<M>, event: usize, span: f64) -> f64 {
    let (zero, none) = (state.positions.like(|_| 0.0), M::L::repeat(mechanism.m(), 0.0));
    let d = 100.0 * tolerance(state.time, span);
    let at = |d: f64| {
        let q = state.positions.like(|j| state.positions[j] + d * state.speeds[j]);
        mechanism.events(state.time + d, &q, &state.speeds, &zero, &none)[event]
    };
    at(d) - at(-d)
}

/// The rates of the constraints that blows strike, as if they held.
fn closing<M: Mechanism>(mechanism: &M, struck: &[usize], state: &State<M>) -> Vec<f64> {
    let mechanism = struck_too(mechanism, struck);
    let linear = mechanism.constraint_linearization(state.time, &state.positions);
    let rates = rates(&mechanism, &linear, &state.speeds);
    let rows = struck.iter().flat_map(|conditional| {
        let described = &mechanism.description().conditionals[*conditional];
        described.first_row..described.first_row + described.rows
    });
    rows.map(|row| rates[row]).collect()
}

/// The mechanism with these constraints as if they held.
fn struck_too<M: Mechanism>(mechanism: &M, struck: &[usize]) -> M {
    let mut activities = mechanism.activities();
    struck.iter().for_each(|conditional| activities[*conditional] = 1.0);
    mechanism.clone().with_activities(activities)
}
