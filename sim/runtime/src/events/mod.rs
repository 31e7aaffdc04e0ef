//! When the declared events happen.
//!
//! Each step is searched as finely as the conditions change: if the cubic of a condition's values and rates at two
//! times does not predict its value between them, both halves are searched. A condition that only touches zero has its
//! extremum there. One that is undefined in a part of the motion is searched where it is defined.

mod act;
mod conditions;
mod described;
mod handler;
mod held;
mod jumps;
mod locate;
mod occurrence;
mod onset;
mod turned;
mod undefined;
mod waves;

pub use act::{Change, Located, act};
pub(crate) use conditions::tolerance;
pub(crate) use handler::EventHandler;
pub use occurrence::{Crossing, Occurrence};

use crate::integrate::{MOST_PARTS, Step};
use crate::numerics::insertion::sort_few;
use crate::numerics::signs::crosses;
use crate::state::failure::{Failure, What};
use crate::state::saved::{Bytes, Damaged};
use conditions::{Point, ends, may_reach_zero, value};
use described::{minds_leaving, through};
use onset::{OFFSET, Onset, sizes};
use sim_kernel::event::Direction;
use sim_kernel::{Array, Mechanism};
use undefined::is_defined;
use waves::{DIVIDED_AGAIN, point};

/// The number of halvings of a step, below which a condition is not resolved.
const MOST_HALVINGS: usize = 8;
/// The number of occurrences in one part of a step that counts as chatter.
const MOST_IN_A_PART: usize = 64;
/// A condition returns soon if it is farthest within this part of a step.
const SOON: f64 = 0.1;

/// Before every time.
const ARRIVES: f64 = f64::NEG_INFINITY;

/// All that has happened along a motion, in the order of time, located to max(1e-12 s, 4 ulp of t) on the projected
/// dense output.
///
/// A condition that holds at the very start, to that tolerance, does not count, and neither does a change of sign
/// by a jump or a pole, unless it releases a constraint because of a force.
#[derive(Clone, Debug)]
pub struct EventSearch<M: Mechanism> {
    /// The occurrences found.
    pub found: Vec<Occurrence<M>>,
    /// The length of the motion in seconds.
    span: f64,
    /// The time from which each condition counts; `ARRIVES` for one on its way through zero where the motion has changed.
    begin: M::Events,
    last: Option<Point<M>>,
    /// The values of conditions just before the mechanism was changed, if it has been since.
    before: Option<M::Events>,
    /// Those at the start of the last step.
    stepped_from: M::Events,
    /// The same of the step that led to this phase; zero at the start of the motion.
    came_from: M::Events,
    largest: M::Events,
    /// What is but rounding of each condition, by its terms where the phase has begun.
    noise: M::Events,
    /// Whether each condition is no more than that through a step.
    is_quiet: Vec<bool>,
    /// The onset of conditions at the beginning, if events change the motion.
    onset: Option<Onset<M>>,
    /// A crossing found at the very start, by a condition that leaves to the other side: rounding, unless it stays across.
    at_start: Option<Occurrence<M>>,
}

impl<M: Mechanism> EventSearch<M> {
    /// A search in a motion from a time to another.
    pub fn new(mechanism: &M, [begin, end]: [f64; 2]) -> EventSearch<M> {
        let events = mechanism.description().events.len();
        EventSearch {
            found: Vec::with_capacity(1024),
            span: end - begin,
            begin: M::Events::repeat(events, begin),
            last: None,
            before: None,
            stepped_from: M::Events::repeat(events, 0.0),
            came_from: M::Events::repeat(events, 0.0),
            largest: M::Events::repeat(events, 0.0),
            noise: M::Events::repeat(events, 0.0),
            is_quiet: vec![false; events],
            onset: None,
            at_start: None,
        }
    }

