//! Integration step by step: each step is attempted by a method, projected, and shown to whoever watches.

mod control;
mod dop853;
mod dop853_tableau;
mod explicit;
mod lu;
mod method;
#[cfg(test)]
mod order_conditions;
mod radau;
mod tableau;

pub use dop853::Dop853;
pub use dop853_tableau::DOP853;
pub use explicit::ExplicitRungeKutta;
pub use method::{Advance, Attempt};
pub use radau::Radau5;
pub use tableau::{DOPRI5, EULER, ErrorEstimate, HEUN, RK3, RK4, Tableau, Weight};

use crate::failure::{Failure, What};
use crate::mobility::weakest_constraint;
use crate::motion::Motion;
use crate::settings::{Stepping, Tolerance};
use crate::trajectory::{Sample, State};
use control::{Controller, initial_step};
use sim_kernel::{Array, Mechanism};
use std::ops::ControlFlow;
use std::sync::atomic::{AtomicBool, Ordering};

/// A step that was made.
pub struct Step<'s, M: Mechanism, A> {
    /// The motion.
    pub motion: &'s Motion<'s, M>,
    /// Its start.
    pub from: &'s Sample<M>,
    /// Its end, on the constraints.
    pub to: &'s Sample<M>,
    method: &'s mut A,
}

impl<M: Mechanism, A: Advance<M>> Step<'_, M, A> {
    /// Its length in seconds.
    pub fn length(&self) -> f64 {
        self.to.state.time - self.from.state.time
    }

    /// The state at a time inside it, on the constraints.
    ///
    /// # Errors
    /// As the projection and the right-hand side.
    pub fn at(&mut self, time: f64) -> Result<State<M>, Failure> {
        if time == self.to.state.time {
            return Ok(self.to.state);
        }
        let fraction = (time - self.from.state.time) / self.length();
        let mut state = self.method.inside(self.motion, self.from, self.to, fraction)?;
        state.time = time;
        self.motion.keep(&mut state)?;
        Ok(state)
    }
}

/// How many steps were made.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Steps {
    /// Accepted.
    pub accepted: u64,
    /// Attempted and refused, because their error was too large or they failed.
    pub rejected: u64,
}

/// When and how far to integrate.
#[derive(Clone, Copy, Debug)]
pub struct Course {
    /// Where equal steps are counted from, in seconds.
    pub begin: f64,
    /// The end, in seconds.
    pub end: f64,
    /// How long the steps are.
    pub stepping: Stepping,
    /// Ends the integration once it is true.
    pub interrupt: Option<&'static AtomicBool>,
}

/// Integrates from a sample on the constraints. Every step goes to `watch`, which may end the integration.
///
/// # Errors
/// The first failure that smaller steps do not avoid, or that `watch` reports.
pub fn integrate<M: Mechanism, A: Advance<M>>(
    motion: &Motion<M>,
    method: &mut A,
    course: &Course,
    start: Sample<M>,
    steps: &mut Steps,
    watch: impl FnMut(&mut Step<M, A>) -> Result<ControlFlow<()>, Failure>,
) -> Result<(), Failure> {
    match (course.stepping, method.control_order()) {
        (Stepping::Equal(count), _) => equal_steps(motion, method, course, count, start, steps, watch),
        (Stepping::Adaptive(tolerance), Some(order)) => {
            adaptive_steps(motion, method, course, (&tolerance, order), start, steps, watch)
        }
        (Stepping::Adaptive(_), None) => {
            Err(Failure::at::<M>(What::NoErrorEstimate, start.state.time, &start.state.positions))
        }
    }
}

fn equal_steps<M: Mechanism, A: Advance<M>>(
    motion: &Motion<M>,
    method: &mut A,
    course: &Course,
    count: usize,
    start: Sample<M>,
    steps: &mut Steps,
    mut watch: impl FnMut(&mut Step<M, A>) -> Result<ControlFlow<()>, Failure>,
) -> Result<(), Failure> {
    let (begin, mut from) = (course.begin, start);
    for step in 1..=count {
        check_interrupt(course, &from)?;
        // From the start each time, so that times do not accumulate rounding.
        let time = if step == count { course.end } else { begin + (course.end - begin) * (step as f64 / count as f64) };
        if time - from.state.time <= 4.0 * f64::EPSILON * time.abs() {
            continue;
        }
        let (to, _) = attempt(motion, method, &from, time, None)?;
        steps.accepted += 1;
        if watch(&mut Step { motion, method, from: &from, to: &to })?.is_break() {
            return Ok(());
        }
        from = to;
    }
    Ok(())
}

