//! Integration step by step: each step is attempted by a method, projected, and shown to whoever watches.

mod beside;
mod control;
mod crossing;
mod dop853;
mod dop853_tableau;
mod explicit;
mod headway;
mod lu;
mod method;
#[cfg(test)]
mod order_conditions;
mod radau;
mod step;
mod tableau;

pub(crate) use beside::first_sample;
pub use dop853::Dop853;
pub use dop853_tableau::DOP853;
pub use explicit::ExplicitRungeKutta;
pub use method::{Advance, Attempt};
pub use radau::Radau5;
pub use step::Step;
pub use tableau::{DOPRI5, EULER, ErrorEstimate, HEUN, RK3, RK4, Tableau, Weight};

use crate::failure::{Failure, What};
use crate::gimbal;
use crate::motion::Motion;
use crate::settings::{Stepping, Tolerance};
use crate::singular::{AT, Singularity, weakest_constraint};
use crate::trajectory::{Sample, State};
use crate::velocity_variables::has_generalized_speeds;
use control::{Controller, initial_step};
use crossing::{Crossing, Way};
use headway::Headway;
use sim_kernel::{Array, Mechanism};
use std::mem::swap;
use std::ops::ControlFlow;
use std::sync::atomic::{AtomicBool, Ordering};

/// How many steps were made.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Steps {
    /// Accepted.
    pub accepted: u64,
    /// Attempted and refused, because their error was too large or they failed.
    pub rejected: u64,
    /// The singular positions that they passed, in order.
    pub singularities: Vec<Singularity>,
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

/// Whoever watches the steps.
type Watch<'w, M> = dyn FnMut(&mut Step<M>) -> Result<ControlFlow<()>, Failure> + 'w;

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
    // Compiled once, whoever watches.
    let watch: &mut Watch<M> = &mut watch;
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

fn equal_steps<M: Mechanism>(
    motion: &Motion<M>,
    method: &mut dyn Advance<M>,
    course: &Course,
    count: usize,
    start: Sample<M>,
    steps: &mut Steps,
    watch: &mut Watch<M>,
) -> Result<(), Failure> {
    let begin = course.begin;
    // Both ends of a step stay where they are, and the next one starts where the last ended.
    let (mut from, mut to) = (&mut { start }, &mut { start });
    let length = (course.end - begin) / count as f64;
    let mut crossing = Crossing::new();
    for step in 1..=count {
        // From the start each time, so that times do not accumulate rounding.
        let goal = if step == count { course.end } else { begin + (course.end - begin) * (step as f64 / count as f64) };
        // A step over a singular position may end near one of these times or beyond it, which is then left out.
        let rest = if step < count { 0.1 * length } else { 4.0 * f64::EPSILON * goal.abs() };
        while goal - from.state.time > rest {
            check_interrupt(course, from)?;
            let is_near = crossing.may_be_ahead(motion);
            let way = match is_near {
                true => crossing.lead(motion, [from, to], [length, course.end], &EXACT, steps)?,
                false => Way::On,
            };
            let ended = match way {
                Way::Crossed => {
                    crossing.ended(motion);
                    watch(&mut crossing.step(motion, [from, to]))?
                }
                Way::On | Way::UpTo(_) => {
                    let time = if let Way::UpTo(time) = way { goal.min(time) } else { goal };
                    let made = attempt(motion, method, from, time, None, to);
                    made.map_err(|failure| explained(motion, &from.state, failure))?;
                    crossing.ended(motion);
                    steps.accepted += 1;
                    if is_near {
                        steps.note(motion, method, [from, to], 1)?;
                    }
                    watch(&mut Step { motion, method, from, to, reached: to, end_sine: crossing.end_sine(motion) })?
                }
            };
            if ended.is_break() {
                return Ok(());
            }
            swap(&mut from, &mut to);
        }
    }
    Ok(())
}

