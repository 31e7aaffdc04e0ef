//! When the declared events happen.

use crate::failure::Failure;
use crate::interpolate::interpolate;
use crate::root::find_root;
use crate::trajectory::{Sample, State};
use sim_kernel::Mechanism;

/// A crossing of an event's condition.
#[derive(Clone, Debug)]
pub struct Occurrence<M: Mechanism> {
    /// The event's name.
    pub name: &'static str,
    /// When and where: time, positions and speeds.
    pub state: State<M>,
}

/// All crossings along the samples, in the order of time, located to max(1e-12 s, 4 ulp of t) on the projected
/// interpolant; with the failure that ended the search, if one did.
///
/// A condition that holds at the very start, to that tolerance, does not count, and neither does a change of sign
/// by a jump or a pole, or where the condition is not finite. Two crossings within one step are not seen.
pub fn locate_events<M: Mechanism>(mechanism: &M, samples: &[Sample<M>]) -> (Vec<Occurrence<M>>, Option<Failure>) {
    let mut found: Vec<Occurrence<M>> = Vec::new();
    let Some(start) = samples.first().map(|sample| sample.state.time) else { return (found, None) };
    for pair in samples.windows(2) {
        let [from, to] = pair else { continue };
        let (before, after) = (values(mechanism, &from.state), values(mechanism, &to.state));
        let first = found.len();
        for (event, name) in M::DESCRIPTION.events.iter().enumerate() {
            if !crosses(before[event], after[event]) {
                continue;
            }
            match locate(mechanism, from, to, event, before[event], after[event]) {
                Ok(state) => {
                    let is_zero = is_root(values(mechanism, &state)[event], before[event], after[event]);
                    if is_zero && state.time - start > 2.0 * tolerance(state.time) {
                        found.push(Occurrence { name, state });
                    }
                }
                Err(failure) => return (found, Some(failure)),
            }
        }
        found[first..].sort_by(|a, b| a.state.time.total_cmp(&b.state.time));
    }
    (found, None)
}

fn values<M: Mechanism>(mechanism: &M, state: &State<M>) -> M::Events {
    mechanism.events(state.time, &state.positions, &state.speeds)
}

/// A change of sign between numbers; reaching zero counts, leaving it does not.
fn crosses(before: f64, after: f64) -> bool {
    let finite = before.is_finite() && after.is_finite();
    finite && before != 0.0 && (after == 0.0 || (before < 0.0) != (after < 0.0))
}

/// Whether the value where the sign changes has come near zero; at a jump or a pole it has not.
fn is_root(value: f64, before: f64, after: f64) -> bool {
    value.abs() <= 0.5 * before.abs().max(after.abs())
}

/// To what a time is located, in seconds.
fn tolerance(time: f64) -> f64 {
    f64::max(1e-12, 4.0 * f64::EPSILON * time.abs())
}

fn locate<M: Mechanism>(
    mechanism: &M,
    from: &Sample<M>,
    to: &Sample<M>,
    event: usize,
    before: f64,
    after: f64,
) -> Result<State<M>, Failure> {
    if after == 0.0 {
        return Ok(to.state);
    }
    let h = to.state.time - from.state.time;
    let tolerance = tolerance(to.state.time) / h;
    let at = |fraction: f64| interpolate(mechanism, from, to, fraction);
    let fraction = find_root(before, after, tolerance, |fraction| Ok(values(mechanism, &at(fraction)?)[event]))?;
    at(fraction)
}