    /// Continues from a time at which the motion has changed. A condition on its way through zero there, to rounding, still counts.
    pub(crate) fn restart(&mut self, begin: f64, onset: Option<Onset<M>>) {
        let arrives = |event: usize| onset.as_ref().is_some_and(|onset| self.arrives(event, onset, begin));
        let begins = self.begin.like(|event| if arrives(event) { ARRIVES } else { begin });
        (self.begin, self.last, self.before, self.onset) = (begins, None, None, onset);
        let none = self.stepped_from.like(|_| 0.0);
        self.came_from = std::mem::replace(&mut self.stepped_from, none);
    }

    /// The side from which a condition has come to this phase, or 0 if that is unknown.
    pub(crate) fn side(&self, event: usize) -> f64 {
        let from = self.came_from[event];
        if from == 0.0 { 0.0 } else { from.signum() }
    }

    /// Whether a condition that the last step has led up to zero, and not through it, goes through from here on: another event
    /// has happened just before it.
    fn arrives(&self, event: usize, onset: &Onset<M>, begin: f64) -> bool {
        let from = self.stepped_from[event];
        let has_come = from.abs() > onset.noise[event] && onset.leaving(event) == -from.signum();
        has_come && onset.holds(event) && !self.has_just_happened(event, begin)
    }

    fn has_just_happened(&self, event: usize, begin: f64) -> bool {
        self.just_found(event, begin).is_some()
    }

    /// Whether a condition has touched zero where the phase begins.
    fn has_just_touched(&self, event: usize) -> bool {
        let found = self.just_found(event, self.begin[event]);
        found.is_some_and(|found| found.crossing == Crossing::Touching) && self.side(event) != 0.0
    }

    fn just_found(&self, event: usize, begin: f64) -> Option<&Occurrence<M>> {
        let at_begin = |found: &&Occurrence<M>| begin - found.state.time <= 2.0 * tolerance(begin, self.span);
        self.found.iter().rev().take_while(at_begin).find(|found| found.event == event)
    }

    /// Continues after a change of the mechanism: unaffected conditions are tracked on, and others from here, as from a
    /// start. A jump over zero is not an event.
    pub(crate) fn resume(&mut self, onset: Option<Onset<M>>) {
        self.before = self.last.take().map(|last| last.values).or(self.before.take());
        self.onset = onset;
    }

    /// The conditions before a change of the mechanism, if known.
    pub(crate) fn before(&self) -> Option<M::Events> {
        self.last.as_ref().map(|last| &last.values).or(self.before.as_ref()).cloned()
    }

    /// The first point of a search without a step before it.
    fn first_point(&mut self, mut point: Point<M>) -> Point<M> {
        for event in 0..self.begin.len() {
            match &self.before {
                Some(before) if before[event] == point.values[event] => {}
                before => {
                    if before.is_some() {
                        self.begin[event] = point.time;
                    }
                    let value = started(&point, event, self.onset.as_ref(), self.span);
                    point.values[event] = match () {
                        // Still on the side that it comes from.
                        _ if self.begin[event] == ARRIVES => -value,
                        _ if self.has_just_touched(event) => f64::MIN_POSITIVE * self.side(event),
                        _ => value,
                    };
                }
            }
        }
        self.before = None;
        point
    }

    /// All of it as bytes, or from them; `blank` is filled by each occurrence that is read.
    pub(crate) fn transfer(&mut self, bytes: &mut Bytes, blank: &Change<M>) -> Result<(), Damaged> {
        let EventSearch {
            found,
            span: _,
            begin,
            last,
            before,
            stepped_from: _,
            came_from,
            largest,
            noise,
            is_quiet: _,
            onset,
            at_start: _,
        } = self;
        let none =
            || Occurrence { event: 0, name: "", crossing: Crossing::Rising, state: blank.state.clone(), change: None };
        let zeros = begin.like(|_| 0.0);
        bytes.list(found, none, |bytes, occurrence| occurrence.transfer(bytes, blank))?;
        bytes.numbers(begin.as_mut())?;
        bytes.option(last, || Point::blank(&zeros), |bytes, last| last.transfer(bytes))?;
        bytes.option(before, || zeros.clone(), |bytes, before| bytes.numbers(before.as_mut()))?;
        bytes.numbers(came_from.as_mut())?;
        bytes.numbers(largest.as_mut())?;
        bytes.numbers(noise.as_mut())?;
        bytes.option(onset, || Onset::blank(&zeros), |bytes, onset| onset.transfer(bytes))
    }

