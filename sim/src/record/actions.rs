//! What events do to a run that is recorded: they change its mechanism and state, or end it.

use super::Recorder;
use crate::act::act;
use crate::events::{Crossing, Occurrence, tolerance};
use crate::failure::{Failure, What};
use crate::insertion::sort_few;
use crate::onset::Onset;
use crate::trajectory::{Sample, State};
use sim_kernel::Mechanism;
use sim_kernel::event::{self, Direction};

/// So many events that change something within an instant, and they chatter.
const MOST_AT_ONCE: usize = 32;
/// The instant, as a part of the whole time.
const INSTANT: f64 = 1e-9;

impl<M: Mechanism> Recorder<M> {
    /// Whether an event with actions and a direction happens at the start of a phase: its condition holds there and goes on
    /// through zero. Where the event has just happened that is only so if it was an impact, which should have turned it
    /// back, or if the condition returns to zero within an instant.
    pub(super) fn is_due(&self, onset: &Onset<M>, index: usize, time: f64) -> bool {
        let described = &const { &M::DESCRIPTION }.events[index];
        let through = match described.direction {
            Direction::Rising => 1.0,
            Direction::Falling => -1.0,
            Direction::Both => return false,
        };
        let sign = onset.sign(index);
        let just_happened = time - self.last[index] < self.instant();
        let goes_on = match just_happened {
            true if sign == through => described.steps.iter().any(|step| matches!(step, event::Step::Impact(_))),
            true => sign == -through && onset.returns_after(index) < self.instant(),
            false => sign == through,
        };
        !described.steps.is_empty() && onset.holds(index) && goes_on
    }

    pub(super) fn happen_at_start(&mut self, event: usize, sample: &Sample<M>) -> Result<(), Failure> {
        let described = &const { &M::DESCRIPTION }.events[event];
        let (name, state) = (described.name, sample.state);
        if state.time - self.last[event] < self.instant() {
            let what = What::Accumulating { event: name, count: self.counts[event] + 1 };
            return Err(Failure::at::<M>(what, state.time, &state.positions));
        }
        let crossing = if described.direction == Direction::Rising { Crossing::Rising } else { Crossing::Falling };
        self.events.found.push(Occurrence { event, name, crossing, state, change: None });
        Ok(())
    }

    /// What happens within this time happens at once.
    fn instant(&self) -> f64 {
        (INSTANT * (self.end - self.begin)).max(100.0 * tolerance(self.end))
    }

    /// The first occurrence in a step that does something. What happens after it is forgotten, but for what happens at
    /// the same time.
    pub(super) fn first_acting(&mut self, first: usize) -> Option<usize> {
        let found = &mut self.events.found;
        let does_something = |event: &Occurrence<M>| !M::DESCRIPTION.events[event.event].steps.is_empty();
        let at = first + found[first..].iter().position(does_something)?;
        let time = found[at].state.time;
        let same = found[at..].iter().take_while(|event| event.state.time - time <= 2.0 * tolerance(time)).count();
        found.truncate(at + same);
        sort_few(&mut found[at..], |a, b| a.event.cmp(&b.event));
        Some(at)
    }

    /// Does what the occurrences from here on say, one after the other.
    pub(super) fn act_from(&mut self, mechanism: &M, at: usize) -> Result<(), Failure> {
        let mut mechanism = *mechanism;
        let mut state = self.events.found[at].state;
        let mut changes = false;
        for index in at..self.events.found.len() {
            let (event, name) = (self.events.found[index].event, self.events.found[index].name);
            let described = &M::DESCRIPTION.events[event];
            if described.steps.is_empty() {
                continue;
            }
            self.counts[event] += 1;
            self.last[event] = state.time;
            self.note_time(&state, name, self.counts[event])?;
            let change = act(&mechanism, &state, described, self.counts[event])?;
            (mechanism, state) = (change.mechanism, change.state);
            self.has_ended |= change.ends;
            self.energy_taken += change.energy_taken;
            changes |= described.steps.iter().any(|step| !matches!(step, event::Step::Stop(_)));
            self.events.found[index].change = Some(change);
        }
        // An event that is to stop the run later changes nothing, but the phase has ended there.
        self.next_phase = (changes || !self.has_ended).then_some((mechanism, state));
        Ok(())
    }

    /// Refuses events that happen again and again within an instant.
    fn note_time(&mut self, state: &State<M>, event: &'static str, count: usize) -> Result<(), Failure> {
        self.acted.push_back(state.time);
        if self.acted.len() <= MOST_AT_ONCE {
            return Ok(());
        }
        let first = self.acted.pop_front().unwrap_or(f64::NEG_INFINITY);
        match state.time - first < self.instant() {
            true => Err(Failure::at::<M>(What::Accumulating { event, count }, state.time, &state.positions)),
            false => Ok(()),
        }
    }
}
