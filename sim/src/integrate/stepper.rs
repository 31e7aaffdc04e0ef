//! Steps, one after the other.
//!
//! Times of equal steps are computed from the start each time, and the row of a step is its own first stage, so
//! recording costs no right-hand side.

use super::attempt::{attempt, explained, too_small};
use super::control::{Controller, initial_step};
use super::crossing::{Crossing, Way};
use super::headway::Headway;
use super::method::Advance;
use super::{Course, Step, Steps};
use crate::motion::Motion;
use crate::state::failure::{Failure, What};
use crate::state::saved::{Bytes, Damaged, blank_sample};
use crate::state::settings::{Stepping, Tolerance};
use crate::state::trajectory::{Sample, State};
use sim_kernel::Mechanism;

/// The tolerance of steps over singular positions between equal steps.
const EXACT: Tolerance = Tolerance::new(1e-12);

/// The progress of a motion, and the length of its next step.
#[derive(Clone, Debug)]
pub(crate) struct Stepper<M: Mechanism> {
    course: Course,
    /// Both ends of a step stay where they are, and the next one starts where the last ended.
    ends: [Sample<M>; 2],
    /// Which of them is the start of the last step.
    from: usize,
    last: Option<Made>,
    crossing: Crossing<M>,
    pace: Pace,
}

/// The kind of the last step.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Made {
    /// By the method.
    Normally,
    /// Over a singular position.
    Across,
}

/// The length of steps.
#[derive(Clone, Debug)]
enum Pace {
    /// The index of the next equal step.
    Equal { count: usize, step: usize },
    /// As long as the tolerance allows.
    Adaptive(Adaptive),
}

#[derive(Clone, Debug)]
struct Adaptive {
    tolerance: Tolerance,
    controller: Controller,
    /// The length of the next step, in seconds.
    h: f64,
    /// The length of the first step.
    first: f64,
    headway: Headway,
}

impl<M: Mechanism> Stepper<M> {
    /// From a sample on the constraints.
    ///
    /// # Errors
    /// [`What::NoErrorEstimate`], and as the right-hand side.
    pub(crate) fn new(
        motion: &Motion<M>,
        method: &dyn Advance<M>,
        course: &Course,
        start: Sample<M>,
    ) -> Result<Stepper<M>, Failure> {
        let State { time, positions, .. } = &start.state;
        let mut pace = Pace::new(course, method, *time);
        if let Pace::Adaptive(adaptive) = &mut pace {
            let order = method.control_order();
            let order =
                order.ok_or_else(|| Failure::at(motion.mechanism(), What::NoErrorEstimate, *time, positions))?;
            motion.start(&start.state);
            let first = initial_step(motion, &start, course.end - time, order, &adaptive.tolerance)?;
            adaptive.h = first.max(shortest(*time));
            adaptive.first = adaptive.h;
        }
        Ok(Stepper { pace, ..Stepper::blank(motion.mechanism(), course, method, start) })
    }

    /// One to be filled.
    fn blank(mechanism: &M, course: &Course, method: &dyn Advance<M>, at: Sample<M>) -> Stepper<M> {
        let pace = Pace::new(course, method, at.state.time);
        Stepper { course: *course, ends: [at; 2], from: 0, last: None, crossing: Crossing::new(mechanism), pace }
    }

    /// One that may not be there as bytes, or from them; those read are of this course and method.
    pub(crate) fn transfer(
        stepper: &mut Option<Stepper<M>>,
        bytes: &mut Bytes,
        (course, method): (&Course, &dyn Advance<M>),
        mechanism: &M,
        at: &State<M>,
    ) -> Result<(), Damaged> {
        let blank = || Stepper::blank(mechanism, course, method, blank_sample(mechanism, at));
        bytes.option(stepper, blank, |bytes, stepper| {
            let Stepper { ends, from, last, crossing, pace, .. } = stepper;
            ends.iter_mut().try_for_each(|end| bytes.sample(end))?;
            bytes.index(from, 2)?;
            let mut has_moved = last.is_some();
            bytes.flag(&mut has_moved)?;
            // Nothing else of that step is needed.
            *last = has_moved.then_some(Made::Normally);
            crossing.transfer(bytes, mechanism, &ends[usize::from(has_moved) ^ *from].state)?;
            pace.transfer(bytes)
        })
    }

    /// The end of its course, in seconds.
    pub(crate) fn end(&self) -> f64 {
        self.course.end
    }