fn adaptive_steps<M: Mechanism, A: Advance<M>>(
    motion: &Motion<M>,
    method: &mut A,
    course: &Course,
    (tolerance, order): (&Tolerance, f64),
    start: Sample<M>,
    steps: &mut Steps,
    mut watch: impl FnMut(&mut Step<M, A>) -> Result<ControlFlow<()>, Failure>,
) -> Result<(), Failure> {
    let mut from = start;
    let mut controller = Controller::new(order);
    let mut h = initial_step(motion, &from, course.end - from.state.time, order, tolerance)?;
    while from.state.time < course.end {
        check_interrupt(course, &from)?;
        let now = from.state.time;
        // The last step is not followed by a tiny one.
        let time = if now + 1.01 * h >= course.end { course.end } else { now + h };
        let made = attempt(motion, method, &from, time, Some(tolerance));
        match made {
            Ok((to, error)) if error <= 1.0 => {
                steps.accepted += 1;
                if watch(&mut Step { motion, method, from: &from, to: &to })?.is_break() {
                    return Ok(());
                }
                h = (time - now) * controller.accepted(error);
                from = to;
            }
            refused => {
                steps.rejected += 1;
                h = (time - now) * controller.rejected(refused.as_ref().ok().map(|(_, error)| *error));
                if h < 16.0 * f64::EPSILON * now.abs().max(1e-3 * course.end) {
                    return Err(too_small(motion, &from.state, h, refused.err()));
                }
            }
        }
    }
    Ok(())
}

/// A constraint whose rows are this near to depending on others, as a sine, explains why no step is small enough.
const NEARLY_SINGULAR: f64 = 1e-3;

/// Why no step is small enough: a singular position, what the last attempt failed with, or the tolerance.
fn too_small<M: Mechanism>(motion: &Motion<M>, at: &State<M>, step: f64, cause: Option<Failure>) -> Failure {
    let weakest = weakest_constraint(motion.mechanism(), at.time, &at.positions);
    match weakest.filter(|(_, sine)| *sine < NEARLY_SINGULAR) {
        Some((constraint, _)) => Failure::at::<M>(What::SingularPosition { constraint }, at.time, &at.positions),
        None => cause.unwrap_or_else(|| Failure::at::<M>(What::StepTooSmall { step }, at.time, &at.positions)),
    }
}

/// How far projection may move the end of a step, in units of the tolerance: further is another branch of the motion.
const MOST_MOVED: f64 = 1000.0;

/// The differences of positions and speeds.
fn difference<M: Mechanism>(a: &State<M>, b: &State<M>) -> (M::Q, M::Q) {
    (M::Q::from_fn(|i| a.positions[i] - b.positions[i]), M::Q::from_fn(|i| a.speeds[i] - b.speeds[i]))
}

/// One step, with its end on the constraints and the estimate of its error.
#[inline]
fn attempt<M: Mechanism, A: Advance<M>>(
    motion: &Motion<M>,
    method: &mut A,
    from: &Sample<M>,
    time: f64,
    tolerance: Option<&Tolerance>,
) -> Result<(Sample<M>, f64), Failure> {
    motion.prepare(&from.state)?;
    let Attempt { mut end, error } = method.step(motion, from, time, tolerance)?;
    if !(error <= 1.0) {
        return Ok((*from, error));
    }
    let before = end;
    motion.keep(&mut end)?;
    let moved = tolerance.map_or(0.0, |tolerance| tolerance.norm(&before, &end, &difference(&before, &end)));
    Ok((motion.sample(end)?, error.max(moved / MOST_MOVED)))
}

fn check_interrupt<M: Mechanism>(course: &Course, at: &Sample<M>) -> Result<(), Failure> {
    match course.interrupt.is_some_and(|interrupt| interrupt.load(Ordering::Relaxed)) {
        true => Err(Failure::at::<M>(What::Interrupted, at.state.time, &at.state.positions)),
        false => Ok(()),
    }
}