    /// Searches a step.
    ///
    /// # Errors
    /// [`What::InEvent`] with the cause, [`What::Chattering`].
    pub fn search(&mut self, step: &mut Step<M>) -> Result<(), Failure> {
        if self.begin.is_empty() {
            return Ok(());
        }
        let from = match self.last.take() {
            Some(last) => last.starting(step)?,
            None => self.search_first_return(step)?,
        };
        self.stepped_from = from.values.clone();
        let to = Point::of(step.motion, step.to, step.length())?;
        self.note_quiet(step, &from, &to)?;
        let most = step.parts_by_angles().max(self.waves(&from, &to).0);
        self.last = Some(self.search_parts(step, from, to, [most, most])?);
        Ok(())
    }

    /// The first point of a step without one before it. Where a condition leaves zero there and will soon be back, as after a small
    /// bounce, it is searched as far as to where that condition is farthest.
    fn search_first_return(&mut self, step: &mut Step<M>) -> Result<Point<M>, Failure> {
        self.note_sizes(step);
        let first = self.first_point(Point::of(step.motion, step.from, step.length())?);
        let returns = |onset: &Onset<M>| {
            let events = (0..self.begin.len()).filter(|event| onset.holds(*event));
            events.fold(f64::INFINITY, |first, event| first.min(onset.returns_after(event)))
        };
        let farthest = first.time + self.onset.as_ref().map_or(f64::INFINITY, returns) / 2.0;
        match farthest > first.time && farthest < first.time + SOON * step.length() {
            true => {
                let next = point(step, farthest, step.length())?;
                self.search_part(step, &first, next)
            }
            false => Ok(first),
        }
    }

    /// Searches an interval in so many parts, of about so many in the whole step, and those in which a condition turns out to be
    /// faster in further ones; gives its end.
    fn search_parts(
        &mut self,
        step: &mut Step<M>,
        mut from: Point<M>,
        to: Point<M>,
        [parts, of_all]: [f64; 2],
    ) -> Result<Point<M>, Failure> {
        let (motion, begin, length) = (step.motion, from.time, (to.time - from.time) / parts);
        for part in 1..=parts as usize {
            let is_last = part == parts as usize;
            let next = if is_last { to.clone() } else { point(step, begin + part as f64 * length, length)? };
            let (further, event) = self.waves(&from, &next);
            if further <= DIVIDED_AGAIN {
                from = self.search_part(step, &from, next)?;
                continue;
            }
            let of_all = of_all * further;
            if of_all > MOST_PARTS {
                let name = motion.mechanism().description().events[event].name;
                let (what, begins) = (What::Chattering { event: name, count: of_all as usize }, &step.from.state);
                return Err(Failure::at(motion.mechanism(), what, begins.time, &begins.positions));
            }
            from = self.search_parts(step, from, next, [further, of_all])?;
        }
        Ok(from)
    }

    /// Searches a part of a step, whose end it gives.
    fn search_part(&mut self, step: &mut Step<M>, from: &Point<M>, mut to: Point<M>) -> Result<Point<M>, Failure> {
        let mechanism = step.motion.mechanism();
        let first = self.found.len();
        for event in 0..self.begin.len() {
            if self.is_noise(step, event, from, &to)? {
                // One that is nothing but zero has been reached, and may be left to either side.
                if to.values[event] != 0.0 {
                    to.values[event] = from.values[event];
                }
                continue;
            }
            self.largest[event] = to.values[event].abs().max(from.values[event].abs()).max(self.largest[event]);
            let name = mechanism.description().events[event].name;
            if let Some(beyond) = self.left_beyond(step, event, from, &to)? {
                self.locate_leaving(step, event, [from.time, to.time], beyond)?;
                continue;
            }
            if is_defined(event, from, &to) && !may_reach_zero(event, from, &to) {
                continue;
            }
            let of_event = self.found.len();
            self.search_defined(step, event, from, &to, MOST_HALVINGS).map_err(|failure| failure.in_event(name))?;
            let at_start = self.at_start.take().filter(|_| from.values[event].abs() == f64::MIN_POSITIVE);
            if self.found.len() == of_event && crosses(ends(event, from, &to).0) && self.returns(mechanism, event) {
                self.found.extend(at_start);
            }
            if self.found.len() - first > MOST_IN_A_PART {
                let what = What::Chattering { event: name, count: self.found.len() - first };
                let begins = &self.found[first].state;
                return Err(Failure::at(mechanism, what, begins.time, &begins.positions));
            }
        }
        sort_few(&mut self.found[first..], |a, b| a.state.time.total_cmp(&b.state.time));
        Ok(to)
    }

