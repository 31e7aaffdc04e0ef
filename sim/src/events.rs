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
/// interpolant. A condition that holds at the very start does not count.
///
/// # Errors
/// As the projection of an interpolated state.
pub fn locate_events<M: Mechanism>(mechanism: &M, samples: &[Sample<M>]) -> Result<Vec<Occurrence<M>>, Failure> {
    let mut found = Vec::new();
    for pair in samples.windows(2) {
        let [from, to] = pair else { continue };
        let (before, after) = (values(mechanism, &from.state), values(mechanism, &to.state));
        let first = found.len();
        for (event, name) in M::DESCRIPTION.events.iter().enumerate() {
            if crosses(before[event], after[event]) {
                let state = locate(mechanism, from, to, event, before[event], after[event])?;
                found.push(Occurrence { name, state });
            }
        }
        found[first..].sort_by(|a, b| a.state.time.total_cmp(&b.state.time));
    }
    Ok(found)
}

fn values<M: Mechanism>(mechanism: &M, state: &State<M>) -> M::Events {
    mechanism.events(state.time, &state.positions, &state.speeds)
}

/// A change of sign; reaching zero counts, leaving it does not.
fn crosses(before: f64, after: f64) -> bool {
    before != 0.0 && (after == 0.0 || (before < 0.0) != (after < 0.0))
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
    let tolerance = f64::max(1e-12, 4.0 * f64::EPSILON * to.state.time.abs()) / h;
    let at = |fraction: f64| interpolate(mechanism, from, to, fraction);
    let fraction = find_root(before, after, tolerance, |fraction| Ok(values(mechanism, &at(fraction)?)[event]))?;
    at(fraction)
}
