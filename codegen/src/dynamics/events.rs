//! Conditions of events, and what their actions need.

use crate::model::{EventStep, Model};
use crate::symbolic::Expr;

/// The events of a model, in the order of declaration.
pub struct Events {
    /// left - right of each.
    pub conditions: Vec<Expr>,
    /// What their actions set, and the coefficients of restitution of impacts, in order.
    pub settings: Vec<Expr>,
}

impl Events {
    pub(super) fn of(model: &Model) -> Events {
        let steps = model.events.iter().flat_map(|event| &event.steps);
        let settings = steps.flat_map(|step| match step {
            EventStep::Set(sets) => sets.iter().map(|(_, value)| *value).collect(),
            EventStep::Impact(hits) => hits.iter().map(|(_, coefficient)| *coefficient).collect(),
            EventStep::Stop(_) | EventStep::Switch(_) => vec![],
        });
        let conditions = model.events.iter().map(|event| event.value);
        Events { conditions: conditions.collect(), settings: settings.collect() }
    }
}