fn adaptive_steps<M: Mechanism>(
    motion: &Motion<M>,
    method: &mut dyn Advance<M>,
    course: &Course,
    (tolerance, order): (&Tolerance, f64),
    start: Sample<M>,
    steps: &mut Steps,
    watch: &mut Watch<M>,
) -> Result<(), Failure> {
    let (mut from, mut to) = (&mut { start }, &mut { start });
    let mut controller = Controller::new(order);
    let mut crossing = Crossing::new();
    motion.start(&from.state);
    let mut h = initial_step(motion, from, course.end - from.state.time, order, tolerance)?;
    let (first, mut headway) = (h, Headway::from(from.state.time));
    while from.state.time < course.end {
        check_interrupt(course, from)?;
        let now = from.state.time;
        if headway.is_lost(now) {
            return Err(too_small(motion, &from.state, h, None));
        }
        // The last step is not followed by a tiny one.
        let wanted = if now + 1.01 * h >= course.end { course.end } else { now + h };
        let way = match crossing.may_be_ahead(motion) {
            true => crossing.lead(motion, [from, to], [wanted - now, course.end], tolerance, steps)?,
            false => Way::On,
        };
        if let Way::Crossed = way {
            crossing.ended(motion);
            if watch(&mut crossing.step(motion, [from, to]))?.is_break() {
                return Ok(());
            }
            headway.comes(to.state.time - now);
            swap(&mut from, &mut to);
            continue;
        }
        let time = if let Way::UpTo(time) = way { wanted.min(time) } else { wanted };
        match attempt(motion, method, from, time, Some(tolerance), to) {
            Ok(error) if error <= 1.0 && crossing.is_surprised(motion) => {
                steps.rejected += 1;
                h = (time - now) / 2.0;
            }
            Ok(error) if error <= 1.0 => {
                crossing.ended(motion);
                steps.accepted += 1;
                // These steps may be so long that nothing foretells what they pass.
                steps.note(motion, method, [from, to], 1)?;
                if watch(&mut Step { motion, method, from, to, reached: to, end_sine: crossing.end_sine(motion) })?
                    .is_break()
                {
                    return Ok(());
                }
                headway.comes(time - now);
                let next = (time - now) * controller.accepted(error);
                // A step that was cut short says little of how long they may be.
                h = if time < wanted { next.max(h) } else { next };
                swap(&mut from, &mut to);
            }
            refused => {
                steps.rejected += 1;
                h = (time - now) * controller.rejected(refused.as_ref().ok().copied());
                if h < f64::EPSILON * (16.0 * now.abs()).max(first) {
                    return Err(too_small(motion, &from.state, h, refused.err()));
                }
            }
        }
    }
    Ok(())
}

/// What steps over singular positions are good to between equal steps.
const EXACT: Tolerance = Tolerance::new(1e-12);
/// A constraint whose rows are this near to depending on others, as a sine, explains why a step fails.
const NEARLY_SINGULAR: f64 = 1e-2;

/// Why no step is small enough: a singular position, what the last attempt failed with, or the tolerance.
fn too_small<M: Mechanism>(motion: &Motion<M>, at: &State<M>, step: f64, cause: Option<Failure>) -> Failure {
    let cause = cause.unwrap_or_else(|| Failure::at::<M>(What::StepTooSmall { step }, at.time, &at.positions));
    gimbal::explained(explained(motion, at, cause), motion.mechanism(), at.time, &at.positions)
}

/// A failure that a singular position explains, as such.
fn explained<M: Mechanism>(motion: &Motion<M>, at: &State<M>, failure: Failure) -> Failure {
    let has_reason = matches!(failure.what, What::NotFinite { .. } | What::Interrupted);
    match weakest_constraint(motion, at).filter(|(_, sine)| !has_reason && *sine < NEARLY_SINGULAR) {
        Some((constraint, _)) => Failure::at::<M>(What::SingularPosition { constraint }, at.time, &at.positions),
        None => failure,
    }
}

/// How far projection may move the end of a step, in units of the tolerance: further is another branch of the motion.
const MOST_MOVED: f64 = 1000.0;
/// The same in a singular position, where rounding moves it.
const MOST_MOVED_THERE: f64 = 1.0;

/// The differences of positions and speeds.
fn difference<M: Mechanism>(a: &State<M>, b: &State<M>) -> (M::Q, M::Q) {
    (M::Q::from_fn(|i| a.positions[i] - b.positions[i]), M::Q::from_fn(|i| a.speeds[i] - b.speeds[i]))
}

/// One step, with its end on the constraints; gives the estimate of its error.
#[inline]
fn attempt<M: Mechanism>(
    motion: &Motion<M>,
    method: &mut dyn Advance<M>,
    from: &Sample<M>,
    time: f64,
    tolerance: Option<&Tolerance>,
    to: &mut Sample<M>,
) -> Result<f64, Failure> {
    motion.prepare(from, time);
    if has_generalized_speeds::<M>() {
        motion.choose_velocity_variables(from, time, method.is_explicit());
    }
    let Attempt { mut end, error } = match method.step(motion, from, time, tolerance) {
        Err(failure) if motion.falls_back(&failure) => method.step(motion, from, time, tolerance)?,
        made => made?,
    };
    if !(error <= 1.0) {
        return Ok(error);
    }
    let before = end;
    motion.keep(&mut end)?;
    *to = motion.sample_in_place(end)?;
    let moved = |tolerance: &Tolerance| tolerance.norm(motion.measures(), &before, &end, &difference(&before, &end));
    let most_moved = if motion.relative_sine() < AT { MOST_MOVED_THERE } else { MOST_MOVED };
    Ok(tolerance.map_or(error, |tolerance| error.max(moved(tolerance) / most_moved)))
}

fn check_interrupt<M: Mechanism>(course: &Course, at: &Sample<M>) -> Result<(), Failure> {
    match course.interrupt.is_some_and(|interrupt| interrupt.load(Ordering::Relaxed)) {
        true => Err(Failure::at::<M>(What::Interrupted, at.state.time, &at.state.positions)),
        false => Ok(()),
    }
}
