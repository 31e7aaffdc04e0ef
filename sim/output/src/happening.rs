//! Events as text, with their effects.

use crate::outcome::Happening;
use sim_kernel::Description;
use sim_kernel::event::{Direction, Event, Step, Target};
use sim_runtime::Crossing;

/// The direction in which a condition passes zero and the actions: `falling: impact floor, set dot(x)`.
pub fn happening(event: &Event, description: &Description) -> String {
    let direction = match event.direction {
        Direction::Both => "rising or falling",
        Direction::Rising => "rising",
        Direction::Falling => "falling",
    };
    match does(event, description) {
        actions if actions.is_empty() => direction.to_owned(),
        actions => format!("{direction}: {actions}"),
    }
}

/// The actions of an event.
pub(crate) fn does(event: &Event, description: &Description) -> String {
    let conditional = |index: usize| description.conditionals[index].name;
    let mut words = Vec::new();
    for step in event.steps {
        match step {
            Step::Stop(1) => words.push("stop".to_owned()),
            Step::Stop(after) => words.push(format!("stop after {after}")),
            Step::Set(sets) => words.extend(sets.iter().map(|set| match set.target {
                Target::Parameter(index) => format!("set {}", description.parameters[index].name),
                Target::Position(index) => format!("set {}", description.coordinates[index].position.name),
                Target::Speed(index) => format!("set dot({})", description.coordinates[index].position.name),
            })),
            Step::Switch(switches) => words.extend(switches.iter().map(|switch| {
                let word = if switch.active { "activate" } else { "release" };
                format!("{word} {}", conditional(switch.conditional))
            })),
            Step::Impact(hits) => {
                words.extend(hits.iter().map(|hit| format!("impact {}", conditional(hit.conditional))));
            }
        }
    }
    words.join(", ")
}

/// The direction of the crossing.
pub(crate) fn crossing(crossing: Crossing) -> &'static str {
    match crossing {
        Crossing::Rising => "rising",
        Crossing::Falling => "falling",
        Crossing::Touching => "touching",
    }
}

/// The impulses of an event that are not zero: the constraint, the impulse in the unit of its multiplier times a second, and
/// that unit.
pub fn impulses(event: &Happening, description: &Description) -> Vec<(&'static str, f64, String)> {
    let Some(change) = &event.change else { return Vec::new() };
    let rows = description.constraints.iter().zip(&change.impulses);
    let unit = |unit: &str| if unit == "1" { "s".to_owned() } else { format!("{unit}*s") };
    rows.filter(|(_, impulse)| **impulse != 0.0)
        .map(|(c, impulse)| (c.name, impulse / c.factor, unit(c.unit)))
        .collect()
}
