//! Integration step by step: each step is attempted by a method, projected, and passed to the watcher.

mod attempt;
mod beside;
mod better_end;
mod change_of_load;
mod changes_in_time;
mod changes_of_loads;
mod control;
mod corners;
mod crossing;
mod dense;
mod dop853;
mod dop853_tableau;
mod equal;
mod explicit;
mod headway;
mod integrator;
mod jump;
mod jumps_of_loads;
mod method;
#[cfg(test)]
mod order_conditions;
mod pace;
mod plain;
mod radau;
mod short_pulses;
mod stability;
mod step;
mod stepper;
mod sticking;
mod switching;
mod table_rows;
mod tableau;
mod target;
mod unseen_work;

pub(crate) use beside::first_sample;
pub(crate) use changes_in_time::{FARTHER, around_end, form, leads_over_change, stays};
pub use dop853::Dop853;
pub use dop853_tableau::DOP853;
pub use explicit::ExplicitRungeKutta;
pub(crate) use integrator::{Integrator, tableau};
pub(crate) use jump::jump_by;
pub use method::{Advance, Attempt};
pub(crate) use plain::{Reached, attempt_plainly};
pub use radau::Radau5;
pub use stability::Stability;
pub(crate) use step::MOST_PARTS;
pub use step::Step;
pub(crate) use stepper::Stepper;
pub use switching::SuddenChanges;
pub(crate) use switching::leads_over_row_that_jumps;
pub use tableau::{DOPRI5, EULER, ErrorEstimate, HEUN, RK3, RK4, Tableau, Weight};
pub(crate) use target::{Aim, Target};

use crate::motion::Motion;
use crate::motion::singular::Singularity;
use crate::state::failure::Failure;
use crate::state::saved::{Bytes, Damaged};
use crate::state::settings::{Settings, Stepping};
use crate::state::trajectory::Sample;
use sim_kernel::Mechanism;
use std::ops::ControlFlow;

/// The number of steps made.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Steps {
    /// Accepted.
    pub accepted: u64,
    /// Attempted and refused, because their error was too large or they failed.
    pub rejected: u64,
    /// The singular positions that they passed, in order.
    pub singularities: Vec<Singularity>,
    /// Equal ones that led over sudden changes of what acts on the mechanism, if any did.
    pub sudden_changes: Option<SuddenChanges>,
    /// Those over corners of what time drives, where speeds jump, if any did.
    pub corners: Option<SuddenChanges>,
    /// What limits their length.
    pub stability: Stability,
}

impl Steps {
    /// All of it as bytes, or from them.
    pub(crate) fn transfer<M: Mechanism>(&mut self, mechanism: &M, bytes: &mut Bytes) -> Result<(), Damaged> {
        bytes.tally(&mut self.accepted)?;
        bytes.tally(&mut self.rejected)?;
        SuddenChanges::transfer(&mut self.sudden_changes, bytes)?;
        SuddenChanges::transfer(&mut self.corners, bytes)?;
        self.stability.transfer(bytes)?;
        transfer_singularities(mechanism, &mut self.singularities, bytes)
    }
}

/// Singular positions as bytes, or from them.
fn transfer_singularities<M: Mechanism>(
    mechanism: &M,
    list: &mut Vec<Singularity>,
    bytes: &mut Bytes,
) -> Result<(), Damaged> {
    let none = || Singularity { constraint: "", time: 0.0, sine: 0.0 };
    bytes.list(list, none, |bytes, Singularity { constraint, time, sine }| {
        bytes.constraint(mechanism, constraint)?;
        bytes.number(time)?;
        bytes.number(sine)
    })
}

/// When and how far to integrate.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Course {
    /// The time from which equal steps are counted, in seconds.
    pub begin: f64,
    /// The end, in seconds.
    pub end: f64,
    /// The length of the steps.
    pub stepping: Stepping,
}

impl Course {
    /// The course to an end, for a run that began at this time. To an earlier end, equal steps are as long as those of
    /// the whole run, or a little shorter if the end lies between two of them.
    pub(crate) fn new(settings: &Settings, begin: f64, end: f64) -> Course {
        let stepping = match settings.stepping {
            Stepping::Equal(count) if end < settings.end => {
                let part = (end - begin) / (settings.end - begin);
                // A little less than rounding could add to a whole number of steps.
                Stepping::Equal((part * count as f64 - 1e-6).ceil().max(1.0) as usize)
            }
            stepping => stepping,
        };
        Course { begin, end, stepping }
    }
}

/// Integrates from a sample on the constraints. Every step goes to `watch`, which may end the integration.
///
/// # Errors
/// The first failure that smaller steps do not avoid, or that `watch` reports.
pub fn integrate<M: Mechanism>(
    motion: &Motion<M>,
    method: &mut dyn Advance<M>,
    course: &Course,
    start: Sample<M>,
    steps: &mut Steps,
    mut watch: impl FnMut(&mut Step<M>) -> Result<ControlFlow<()>, Failure>,
) -> Result<(), Failure> {
    let mut stepper = Stepper::new(motion, method, course, start)?;
    while stepper.advance(motion, method, steps)? {
        let Some(mut step) = stepper.last_step(motion, method) else { break };
        if watch(&mut step)?.is_break() {
            break;
        }
    }
    Ok(())
}
