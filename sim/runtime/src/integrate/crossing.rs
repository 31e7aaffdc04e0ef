//! Steps over singular positions.
//!
//! Beside a singular position rounding is amplified by 1/s^2, with s the sine of a row of C_q to the rows before it.
//! The position is predicted from positions, speeds and accelerations. One step of DOP853, whatever the method, is
//! placed so that the position falls in the widest gap between its stages, which are kept on the constraints. A step
//! whose end would lie beside this or the next singular position is made longer.
//!
//! The error of that step is estimated, and the step repeated shorter; a looser bound holds only where both ends come
//! so close that rounding forbids more. The step counts only if it did pass a singular position. It may lead beyond the
//! end of a run, and then counts up to the end. An adaptive step that ends much closer to such a position than it
//! began, unpredicted, is repeated by halves.

use super::attempt::attempt;
use super::dop853::Dop853;
use super::method::Advance;
use super::{Step, Steps, transfer_singularities};
use crate::motion::Motion;
use crate::motion::ahead::{Ahead, Lie, look_ahead, may_be_ahead};
use crate::motion::singular::{Followed, Singularity};
use crate::state::failure::Failure;
use crate::state::saved::{Bytes, Damaged, blank_sample};
use crate::state::settings::Tolerance;
use crate::state::trajectory::{Sample, State};
use sim_kernel::Mechanism;

/// The least sine of the angle between a row of C_q and those before it that a step over a singular position begins and
/// ends at, and the largest number of halvings of such a step that is not accurate enough.
const LEAST_SINE: f64 = 0.1;
const MOST_HALVINGS: i32 = 5;
/// An error this large is not due to rounding: the step is too long, and is shortened while that is possible, at most
/// to this fraction.
const NOT_ROUNDING: f64 = 100.0;
const SHORTER: f64 = 0.9;
/// The best accuracy of such a step. Rounding in its accelerations grows with the inverse cube of that sine.
const TOLERANCE: f64 = 1.25e-12;

/// The number of parts of such a step in which singular positions are searched: of two close together, the second
/// reverses the turn of the first.
const LOOKS: usize = 16;

/// Without special care, sines fall by no more than this factor in a step.
const FALLS: f64 = 0.5;

/// How to continue.
pub(super) enum Way {
    /// As if there were no singular position.
    On,
    /// To this time at most.
    UpTo(f64),
    /// A step over a singular position has been made.
    Crossed,
}

/// Leads a motion over singular positions, by steps of DOP853 with an error estimate, whatever the method of the run,
/// with stages projected onto the constraints.
#[derive(Clone, Debug)]
pub(super) struct Crossing<M: Mechanism> {
    method: Dop853<M>,
    /// The place in its steps that is farthest from its stages.
    gap: f64,
    /// The last step over a singular position, if the motion is still on it.
    over: Option<Box<Over<M>>>,
    /// The smallest sines at the ends of the last two steps, infinite before there are two.
    sines: [f64; 2],
}

/// A step over a singular position. It may go beyond the requested time, where no step can start: the motion continues
/// along it.
#[derive(Clone, Debug)]
struct Over<M: Mechanism> {
    begun: Sample<M>,
    reached: Sample<M>,
    /// The smallest sine where it ends.
    end_sine: f64,
    /// The singular positions in it that the motion has not reached.
    ahead: Vec<Singularity>,
}

impl<M: Mechanism> Crossing<M> {
    pub(super) fn new(mechanism: &M) -> Crossing<M> {
        let method = Dop853::new(mechanism);
        Crossing { gap: method.gap(), method, over: None, sines: [f64::INFINITY; 2] }
    }

    /// Its state between steps as bytes, or from them, at a state.
    pub(super) fn transfer(&mut self, bytes: &mut Bytes, mechanism: &M, at: &State<M>) -> Result<(), Damaged> {
        bytes.numbers(&mut self.sines)?;
        if self.over.as_ref().is_some_and(|over| over.reached.state.time <= at.time) {
            self.over = None;
        }
        let blank = || {
            Box::new(Over {
                begun: blank_sample(mechanism, at),
                reached: blank_sample(mechanism, at),
                end_sine: 0.0,
                ahead: Vec::new(),
            })
        };
        bytes.option(&mut self.over, blank, |bytes, over| {
            bytes.sample(&mut over.begun)?;
            bytes.sample(&mut over.reached)?;
            bytes.number(&mut over.end_sine)?;
            transfer_singularities(mechanism, &mut over.ahead, bytes)
        })?;
        if self.over.is_some() { self.method.transfer(bytes) } else { Ok(()) }
    }

    /// Whether the motion may still be on a step over a singular position.
    #[inline]
    pub(super) fn is_over(&self) -> bool {
        self.over.is_some()
    }

    /// Continues along a step over a singular position that extends beyond the present state, up to an end; gives
    /// whether there is one.
    ///
    /// # Errors
    /// As dense output.
    #[cold]
    pub(super) fn goes_on(
        &mut self,
        motion: &Motion<M>,
        [from, to]: [&mut Sample<M>; 2],
        end: f64,
        steps: &mut Steps,
    ) -> Result<bool, Failure> {
        let Some(over) = self.over.as_mut().filter(|over| from.state.time < over.reached.state.time) else {
            self.over = None;
            return Ok(false);
        };
        if !(from.state.time < end) {
            return Ok(false);
        }
        steps.singularities.extend(over.ahead.extract_if(.., |singularity| singularity.time <= end));
        if over.reached.state.time <= end {
            *to = over.reached.clone();
            self.sines = [self.sines[1], over.end_sine];
        } else {
            let there = self.step(motion, [from, to]).sample(end)?;
            *to = there;
            self.ended(motion.least_sine());
        }
        Ok(true)
    }