    /// Goes on by another course, which may end elsewhere.
    pub(crate) fn head_for(&mut self, course: &Course) {
        let now = self.ends[if self.last.is_some() { 1 - self.from } else { self.from }].state.time;
        if let (Pace::Equal { count, step }, Stepping::Equal(new)) = (&mut self.pace, course.stepping) {
            (*count, *step) = (new, first_step(course, new, now));
        }
        self.course = *course;
    }

    /// Makes the next step; `None` at the end of the course.
    ///
    /// # Errors
    /// The first failure that smaller steps do not avoid.
    #[inline]
    pub(crate) fn next<'s>(
        &'s mut self,
        motion: &'s Motion<M>,
        method: &'s mut dyn Advance<M>,
        steps: &mut Steps,
    ) -> Result<Option<Step<'s, M>>, Failure> {
        if self.last.take().is_some() {
            self.from = 1 - self.from;
        }
        let [first, second] = &mut self.ends;
        let [from, to] = if self.from == 0 { [first, second] } else { [second, first] };
        let (course, crossing) = (&self.course, &mut self.crossing);
        if crossing.is_over() && crossing.goes_on(motion, [&mut *from, &mut *to], course.end, steps)? {
            self.last = Some(Made::Across);
            return Ok(self.last_step(motion, method));
        }
        let ends = [from, to];
        self.last = match &mut self.pace {
            Pace::Equal { count, step } => equal_step(motion, method, course, (*count, step), ends, crossing, steps)?,
            Pace::Adaptive(adaptive) => adaptive.step(motion, method, course, ends, crossing, steps)?,
        };
        Ok(self.last_step(motion, method))
    }

    /// The present state, according to the last step.
    ///
    /// # Errors
    /// As dense output.
    pub(crate) fn sample(&self, motion: &Motion<M>, method: &mut dyn Advance<M>) -> Result<Sample<M>, Failure> {
        let mut stepper = self.clone();
        match stepper.last_step(motion, method) {
            Some(mut step) => step.sample(step.to.state.time),
            None => Ok(self.ends[self.from]),
        }
    }

    /// The last step.
    fn last_step<'s>(&'s mut self, motion: &'s Motion<M>, method: &'s mut dyn Advance<M>) -> Option<Step<'s, M>> {
        let ends @ [from, to] = [&self.ends[self.from], &self.ends[1 - self.from]];
        Some(match self.last? {
            Made::Across => self.crossing.step(motion, ends),
            Made::Normally => {
                let end_sine = self.crossing.end_sine(motion);
                Step { motion, method, from, to, begun: from, reached: to, end_sine }
            }
        })
    }
}

impl Pace {
    /// At the start; of adaptive steps the length is still to be found.
    fn new<M: Mechanism>(course: &Course, method: &dyn Advance<M>, now: f64) -> Pace {
        match course.stepping {
            Stepping::Equal(count) => Pace::Equal { count, step: first_step(course, count, now) },
            Stepping::Adaptive(tolerance) => {
                let controller = Controller::new(method.control_order().unwrap_or(1.0));
                Pace::Adaptive(Adaptive { tolerance, controller, h: 0.0, first: 0.0, headway: Headway::from(now) })
            }
        }
    }

    fn transfer(&mut self, bytes: &mut Bytes) -> Result<(), Damaged> {
        match self {
            // The time tells which is the next.
            Pace::Equal { .. } => Ok(()),
            Pace::Adaptive(Adaptive { controller, h, first, headway, .. }) => {
                controller.transfer(bytes)?;
                bytes.duration(h)?;
                bytes.duration(first)?;
                headway.transfer(bytes)?;
                if *h > 0.0 { Ok(()) } else { Err(Damaged) }
            }
        }
    }
}

/// Makes the next of so many equal steps.
#[inline]
fn equal_step<M: Mechanism>(
    motion: &Motion<M>,
    method: &mut dyn Advance<M>,
    course: &Course,
    (count, step): (usize, &mut usize),
    [from, to]: [&mut Sample<M>; 2],
    crossing: &mut Crossing<M>,
    steps: &mut Steps,
) -> Result<Option<Made>, Failure> {
    let Some(goal) = next_goal(course, count, step, from.state.time) else { return Ok(None) };
    let length = (course.end - course.begin) / count as f64;
    let is_near = crossing.may_be_ahead(motion);
    let way = match is_near {
        true => crossing.lead(motion, [from, to], [length, course.end], &EXACT, steps)?,
        false => Way::On,
    };
    let time = match way {
        Way::Crossed => {
            crossing.ended(motion);
            return Ok(Some(Made::Across));
        }
        Way::UpTo(time) => goal.min(time),
        Way::On => goal,
    };
    let made = attempt(motion, method, from, time, None, to);
    made.map_err(|failure| explained(motion, &from.state, failure))?;
    crossing.ended(motion);
    steps.accepted += 1;
    *step += usize::from(time == goal);
    if is_near {
        steps.note(motion, method, [from, to], 1)?;
    }
    Ok(Some(Made::Normally))
}

