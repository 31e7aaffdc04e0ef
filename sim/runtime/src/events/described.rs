//! What the declaration says of an event: whether it acts, in which direction it counts, what it switches.

use sim_kernel::Mechanism;
use sim_kernel::event::{Direction, Event, Step, Switch, Target};

/// Whether any event does something.
#[inline(always)]
pub(super) fn any_acts(events: &[Event]) -> bool {
    events.iter().any(|event| !event.steps.is_empty())
}

/// The constraints that an event switches.
fn switched(event: &Event) -> impl Iterator<Item = &Switch> {
    event.steps.iter().flat_map(|step| match step {
        Step::Switch(switches) => *switches,
        _ => &[],
    })
}

/// Whether an event changes the motion itself, and not only what acts on it or whether it goes on.
pub(super) fn moves(event: &Event) -> bool {
    event.steps.iter().any(|step| match step {
        Step::Stop(_) => false,
        Step::Set(assignments) => assignments.iter().any(|set| !matches!(set.target, Target::Parameter(_))),
        Step::Switch(_) | Step::Impact(_) => true,
    })
}

/// The constraints that an event strikes.
pub(super) fn struck(event: &Event) -> Vec<usize> {
    let hits = event.steps.iter().flat_map(|step| match step {
        Step::Impact(hits) => *hits,
        _ => &[],
    });
    hits.map(|hit| hit.conditional).collect()
}

/// Whether an event switches a constraint on that is released, or off that holds.
pub(super) fn switches<M: Mechanism>(mechanism: &M, event: &Event, on: bool) -> bool {
    let activities = mechanism.activities();
    switched(event).any(|switch| switch.active == on && (activities[switch.conditional] == 1.0) != on)
}

/// Whether an event switches constraints on that hold already.
pub(super) fn is_done<M: Mechanism>(mechanism: &M, event: &Event) -> bool {
    switched(event).any(|switch| switch.active) && !switches(mechanism, event, true)
}

/// Whether an event releases a constraint because of a force: a latch lets go where its load jumps past its limit.
pub(super) fn releases(event: &Event) -> bool {
    event.on_forces && switched(event).any(|switch| !switch.active)
}

/// Whether an event minds that its condition leaves zero, and not only that it comes there: what rests at what it strikes or is caught
/// by is pressed against it, and what nothing has held is pulled.
pub(super) fn minds_leaving<M: Mechanism>(mechanism: &M, event: &Event) -> bool {
    !struck(event).is_empty() || releases(event) || switches(mechanism, event, true)
}

/// The sign of the rate with which a condition crosses zero in an event's direction, if it has one.
pub(super) fn through(described: &Event) -> Option<f64> {
    match described.direction {
        Direction::Rising => Some(1.0),
        Direction::Falling => Some(-1.0),
        Direction::Both => None,
    }
}