    /// Records that a step has ended where the smallest sine is this.
    pub(super) fn ended(&mut self, least_sine: f64) {
        self.sines = [self.sines[1], least_sine];
    }

    /// The smallest sine at the end of the last step.
    pub(super) fn end_sine(&self, motion: &Motion<M>) -> f64 {
        motion.relative(self.sines[1])
    }

    /// Whether a singular position may lie within the next steps.
    pub(super) fn may_be_ahead(&self, motion: &Motion<M>) -> bool {
        may_be_ahead(self.sines.map(|sine| motion.relative(sine)))
    }

    /// Whether the last step came close to an unpredicted singular position: it may have ended beside it, or passed one
    /// with stages beside it.
    pub(super) fn is_surprised(&self, motion: &Motion<M>) -> bool {
        let [before, now] = [self.sines[1], motion.least_sine()].map(|sine| motion.relative(sine));
        !self.may_be_ahead(motion) && now < FALLS * before && may_be_ahead([before, now])
    }

    /// Makes a step over the singular position ahead, or says how to continue. A step is longer than `longest` only if
    /// its ends would otherwise be too close. A step that leads beyond `end` is made all the same and counts up to
    /// `end`: the motion beside a singular position is known from both sides of it.
    pub(super) fn lead(
        &mut self,
        motion: &Motion<M>,
        [from, to]: [&mut Sample<M>; 2],
        [longest, end]: [f64; 2],
        tolerance: &Tolerance,
        steps: &mut Steps,
    ) -> Result<Way, Failure> {
        let (mut halvings, mut length, mut longest) = (0, f64::INFINITY, longest);
        while halvings <= MOST_HALVINGS {
            let lie = Lie { longest, gap: self.gap, least_sine: LEAST_SINE * 0.5f64.powi(halvings) };
            let possible = TOLERANCE * 8f64.powi(halvings);
            let absolute = tolerance.absolute.max(possible) * rate(motion, from).max(1.0);
            let relaxed = Tolerance { relative: tolerance.relative.max(possible), absolute };
            let time = match look_ahead(motion, from, &lie) {
                Ahead::Over(time) => time,
                Ahead::UpTo(time) => return Ok(Way::UpTo(time)),
                Ahead::Nothing => return Ok(Way::On),
            };
            let (before, now) = (length, from.state.time);
            length = time - now;
            motion.keep_stages(true);
            let attempted = attempt(motion, &mut self.method, from, time, Some(&relaxed), to);
            motion.keep_stages(false);
            match attempted {
                Ok(error) if error <= 1.0 => return self.check(motion, (from, to), end, steps),
                Ok(error) if error > NOT_ROUNDING && length < SHORTER * before => longest /= 2.0,
                _ => halvings += 1,
            }
            steps.rejected += 1;
        }
        Ok(Way::On)
    }

    /// The step counts if it has passed a singular position.
    fn check(
        &mut self,
        motion: &Motion<M>,
        (from, to): (&Sample<M>, &mut Sample<M>),
        end: f64,
        steps: &mut Steps,
    ) -> Result<Way, Failure> {
        let passed = steps.singularities.len();
        steps.note(motion, &mut self.method, [from, to], LOOKS)?;
        if steps.singularities.len() == passed {
            return Ok(Way::On);
        }
        steps.accepted += 1;
        let ahead = steps.singularities.extract_if(passed.., |singularity| singularity.time > end).collect();
        self.over =
            Some(Box::new(Over { begun: from.clone(), reached: to.clone(), end_sine: motion.least_sine(), ahead }));
        if to.state.time > end {
            let end = self.step(motion, [from, to]).sample(end)?;
            *to = end;
        }
        Ok(Way::Crossed)
    }

    /// The step over a singular position that has been made.
    pub(super) fn step<'s>(&'s mut self, motion: &'s Motion<M>, [from, to]: [&'s Sample<M>; 2]) -> Step<'s, M> {
        let end_sine = self.end_sine(motion);
        let (begun, reached) = self.over.as_ref().map_or((from, to), |over| (&over.begun, &over.reached));
        Step { motion, method: &mut self.method, from, to, begun, reached, end_sine, is_jump: false }
    }
}

/// The largest speed, in the scales of the coordinates: near a singular position a speed that happens to be small is no
/// more accurate than the others.
fn rate<M: Mechanism>(motion: &Motion<M>, at: &Sample<M>) -> f64 {
    motion.size(&at.state.speeds)
}

impl Steps {
    /// Records the singular positions that a step has passed, at most one in each of so many parts. An ordinary step is
    /// one part: for most steps a quick test shows that there is none.
    pub(super) fn note<M: Mechanism>(
        &mut self,
        motion: &Motion<M>,
        method: &mut dyn Advance<M>,
        [from, to]: [&Sample<M>; 2],
        looks: usize,
    ) -> Result<(), Failure> {
        let followed = Followed::at(motion, &from.state);
        if looks == 1 && !followed.may_have_passed([&from.state, &to.state]) {
            return Ok(());
        }
        let [begin, end] = [from, to].map(|sample| sample.state.time);
        let mut at = |time: f64| match time == end {
            true => Ok(to.state.clone()),
            false => method.inside(motion, from, to, (time - begin) / (end - begin)),
        };
        let (mut time, mut before) = (begin, followed.parts(begin, &from.state.positions));
        for look in 1..=looks {
            let next = if look == looks { end } else { begin + (end - begin) * look as f64 / looks as f64 };
            let after = followed.parts(next, &at(next)?.positions);
            self.singularities.extend(followed.passed([time, next], [&before, &after], &mut at)?);
            (time, before) = (next, after);
        }
        Ok(())
    }
}