/// The first of so many equal steps that may end later than now, or the one before it.
fn first_step(course: &Course, count: usize, now: f64) -> usize {
    let passed = count as f64 * (now - course.begin) / (course.end - course.begin);
    (passed as usize).max(1)
}

/// A step that still changes a time.
fn shortest(now: f64) -> f64 {
    16.0 * f64::EPSILON * now.abs()
}

/// The end of the next of so many equal steps.
fn next_goal(course: &Course, count: usize, step: &mut usize, now: f64) -> Option<f64> {
    let Course { begin, end, .. } = *course;
    let length = (end - begin) / count as f64;
    while *step <= count {
        // From the start each time, so that times do not accumulate rounding.
        let goal = if *step == count { end } else { begin + (end - begin) * (*step as f64 / count as f64) };
        // A step over a singular position may end near one of these times or beyond it; that time is then skipped.
        let rest = if *step < count { 0.1 * length } else { 4.0 * f64::EPSILON * goal.abs() };
        if goal - now > rest {
            return Some(goal);
        }
        *step += 1;
    }
    None
}

impl Adaptive {
    /// Makes a step that meets the tolerance.
    fn step<M: Mechanism>(
        &mut self,
        motion: &Motion<M>,
        method: &mut dyn Advance<M>,
        course: &Course,
        [from, to]: [&mut Sample<M>; 2],
        crossing: &mut Crossing<M>,
        steps: &mut Steps,
    ) -> Result<Option<Made>, Failure> {
        let (now, tolerance) = (from.state.time, self.tolerance);
        if !(now < course.end) {
            return Ok(None);
        }
        loop {
            if self.headway.is_lost(now) {
                return Err(too_small(motion, &from.state, self.h, None));
            }
            // The last step is not followed by a tiny one.
            let h = self.h.max(shortest(now));
            let wanted = if now + 1.01 * h >= course.end { course.end } else { now + h };
            let way = match crossing.may_be_ahead(motion) {
                true => crossing.lead(motion, [from, to], [wanted - now, course.end], &tolerance, steps)?,
                false => Way::On,
            };
            let time = match way {
                Way::Crossed => {
                    crossing.ended(motion);
                    self.headway.comes(to.state.time - now);
                    return Ok(Some(Made::Across));
                }
                Way::UpTo(time) => wanted.min(time),
                Way::On => wanted,
            };
            match attempt(motion, method, from, time, Some(&tolerance), to) {
                Ok(error) if error <= 1.0 && crossing.is_surprised(motion) => {
                    steps.rejected += 1;
                    self.h = (time - now) / 2.0;
                }
                Ok(error) if error <= 1.0 => {
                    crossing.ended(motion);
                    steps.accepted += 1;
                    // These steps may be so long that they pass positions that nothing predicts.
                    steps.note(motion, method, [from, to], 1)?;
                    self.accepted([now, time, wanted], error, course.end);
                    return Ok(Some(Made::Normally));
                }
                refused => {
                    steps.rejected += 1;
                    self.h = (time - now) * self.controller.rejected(refused.as_ref().ok().copied());
                    if self.h < f64::EPSILON * (16.0 * now.abs()).max(self.first) {
                        return Err(too_small(motion, &from.state, self.h, refused.err()));
                    }
                }
            }
        }
    }

    /// Records a step between two times, of this desired length and error, on the way to an end.
    fn accepted(&mut self, [now, time, wanted]: [f64; 3], error: f64, end: f64) {
        self.headway.comes(time - now);
        let next = (time - now) * self.controller.accepted(error);
        // A step that was cut short says little about the possible length.
        let is_cut = time < wanted || time < now + self.h;
        self.h = if is_cut { next.max(self.h) } else { next };
        if time == end {
            self.headway.is_asked_to_stop(time);
        }
    }
}
