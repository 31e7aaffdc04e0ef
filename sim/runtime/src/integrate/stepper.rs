//! Steps, one after the other.
//!
//! The row of a step is its own first stage, so recording costs no right-hand side.

use super::attempt::attempt;
use super::changes_of_loads::before_change;
use super::crossing::Crossing;
use super::jumps_of_loads::note_jump;
use super::method::Advance;
use super::pace::Pace;
use super::target::{Aim, Target};
use super::unseen_work::before_wrong_work;
use super::{Course, Step, Steps};
use crate::motion::Motion;
use crate::state::failure::{Failure, What};
use crate::state::saved::{Bytes, Damaged, blank_sample};
use crate::state::settings::Tolerance;
use crate::state::trajectory::{Sample, State};
use sim_kernel::Mechanism;

/// One of so many steps is looked at for whether stability limits it.
const BETWEEN_LOOKS: u64 = 16;

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
    target: Target,
}

/// Start and end of the step that is being made.
#[inline(always)]
fn start_and_end<M: Mechanism>([first, second]: &mut [Sample<M>; 2], from: usize) -> [&mut Sample<M>; 2] {
    if from == 0 { [first, second] } else { [second, first] }
}

/// Where a step that meets its tolerance ends better, for what it may have passed unseen.
#[inline(always)]
fn better_end<M: Mechanism>(
    motion: &Motion<M>,
    method: &mut dyn Advance<M>,
    [from, to]: [&Sample<M>; 2],
    (crossing, course): (&Crossing<M>, &Course),
    (error, tolerance): (f64, &Tolerance),
) -> Result<Option<f64>, Failure> {
    if crossing.is_surprised(motion) {
        return Ok(Some(from.state.time + (to.state.time - from.state.time) / 2.0));
    }
    let end_sine = motion.relative(motion.least_sine());
    let mut step = Step { motion, method, from, to, begun: from, reached: to, end_sine, is_jump: false };
    match motion.aside(|| before_change(&mut step, tolerance)) {
        Ok(None) => before_wrong_work(&mut step, course, error, tolerance),
        // What it leads through cannot be followed from so far.
        Err(Failure { what: What::NotProjected { .. }, .. }) => Ok(Some(from.state.time + step.length() / 2.0)),
        change => change,
    }
}

