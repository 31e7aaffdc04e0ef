//! Applies events to a motion: they change its mechanism and state, or end it.

use super::act::{Change, Located, act};
use super::conditions::tolerance;
use super::described::{any_acts, is_done, moves, switches, through};
use super::held::is_held;
use super::onset::Onset;
use super::turned::{hits_in_vain, is_turned_back, turns_back};
use super::{Crossing, EventSearch, Occurrence};
use crate::integrate::Step;
use crate::motion::Motion;
use crate::numerics::insertion::sort_few;
use crate::state::failure::{Failure, What};
use crate::state::saved::{Bytes, Damaged};
use crate::state::settings::{Settings, StopAt};
use crate::state::trajectory::{Sample, State};
use sim_kernel::event::{self, Direction};
use sim_kernel::{Array, Mechanism};
use std::collections::VecDeque;

/// The number of changing events within an instant that counts as chatter.
const MOST_AT_ONCE: usize = 32;
/// The instant, as a fraction of the whole time.
const INSTANT: f64 = 1e-9;

/// Finds the events of a motion and carries out their actions.
#[derive(Clone, Debug)]
pub(crate) struct EventHandler<M: Mechanism> {
    search: EventSearch<M>,
    stop: Option<StopAt>,
    /// The duration of the motion, in seconds, and its end.
    span: f64,
    end: f64,
    /// How often each event with actions has happened.
    counts: Vec<usize>,
    /// The last time of each of them.
    last: Vec<f64>,
    /// When, after that, its condition last turned back at a start.
    turned: Vec<f64>,
    /// When the last of all happened.
    acted: VecDeque<f64>,
    /// The kinetic energy that events have taken, in joules.
    energy_taken: f64,
    /// The first occurrence whose actions are due.
    acting: Option<usize>,
    /// Whether the motion ends there.
    is_last: bool,
    /// The start of the next phase.
    next_phase: Option<(M, State<M>)>,
    /// Whether an event has ended the motion.
    has_ended: bool,
}

impl<M: Mechanism> EventHandler<M> {
    /// For a motion that begins then.
    pub(crate) fn new(mechanism: &M, settings: &Settings, begin: f64) -> EventHandler<M> {
        let events = mechanism.description().events.len();
        EventHandler {
            search: EventSearch::new(mechanism, [begin, settings.end]),
            stop: settings.stop,
            span: settings.end - begin,
            end: settings.end,
            counts: vec![0; events],
            last: vec![f64::NEG_INFINITY; events],
            turned: vec![f64::NEG_INFINITY; events],
            acted: VecDeque::new(),
            energy_taken: 0.0,
            acting: None,
            is_last: false,
            next_phase: None,
            has_ended: false,
        }
    }

    /// All between two steps as bytes, or from them; `blank` is filled by each change that is read.
    pub(crate) fn transfer(&mut self, bytes: &mut Bytes, blank: &Change<M>) -> Result<(), Damaged> {
        self.search.transfer(bytes, blank)?;
        self.counts.iter_mut().try_for_each(|count| bytes.count(count))?;
        bytes.numbers(&mut self.last)?;
        bytes.numbers(&mut self.turned)?;
        let mut acted: Vec<f64> = self.acted.drain(..).collect();
        bytes.list(&mut acted, || 0.0, Bytes::number)?;
        self.acted = acted.into();
        bytes.number(&mut self.energy_taken)?;
        bytes.flag(&mut self.has_ended)
    }

    /// All that has happened.
    pub(crate) fn found(&self) -> &[Occurrence<M>] {
        &self.search.found
    }

    /// The same, in the end.
    pub(crate) fn into_found(self) -> Vec<Occurrence<M>> {
        self.search.found
    }

    /// The kinetic energy that events have taken, in joules.
    pub(crate) fn energy_taken(&self) -> f64 {
        self.energy_taken
    }

    /// Whether an event has ended the motion.
    pub(crate) fn has_ended(&self) -> bool {
        self.has_ended
    }

    /// The start of the next phase, if there is one.
    pub(crate) fn next_phase(&mut self) -> Option<(M, State<M>)> {
        self.next_phase.take()
    }

    /// Starts a phase: carries out the actions of events that happen there.
    ///
    /// # Errors
    /// As what events do.
    pub(crate) fn start(&mut self, motion: &Motion<M>, sample: &Sample<M>) -> Result<(), Failure> {
        if self.has_ended {
            return Ok(());
        }
        let onset = self.onset(motion, sample)?;
        self.search.restart(sample.state.time, onset.clone());
        self.act_at_start(motion, sample, onset, |_| true)
    }

