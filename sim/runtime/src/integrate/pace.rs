//! The length of steps: equal, or as long as a tolerance allows.

use super::attempt::{explained, keeps_its_speeds, slows, taken_back, too_small};
use super::changes_in_time::{ASIDE, tick};
use super::control::{Controller, initial_step};
use super::corners::{behind_corner, corner, corner_of_energy};
use super::crossing::{Crossing, Way};
use super::equal::{aim_equally, first_step};
use super::headway::Headway;
use super::method::Advance;
use super::switching::{Stop, SuddenChanges, next_stop};
use super::target::{Aim, Target};
use super::{Course, Steps};
use crate::motion::Motion;
use crate::state::failure::{Failure, What};
use crate::state::saved::{Bytes, Damaged};
use crate::state::settings::{Stepping, Tolerance};
use crate::state::trajectory::Sample;
use sim_kernel::Mechanism;

/// The length of steps.
#[derive(Clone, Debug)]
pub(super) enum Pace {
    /// The index of the next equal step.
    Equal { count: usize, step: usize },
    /// As long as the tolerance allows.
    Adaptive(Adaptive),
}

#[derive(Clone, Debug)]
pub(super) struct Adaptive {
    tolerance: Tolerance,
    controller: Controller,
    /// The length of the next step, in seconds.
    h: f64,
    /// The length of the first step.
    first: f64,
    headway: Headway,
    /// Whether accelerations jump at rows of tables of time, since constraints prescribe them.
    rows_jump: bool,
    /// Where a step has ended at such a jump, and whether the next one leads over it.
    jumped: f64,
    is_across: bool,
    /// Whether the next step has exactly this length, and is not drawn on to a stop or the end of the run just behind.
    ends_there: bool,
}

/// A step goes on to a stop or the end of the run that is so much further away: no tiny one follows it.
const MARGIN: f64 = 1.01;

impl Pace {
    /// At the start; of adaptive steps the length is still to be found.
    pub(super) fn new<M: Mechanism>(course: &Course, method: &dyn Advance<M>, now: f64) -> Pace {
        match course.stepping {
            Stepping::Equal(count) => Pace::Equal { count, step: first_step(course, count, now) },
            Stepping::Adaptive(tolerance) => {
                let controller = Controller::new(method.control_order().unwrap_or(1.0));
                Pace::Adaptive(Adaptive {
                    tolerance,
                    controller,
                    h: 0.0,
                    first: 0.0,
                    headway: Headway::from(now),
                    rows_jump: false,
                    jumped: f64::NEG_INFINITY,
                    is_across: false,
                    ends_there: false,
                })
            }
        }
    }

    /// Whether steps are equal.
    #[inline(always)]
    pub(super) fn is_equal(&self) -> bool {
        matches!(self, Pace::Equal { .. })
    }

    /// Finds the first length of adaptive steps, from a sample.
    ///
    /// # Errors
    /// [`What::NoErrorEstimate`], and as the right-hand side.
    pub(super) fn start<M: Mechanism>(
        &mut self,
        motion: &Motion<M>,
        method: &dyn Advance<M>,
        course: &Course,
        start: &Sample<M>,
    ) -> Result<(), Failure> {
        let Pace::Adaptive(adaptive) = self else { return Ok(()) };
        let (time, positions) = (start.state.time, &start.state.positions);
        let order = method.control_order();
        let order = order.ok_or_else(|| Failure::at(motion.mechanism(), What::NoErrorEstimate, time, positions))?;
        motion.start(&start.state);
        let first = initial_step(motion, start, course.end - time, order, &adaptive.tolerance)?;
        adaptive.h = first.max(shortest(time));
        adaptive.first = adaptive.h;
        Ok(())
    }

    /// Goes on by another course from this time.
    pub(super) fn head_for(&mut self, course: &Course, now: f64) {
        if let (Pace::Equal { count, step }, Stepping::Equal(new)) = (self, course.stepping) {
            (*count, *step) = (new, first_step(course, new, now));
        }
    }

    /// Sets the target of the next step, or makes it if it leads over a singular position.
    ///
    /// The target is set in place: a copy would wait until all of the last step is in memory.
    ///
    /// # Errors
    /// As steps over singular positions, and if no step is small enough.
    #[inline(always)]
    pub(super) fn aim<M: Mechanism>(
        &mut self,
        motion: &Motion<M>,
        course: &Course,
        ends: [&mut Sample<M>; 2],
        (crossing, target): (&mut Crossing<M>, &mut Target),
        steps: &mut Steps,
    ) -> Result<Aim, Failure> {
        match self {
            Pace::Equal { count, step } => aim_equally(motion, course, (*count, step), ends, (crossing, target), steps),
            Pace::Adaptive(adaptive) => adaptive.aim(motion, course, ends, (crossing, target), steps),
        }
    }