/// The kind of the last step.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Made {
    /// By the method.
    Normally,
    /// Over a singular position.
    Across,
    /// Over a corner, where speeds jump.
    Corner,
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
        let mut pace = Pace::new(course, method, start.state.time);
        pace.start(motion, method, course, &start)?;
        Ok(Stepper { pace, ..Stepper::blank(motion.mechanism(), course, method, start) })
    }

    /// One to be filled.
    fn blank(mechanism: &M, course: &Course, method: &dyn Advance<M>, at: Sample<M>) -> Stepper<M> {
        let pace = Pace::new(course, method, at.state.time);
        Stepper {
            course: *course,
            ends: [at.clone(), at],
            from: 0,
            last: None,
            crossing: Crossing::new(mechanism),
            pace,
            target: Target::blank(),
        }
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
        self.pace.head_for(course, now);
        self.course = *course;
    }

    /// Makes the next step; false at the end of the course.
    ///
    /// # Errors
    /// The first failure that smaller steps do not avoid.
    #[inline]
    pub(crate) fn advance(
        &mut self,
        motion: &Motion<M>,
        method: &mut dyn Advance<M>,
        steps: &mut Steps,
    ) -> Result<bool, Failure> {
        loop {
            match self.aim(motion, steps)? {
                Aim::End => return Ok(false),
                Aim::Made => return Ok(true),
                Aim::Attempt => {}
            }
            let attempted = self.attempt(motion, method);
            if self.judge(motion, method, steps, attempted)? {
                return Ok(true);
            }
        }
    }

    /// Finds the target of the next step, or makes it if it leads over a singular position.
    ///
    /// # Errors
    /// As [`advance`](Stepper::advance).
    #[inline(always)]
    pub(crate) fn aim(&mut self, motion: &Motion<M>, steps: &mut Steps) -> Result<Aim, Failure> {
        if self.last.take().is_some() {
            self.from = 1 - self.from;
        }
        let [from, to] = start_and_end(&mut self.ends, self.from);
        let (course, crossing) = (&self.course, &mut self.crossing);
        if crossing.is_over() && crossing.goes_on(motion, [&mut *from, &mut *to], course.end, steps)? {
            self.last = Some(Made::Across);
            return Ok(Aim::Made);
        }
        let aim = self.pace.aim(motion, course, [from, to], (crossing, &mut self.target), steps)?;
        if let Aim::Made = aim {
            self.last = Some(if crossing.is_over() { Made::Across } else { Made::Corner });
        }
        Ok(aim)
    }

    /// Where the step ends that was aimed at.
    pub(crate) fn target(&self) -> &Target {
        &self.target
    }

    /// Attempts the step that was aimed at; gives the estimate of its error.
    ///
    /// # Errors
    /// As the method, the right-hand side and the projection.
    #[inline(always)]
    pub(crate) fn attempt(&mut self, motion: &Motion<M>, method: &mut dyn Advance<M>) -> Result<f64, Failure> {
        let [from, to] = start_and_end(&mut self.ends, self.from);
        attempt(motion, method, from, self.target.time, self.target.tolerance.as_ref(), to)
    }

    /// Takes or refuses an attempt of the step that was aimed at, whose end stands in its place; gives whether it is
    /// taken.
    ///
    /// # Errors
    /// As [`advance`](Stepper::advance).
    #[inline(always)]
    pub(crate) fn judge(
        &mut self,
        motion: &Motion<M>,
        method: &mut dyn Advance<M>,
        steps: &mut Steps,
        attempted: Result<f64, Failure>,
    ) -> Result<bool, Failure> {
        let target = &self.target;
        let [from, to] = start_and_end(&mut self.ends, self.from);
        let is_adaptive = target.tolerance.is_some();
        // That of the end: looks into the step find others.
        let least_sine = motion.least_sine();
        let better_end = match (&attempted, &target.tolerance) {
            (Ok(error), Some(tolerance)) if *error <= 1.0 => {
                better_end(motion, method, [&*from, &*to], (&self.crossing, &self.course), (*error, tolerance))?
            }
            _ => None,
        };
        let judged = self.pace.judge(motion, (from, self.course.end), target, attempted, better_end);
        if is_adaptive && !matches!(judged, Ok(true)) {
            steps.rejected += 1;
        }
        let is_taken = judged?;
        if is_taken {
            self.crossing.ended(least_sine);
            steps.accepted += 1;
            if target.notes {
                steps.note(motion, method, [&*from, &*to], 1)?;
            }
            if steps.accepted.is_multiple_of(BETWEEN_LOOKS) {
                steps.stability.look(method.stiffness(motion, from, to));
            }
            if self.pace.is_equal() {
                let end_sine = motion.relative(least_sine);
                let mut step = Step { motion, method, from, to, begun: from, reached: to, end_sine, is_jump: false };
                note_jump(&mut step, &mut steps.sudden_changes);
            }
            self.last = Some(Made::Normally);
        }
        Ok(is_taken)
    }

    /// Both ends of the step that is being made.
    #[inline(always)]
    pub(crate) fn ends(&mut self) -> [&mut Sample<M>; 2] {
        start_and_end(&mut self.ends, self.from)
    }

    /// The smallest sine between a constraint and those before it at the end of the last step.
    pub(crate) fn end_sine(&self, motion: &Motion<M>) -> f64 {
        self.crossing.end_sine(motion)
    }

    /// The present state, according to the last step.
    ///
    /// # Errors
    /// As dense output.
    pub(crate) fn sample(&self, motion: &Motion<M>, method: &mut dyn Advance<M>) -> Result<Sample<M>, Failure> {
        let mut stepper = self.clone();
        match stepper.last_step(motion, method) {
            Some(mut step) => step.sample(step.to.state.time),
            None => Ok(self.ends[self.from].clone()),
        }
    }

    /// The last step.
    #[inline]
    pub(crate) fn last_step<'s>(
        &'s mut self,
        motion: &'s Motion<M>,
        method: &'s mut dyn Advance<M>,
    ) -> Option<Step<'s, M>> {
        let ends @ [from, to] = [&self.ends[self.from], &self.ends[1 - self.from]];
        Some(match self.last? {
            Made::Across => self.crossing.step(motion, ends),
            made => {
                let (end_sine, is_jump) = (self.crossing.end_sine(motion), made == Made::Corner);
                Step { motion, method, from, to, begun: from, reached: to, end_sine, is_jump }
            }
        })
    }
}