    /// Continues after the owner of the motion has changed its mechanism: unaffected conditions are tracked on, and
    /// others as from a start.
    ///
    /// # Errors
    /// As what events do.
    pub(crate) fn resume(&mut self, motion: &Motion<M>, sample: &Sample<M>) -> Result<(), Failure> {
        let Some(before) = self.search.before().filter(|before| !before.is_empty()) else { return Ok(()) };
        let now = motion.mechanism().events(
            sample.state.time,
            &sample.state.positions,
            &sample.state.speeds,
            &sample.accelerations,
            &sample.multipliers,
        );
        let onset = self.onset(motion, sample)?;
        self.search.resume(onset.clone());
        self.act_at_start(motion, sample, onset, |event| before[event] != now[event])
    }

    /// The onset of conditions at a sample, if any event has actions.
    fn onset(&self, motion: &Motion<M>, sample: &Sample<M>) -> Result<Option<Onset<M>>, Failure> {
        match any_acts(motion.mechanism().description().events) {
            true => Onset::of(motion, sample, self.span).map(Some),
            false => Ok(None),
        }
    }

    /// Carries out the actions of those events, among some, that happen at a start.
    fn act_at_start(
        &mut self,
        motion: &Motion<M>,
        sample: &Sample<M>,
        onset: Option<Onset<M>>,
        counts: impl Fn(usize) -> bool,
    ) -> Result<(), Failure> {
        let at = self.search.found.len();
        for event in (0..self.counts.len()).filter(|event| counts(*event)) {
            if onset.as_ref().is_some_and(|onset| turns_back(motion.mechanism(), onset, event)) {
                self.turned[event] = sample.state.time;
            }
            if onset.as_ref().is_some_and(|onset| self.is_due(motion, onset, event, sample)) {
                self.happen_at_start(motion.mechanism(), event, sample)?;
            }
        }
        if self.search.found.len() > at { self.act_from(motion, at) } else { Ok(()) }
    }

    /// Searches a step. If an event in it changes something or ends the motion, the step counts up to the state there.
    ///
    /// # Errors
    /// As [`EventSearch::search`].
    #[inline]
    pub(crate) fn search(&mut self, step: &mut Step<M>) -> Result<Option<&State<M>>, Failure> {
        let first = self.search.found.len();
        self.search.search(step)?;
        if self.search.found.len() == first && self.stop.is_none() {
            return Ok(None);
        }
        self.acting = self.first_acting(step.motion.mechanism(), first);
        let stop = self.stopping();
        let ending = stop.or(self.acting);
        // The event that ends the motion acts as well.
        self.acting = self.acting.filter(|first| stop.is_none_or(|at| *first <= at));
        self.is_last = stop.is_some();
        Ok(ending.map(|at| &self.search.found[at].state))
    }

    /// Carries out the actions of the events in the last step, which ends there.
    ///
    /// # Errors
    /// As what events do.
    pub(crate) fn act(&mut self, motion: &Motion<M>) -> Result<(), Failure> {
        self.has_ended |= self.is_last;
        match self.acting.take() {
            Some(at) => self.act_from(motion, at)?,
            None => self.has_ended = true,
        }
        Ok(())
    }

    /// The event that ends the motion, if it has happened.
    fn stopping(&mut self) -> Option<usize> {
        let stop = self.stop?;
        let mut occurrences = self.search.found.iter().enumerate().filter(|(_, event)| event.event == stop.event);
        let (at, _) = occurrences.nth(stop.occurrence.checked_sub(1)?)?;
        self.search.found.truncate(at + 1);
        Some(at)
    }

    /// Whether an event with actions and a direction happens at the start of a phase: its condition holds there and continues
    /// through zero. If the event has just happened, one of these is required: it was an impact in vain, or a constraint it switched
    /// has been switched back, but not if its condition depends on time alone; the condition had turned back since; or it returns
    /// to zero within an instant or without having left it by more than the tolerance of constraints. An event that releases a
    /// constraint because of a force happens also if its condition is beyond zero, with or without a direction: a contact that a
    /// blow has closed does not pull. What holds already does not land again: its condition stays where it is.
    fn is_due(&self, motion: &Motion<M>, onset: &Onset<M>, index: usize, sample: &Sample<M>) -> bool {
        let (mechanism, now, time) = (motion.mechanism(), &sample.state, sample.state.time);
        let described = &mechanism.description().events[index];
        let jumps_to =
            |side: f64| described.on_forces && switches(mechanism, described, false) && onset.is_beyond(index, side);
        let Some(through) = through(described) else {
            let side = -self.search.side(index);
            return side != 0.0 && jumps_to(side);
        };
        if is_done(mechanism, described) && onset.stays(index) {
            return false;
        }
        if jumps_to(through) {
            return true;
        }
        let just_happened = time - self.last[index] < self.instant();
        let goes_on = match just_happened {
            true if onset.leaving(index) == through => {
                let last = self.search.found.iter().rev().find(|found| found.event == index);
                let is_undone = || [true, false].into_iter().any(|on| switches(mechanism, described, on));
                let is_in_vain = |last| hits_in_vain(motion, last, (now, onset.rests(index)), self.span);
                // Time passes a value once, whatever is done then.
                described.on_motion && (is_undone() || last.is_some_and(is_in_vain))
                    || time - self.turned[index] < self.instant()
            }
            true => {
                let soon = onset.returns_after(index) < self.instant() || onset.hides_return(index);
                onset.leaving(index) == -through && soon
            }
            false => onset.sign(index) == through && !(onset.is_noise(index) && is_held(motion, sample, index)),
        };
        !described.steps.is_empty() && onset.holds(index) && goes_on
    }

