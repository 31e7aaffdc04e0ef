//! Events whose actions are carried out by a run alone.

use sim_kernel::Description;
use sim_kernel::event::Step;

/// The events that would change the mechanism in a run.
pub(super) fn idle_events(description: &Description) -> Vec<&'static str> {
    let changes = |step: &Step| !matches!(step, Step::Stop(_));
    description.events.iter().filter(|event| event.steps.iter().any(changes)).map(|event| event.name).collect()
}

/// The same as a line, if there are any.
pub(super) fn only_in_runs(description: &Description) -> Option<String> {
    let events = idle_events(description);
    (!events.is_empty())
        .then(|| format!("only a run takes the actions of {}: here all is as declared", events.join(", ")))
}

/// The same after a run up to a state: what its events have done holds.
pub(super) fn only_until_then(description: &Description) -> Option<String> {
    let events = idle_events(description);
    (!events.is_empty()).then(|| format!("all is as {} left it; what they do later is not in it", events.join(", ")))
}
