//! Changes of sign by a jump or a pole, which are no zeros of a condition.

use super::EventSearch;
use super::conditions::{tolerance, value};
use crate::integrate::Step;
use crate::state::failure::Failure;
use sim_kernel::Mechanism;

/// A change of a condition within the accuracy of times that is as small as this, relative to its largest value, is no jump.
const SMALL: f64 = 1e-9;
/// The same relative to its values at the ends of the interval in which it was located.
const PART: f64 = 1e-3;
/// A condition changes within so many times the time by twice as much at least: a cube root by four times as much.
const LONGER: f64 = 64.0;

impl<M: Mechanism> EventSearch<M> {
    /// Whether a condition changes its sign at this time by a jump or a pole; `found` is its value there, `before` and `after` are
    /// those at the ends of the interval in which it was located. Next to a zero it changes the more, the longer the time; by a
    /// jump as much in any.
    pub(super) fn is_jump(
        &self,
        step: &mut Step<M>,
        event: usize,
        time: f64,
        [found, before, after]: [f64; 3],
    ) -> Result<bool, Failure> {
        let at_ends = before.abs().max(after.abs());
        if found.abs() > 0.5 * at_ends {
            return Ok(true);
        }
        let accuracy = 2.0 * tolerance(time, self.span);
        let mut change = |within: f64| -> Result<f64, Failure> {
            Ok((value(step, time + within, event)? - value(step, time - within, event)?).abs())
        };
        let noise = self.onset.as_ref().map_or(0.0, |onset| onset.noise[event]);
        let sudden = change(accuracy)?;
        let is_small = sudden <= noise.max(SMALL * self.largest[event]).max(PART * at_ends);
        Ok(!is_small && sudden > 0.5 * change(LONGER * accuracy)?)
    }
}