    fn happen_at_start(&mut self, mechanism: &M, event: usize, sample: &Sample<M>) -> Result<(), Failure> {
        let described = &mechanism.description().events[event];
        let (name, state) = (described.name, sample.state.clone());
        // Contacts may be closed and opened again within an instant, until those are found that push, and blows may go to and fro
        // in a row of balls: `note_time` sees the end.
        let changes_contacts = [true, false].into_iter().any(|on| switches(mechanism, described, on));
        let is_last = self.search.found.last().is_none_or(|last| last.event == event);
        if state.time - self.last[event] < self.instant() && !changes_contacts && is_last {
            let what = What::Accumulating { event: name, count: self.counts[event] + 1 };
            return Err(Failure::at(mechanism, what, state.time, &state.positions));
        }
        let rises = match described.direction {
            Direction::Rising => true,
            Direction::Falling => false,
            Direction::Both => self.search.side(event) < 0.0,
        };
        let crossing = if rises { Crossing::Rising } else { Crossing::Falling };
        self.search.found.push(Occurrence { event, name, crossing, state, change: None });
        Ok(())
    }

    /// Events within this time are simultaneous.
    fn instant(&self) -> f64 {
        (INSTANT * self.span).max(100.0 * tolerance(self.end, self.span))
    }

    /// The first occurrence in a step that has actions. Later occurrences are dropped, except simultaneous ones.
    fn first_acting(&mut self, mechanism: &M, first: usize) -> Option<usize> {
        let found = &mut self.search.found;
        let does_something = |event: &Occurrence<M>| !mechanism.description().events[event.event].steps.is_empty();
        let at = first + found[first..].iter().position(does_something)?;
        let time = found[at].state.time;
        let instant = 2.0 * tolerance(time, self.span);
        let same = found[at..].iter().take_while(|event| event.state.time - time <= instant).count();
        found.truncate(at + same);
        sort_few(&mut found[at..], |a, b| a.event.cmp(&b.event));
        Some(at)
    }

    /// Carries out the actions of the occurrences from here on, in order. One whose condition those before it turn back does not
    /// happen.
    fn act_from(&mut self, motion: &Motion<M>, at: usize) -> Result<(), Failure> {
        let mut mechanism = motion.mechanism().clone();
        let begin = self.search.found[at].state.clone();
        let (mut state, mut changes, mut index) = (begin.clone(), false, at);
        while index < self.search.found.len() {
            let Occurrence { event, name, crossing, .. } = self.search.found[index];
            let described = &mechanism.description().events[event];
            if described.steps.is_empty() {
                index += 1;
                continue;
            }
            if changes && moves(described) && is_turned_back(&mechanism, [&begin, &state], (event, crossing), self.span)
            {
                self.search.found.remove(index);
                continue;
            }
            self.counts[event] += 1;
            (self.last[event], self.turned[event]) = (state.time, f64::NEG_INFINITY);
            self.note_time(&mechanism, &state, name, self.counts[event])?;
            let located = Located { measures: motion.measures(), within: tolerance(state.time, self.span) };
            let change = act(&mechanism, &located, &state, described, self.counts[event])?;
            (mechanism, state) = (change.mechanism.clone(), change.state.clone());
            self.has_ended |= change.ends;
            self.energy_taken += change.energy_taken;
            changes |= described.steps.iter().any(|step| !matches!(step, event::Step::Stop(_)));
            self.search.found[index].change = Some(change);
            index += 1;
        }
        // An event that stops the run at a later occurrence changes nothing, but the phase has ended there.
        self.next_phase = (changes || !self.has_ended).then_some((mechanism, state));
        Ok(())
    }

    /// Refuses events that happen again and again within an instant.
    fn note_time(&mut self, mechanism: &M, state: &State<M>, event: &'static str, count: usize) -> Result<(), Failure> {
        self.acted.push_back(state.time);
        if self.acted.len() <= MOST_AT_ONCE {
            return Ok(());
        }
        let first = self.acted.pop_front().unwrap_or(f64::NEG_INFINITY);
        match state.time - first < self.instant() {
            true => Err(Failure::at(mechanism, What::Accumulating { event, count }, state.time, &state.positions)),
            false => Ok(()),
        }
    }
}
