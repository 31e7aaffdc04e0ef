//! Equal steps over smooth pulses of loads that are too short for them.
//!
//! A step is short enough where a load changes little in half a step from the middle of its pulse, compared with two steps, at the
//! speeds of the middle. In steps of 1.4 w over `exp(-(t/w)^2)` these changes are as 0.4 to 1, and `rk4` finds its impulse to a
//! hundredth; of loads that change at a constant rate they are as 0.25 to 1.

use super::Step;
use super::changes_in_time::{First, What, first_change};
use super::jump::difference;
use crate::state::failure::Failure;
use crate::state::trajectory::State;
use sim_kernel::{Mechanism, Switching};

/// How far from the middle of a pulse loads are compared with those there, in steps, and the largest ratio of both changes.
const NEAR: f64 = 0.5;
const FAR: f64 = 2.0;
const MOST: f64 = 0.4;

/// The middle of a pulse within a step, by positions at one of the given times or of time alone, that is too short for the step.
///
/// # Errors
/// As the dense output and the right-hand side.
pub(super) fn short_pulse<M: Mechanism>(
    step: &mut Step<M>,
    by_positions: impl Iterator<Item = f64>,
) -> Result<Option<f64>, Failure> {
    let ends = [step.from, step.to].map(|sample| sample.state.time);
    for middle in by_positions.chain(middles_in_time(step.motion.mechanism(), ends)) {
        if is_short(step, middle)? {
            return Ok(Some(middle));
        }
    }
    Ok(None)
}

/// The middles of pulses of time alone between two times. There may be many: each is found when it is asked for.
fn middles_in_time<M: Mechanism>(mechanism: &M, [mut from, until]: [f64; 2]) -> impl Iterator<Item = f64> {
    let functions: &[Switching] = mechanism.description().switching;
    let has_middles = functions.iter().any(|function| function.kind.is_smooth());
    let changes = std::iter::from_fn(move || {
        let first = has_middles.then(|| first_change(mechanism, functions, from, until)).flatten()?;
        from = first.time;
        Some(first)
    });
    changes.filter(|change| change.what == What::Middle).map(move |First { time, .. }| time.min(until))
}

/// Whether accelerations change from the middle to near places before and after it by so large a part of what they change by to
/// farther ones.
fn is_short<M: Mechanism>(step: &mut Step<M>, middle: f64) -> Result<bool, Failure> {
    let (motion, length, at_middle) = (step.motion, step.length(), step.sample(middle)?);
    let (state, rates) = (&at_middle.state, at_middle.rates());
    let change = |distance: f64| -> Result<f64, Failure> {
        let moved = State { speeds: state.speeds.clone(), ..state.changed(middle + distance, distance, &rates) };
        Ok(motion.size(&difference(&[at_middle.clone(), motion.sample(moved)?])))
    };
    let both_sides = |distance: f64| Ok(change(-distance)? + change(distance)?);
    Ok(both_sides(NEAR * length)? > MOST * both_sides(FAR * length)?)
}
