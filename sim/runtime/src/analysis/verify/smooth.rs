//! How far a run is smooth.

use crate::integrate::form;
use crate::run::Run;
use crate::state::trajectory::{Sample, State, Trajectory};
use sim_kernel::{Array, Description, Mechanism, Switching};

/// The time until which a run is smooth: its first event that changes something, the last sample before a load changes its form, and
/// well before its first singular position, where the amplification of rounding and step errors has a pole.
pub(super) fn smooth<M: Mechanism>(run: &Run<M>, end: f64) -> f64 {
    let Trajectory { samples, phases, .. } = &run.trajectory;
    let event = phases.get(1).map_or(end, |phase| samples[phase.first].state.time);
    let event = event.min(before_change_of_form(&run.mechanism, samples).unwrap_or(event));
    let begin = samples[0].state.time;
    let before = |singular: f64| begin + 0.75 * (singular - begin);
    run.steps.singularities.first().map_or(event, |singular| event.min(before(singular.time)))
}

/// The last sample before a load or what time drives changes its form, as at a row of a table.
fn before_change_of_form<M: Mechanism>(mechanism: &M, samples: &[Sample<M>]) -> Option<f64> {
    let Description { load_conditions, switching, .. } = mechanism.description();
    let forms = |sample: &Sample<M>| {
        let State { time, positions, speeds, .. } = &sample.state;
        let of_loads = mechanism.load_conditions(*time, positions, speeds);
        let of_time = mechanism.switching_functions(*time);
        let all = load_conditions.iter().zip(of_loads.iter()).chain(switching.iter().zip(of_time.iter()));
        let sudden = all.filter(|(function, _)| !function.kind.is_smooth());
        // A condition at its zero has the form of either side.
        let known = |(function, value): (&Switching, &f64)| {
            (function.table.is_some() || *value != 0.0).then(|| form(function, *value))
        };
        sudden.map(known).collect::<Vec<Option<f64>>>()
    };
    let (first, others) = samples.split_first()?;
    let (mut known, mut last) = (forms(first), first.state.time);
    for sample in others {
        for (known, form) in known.iter_mut().zip(forms(sample)) {
            if known.is_some() && form.is_some() && *known != form {
                return Some(last);
            }
            *known = form.or(*known);
        }
        last = sample.state.time;
    }
    None
}