    /// Takes or refuses an attempt from a sample on the way to an end; one that meets its tolerance is repeated if a better end is
    /// known.
    ///
    /// # Errors
    /// That of the attempt, if steps are equal or no smaller one is left.
    #[inline(always)]
    pub(super) fn judge<M: Mechanism>(
        &mut self,
        motion: &Motion<M>,
        (from, end): (&Sample<M>, f64),
        target: &Target,
        attempted: Result<f64, Failure>,
        better_end: Option<f64>,
    ) -> Result<bool, Failure> {
        match self {
            Pace::Equal { step, .. } => {
                attempted.map_err(|failure| explained(motion, &from.state, failure))?;
                *step += usize::from(target.time == target.wanted);
                Ok(true)
            }
            Pace::Adaptive(adaptive) => adaptive.judge(motion, (from, end), target, attempted, better_end),
        }
    }

    pub(super) fn transfer(&mut self, bytes: &mut Bytes) -> Result<(), Damaged> {
        match self {
            // The time tells which is the next.
            Pace::Equal { .. } => Ok(()),
            Pace::Adaptive(Adaptive { controller, h, first, headway, rows_jump, jumped, .. }) => {
                controller.transfer(bytes)?;
                bytes.flag(rows_jump)?;
                bytes.number(jumped)?;
                bytes.duration(h)?;
                bytes.duration(first)?;
                headway.transfer(bytes)?;
                if *h > 0.0 { Ok(()) } else { Err(Damaged) }
            }
        }
    }
}

/// A step that still changes a time.
fn shortest(now: f64) -> f64 {
    16.0 * f64::EPSILON * now.abs()
}

impl Adaptive {
    /// Aims at the end of a step that may meet the tolerance.
    fn aim<M: Mechanism>(
        &mut self,
        motion: &Motion<M>,
        course: &Course,
        [from, to]: [&mut Sample<M>; 2],
        (crossing, target): (&mut Crossing<M>, &mut Target),
        steps: &mut Steps,
    ) -> Result<Aim, Failure> {
        let (now, tolerance) = (from.state.time, self.tolerance);
        if !(now < course.end) {
            return Ok(Aim::End);
        }
        if self.headway.is_lost(now) {
            return Err(too_small(motion, &from.state, self.h, None));
        }
        // The last step is not followed by a tiny one.
        let h = self.h.max(shortest(now));
        let reach = if std::mem::take(&mut self.ends_there) { h } else { MARGIN * h };
        let stop = match self.is_across {
            true => Some(Stop::Across(now + ASIDE * tick(now, course.end))),
            false => next_stop(motion, from, [now, course.end.min(now + reach)], self.rows_jump),
        };
        if let Some(Stop::Across(time)) = stop
            && self.leads_over_corner(motion, [&mut *from, &mut *to], time.min(course.end), steps)?
        {
            crossing.ended(motion.least_sine());
            return Ok(Aim::Made);
        }
        if let (Some(Stop::Across(time)), true) = (stop, self.rows_jump)
            && !keeps_its_speeds(motion, from, [time - now, self.headway.longest()])
        {
            return Err(taken_back(motion, from, time - now));
        }
        let wanted = match stop {
            Some(Stop::Before(time) | Stop::Across(time)) => time.min(course.end),
            None if now + reach >= course.end => course.end,
            None => now + h,
        };
        let way = match crossing.may_be_ahead(motion) {
            true => crossing.lead(motion, [from, to], [wanted - now, course.end], &tolerance, steps)?,
            false => Way::On,
        };
        let time = match way {
            Way::Crossed => {
                crossing.ended(motion.least_sine());
                self.headway.comes(to.state.time - now);
                return Ok(Aim::Made);
            }
            Way::UpTo(time) => wanted.min(time),
            Way::On => wanted,
        };
        // These steps may be so long that they pass positions that nothing predicts.
        // The time of a jump is known to rounding, and no shorter step would be better.
        let is_across = matches!(stop, Some(Stop::Across(_))) && time == wanted;
        *target = Target { time, wanted, tolerance: (!is_across).then_some(tolerance), notes: true };
        Ok(Aim::Attempt)
    }

