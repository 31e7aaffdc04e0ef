//! Events with their actions.

use super::{Direction, Event, Step};
use crate::dsl;
use crate::model::{self, EventStep};

/// The quantities that a step sets are numbered as in the kernel that computes them.
pub(super) fn events(events: &[model::Event]) -> Vec<Event> {
    let mut values = 0..;
    let mut event = |event: &model::Event| Event {
        name: event.name.clone(),
        direction: match event.direction {
            None => Direction::Both,
            Some(dsl::Direction::Rising) => Direction::Rising,
            Some(dsl::Direction::Falling) => Direction::Falling,
        },
        on_motion: event.on_motion,
        on_forces: event.on_forces,
        steps: event.steps.iter().map(|step| of_step(step, &mut values)).collect(),
    };
    events.iter().map(&mut event).collect()
}

fn of_step(step: &EventStep, values: &mut impl Iterator<Item = usize>) -> Step {
    let mut value = || values.next().unwrap_or_default();
    match step {
        EventStep::Stop(after) => Step::Stop(*after),
        EventStep::Set(sets) => Step::Set(sets.iter().map(|(target, _)| (*target, value())).collect()),
        EventStep::Switch(switches) => Step::Switch(switches.clone()),
        EventStep::Impact(hits) => Step::Impact(hits.iter().map(|(conditional, _)| (*conditional, value())).collect()),
    }
}