    /// The value beyond which it is no rounding that a condition, which has been nothing but zero, is left in the direction of an event
    /// that minds it, if it is.
    fn left_beyond(
        &self,
        step: &mut Step<M>,
        event: usize,
        from: &Point<M>,
        to: &Point<M>,
    ) -> Result<Option<f64>, Failure> {
        let mechanism = step.motion.mechanism();
        let described = &mechanism.description().events[event];
        let minds = |_: &f64| from.values[event] == 0.0 && minds_leaving(mechanism, described);
        let Some(through) = through(described).filter(minds) else { return Ok(None) };
        let noise = match &self.onset {
            Some(onset) => onset.noise[event].min(self.rounding(step, to.time, event)?),
            None => 0.0,
        };
        let beyond = through * noise.max(f64::MIN_POSITIVE);
        Ok((to.values[event] / beyond > 1.0).then_some(beyond))
    }

    /// What is rounding of a condition at a time in a step, by its terms there.
    fn rounding(&self, step: &mut Step<M>, time: f64, event: usize) -> Result<f64, Failure> {
        let there = step.sample(time)?;
        Ok(OFFSET * sizes(step.motion, &there, self.span)?[event])
    }

    /// Whether a crossing at the very start is the return of a condition that was left there, and not how it leaves: it has a
    /// direction, or it has just happened.
    fn returns(&self, mechanism: &M, event: usize) -> bool {
        let has_direction = mechanism.description().events[event].direction != Direction::Both;
        has_direction || self.has_just_happened(event, self.begin[event])
    }

    /// Whether a condition is zero throughout a step, up to the tolerance of constraints: it keeps the sign that it had.
    fn is_noise(&self, step: &mut Step<M>, event: usize, from: &Point<M>, to: &Point<M>) -> Result<bool, Failure> {
        let Some(onset) = &self.onset else { return Ok(self.is_quiet[event]) };
        // The sign of a condition that is left is noted as the least number.
        let at_start = onset.noise[event].max(f64::MIN_POSITIVE);
        let ends = from.values[event].abs().max(to.values[event].abs());
        if !(ends <= at_start) {
            return Ok(false);
        }
        match ends.max(value(step, (from.time + to.time) / 2.0, event)?.abs()) {
            largest if largest <= f64::MIN_POSITIVE => Ok(true),
            largest if largest <= at_start => {
                // Where the phase has begun, the terms may have been much larger than here.
                Ok(largest <= self.rounding(step, to.time, event)?)
            }
            _ => Ok(false),
        }
    }
}

/// The value of a condition where a search starts: a condition that holds there is being left, not crossed. One that is nothing but
/// rounding there is zero, on neither side.
fn started<M: Mechanism>(point: &Point<M>, event: usize, onset: Option<&Onset<M>>, span: f64) -> f64 {
    let is_zero = point.values[event].is_finite()
        && point.values[event].abs() <= 2.0 * tolerance(point.time, span) * point.rates[event].abs();
    let sign = match onset {
        Some(onset) if onset.holds(event) && onset.leaving(event) == 0.0 && onset.is_noise(event) => return 0.0,
        Some(onset) if onset.holds(event) => onset.leaving(event),
        _ if is_zero => point.rates[event],
        _ => 0.0,
    };
    if sign != 0.0 { f64::MIN_POSITIVE.copysign(sign) } else { point.values[event] }
}