    /// Makes the step to a time behind a change of form, if that is a corner; gives whether it is.
    #[cold]
    fn leads_over_corner<M: Mechanism>(
        &mut self,
        motion: &Motion<M>,
        [from, to]: [&mut Sample<M>; 2],
        time: f64,
        steps: &mut Steps,
    ) -> Result<bool, Failure> {
        let (now, longest) = (from.state.time, self.headway.longest().max(self.h));
        let change = match corner(motion, &from.state, [now, time], longest)? {
            None => corner_of_energy(motion, &from.state, [now, time])?,
            felt => felt,
        };
        let Some(change) = change else { return Ok(false) };
        *to = behind_corner(motion, from, time, &change)?;
        (self.is_across, steps.accepted) = (false, steps.accepted + 1);
        SuddenChanges::count(&mut steps.corners, time, time);
        Ok(true)
    }

    /// As [`Pace::judge`].
    fn judge<M: Mechanism>(
        &mut self,
        motion: &Motion<M>,
        (from, end): (&Sample<M>, f64),
        target: &Target,
        attempted: Result<f64, Failure>,
        better_end: Option<f64>,
    ) -> Result<bool, Failure> {
        let (now, time) = (from.state.time, target.time);
        match (attempted, better_end) {
            (Ok(error), Some(better)) if error <= 1.0 => {
                (self.h, self.ends_there) = (better - now, true);
                Ok(false)
            }
            (Ok(error), None) if error <= 1.0 => {
                self.accepted([now, time, target.wanted], error, end);
                Ok(true)
            }
            (refused, _) => {
                self.h = (time - now) * self.controller.rejected(refused.as_ref().ok().copied());
                if refused.is_ok() && self.headway.is_short(self.h) && self.is_beside_jump(motion, from, [time, end]) {
                    return Ok(false);
                }
                let is_taken_back = refused.as_ref().is_ok_and(|error| *error == f64::INFINITY);
                let is_shortest = self.h < f64::EPSILON * (16.0 * now.abs()).max(self.first);
                if is_taken_back && self.headway.is_short(self.h) {
                    // Where no shorter step is left, the row or the kink is next.
                    let beyond = [2.0 * ASIDE * tick(now, end), self.headway.longest()];
                    let is_kink = if is_shortest {
                        !keeps_its_speeds(motion, from, beyond)
                    } else {
                        !slows(motion, from, time - now)
                    };
                    if is_kink {
                        return Err(explained(motion, &from.state, taken_back(motion, from, self.h)));
                    }
                    // Accelerations alone jump, and no shorter step would be better.
                    self.is_across |= is_shortest;
                    return Ok(false);
                }
                if is_shortest {
                    return Err(too_small(motion, &from.state, self.h, refused.err()));
                }
                Ok(false)
            }
        }
    }

    /// Whether steps from a sample fail since accelerations that the constraints prescribe jump at a row there, or ahead of it.
    #[cold]
    fn is_beside_jump<M: Mechanism>(&mut self, motion: &Motion<M>, from: &Sample<M>, [time, end]: [f64; 2]) -> bool {
        let (now, longest) = (from.state.time, self.headway.longest());
        let aside = ASIDE * tick(now, end);
        let is_known = |interval: [f64; 2]| next_stop(motion, from, interval, true).is_some();
        let is_ahead = !self.rows_jump && is_known([now, now + 10.0 * (time - now)]);
        let is_new = !self.headway.is_short(now - self.jumped);
        let is_here = is_new && is_known([now - 2.0 * aside, now + 2.0 * aside]);
        if is_here && keeps_its_speeds(motion, from, [aside, longest]) {
            (self.is_across, self.jumped) = (true, now);
        }
        self.rows_jump |= is_ahead || self.is_across;
        is_ahead || self.is_across
    }

    /// Records a step between two times, of this desired length and error, on the way to an end.
    fn accepted(&mut self, [now, time, wanted]: [f64; 3], error: f64, end: f64) {
        self.headway.comes(time - now);
        self.is_across = false;
        let next = (time - now) * self.controller.accepted(error);
        // A step that was cut short says little about the possible length.
        let is_cut = time < wanted || time < now + self.h;
        self.h = if is_cut { next.max(self.h) } else { next };
        if time == end {
            self.headway.is_asked_to_stop(time);
        }
    }
}
