//! What is kept of a run: rows, events, and the phases between events that change something.

use crate::act::act;
use crate::events::{Crossing, EventSearch, Occurrence, tolerance};
use crate::failure::{Failure, What};
use crate::integrate::{Advance, Step};
use crate::motion::Motion;
use crate::onset::Onset;
use crate::settings::{Rows, Settings, Stepping, StopAt};
use crate::trajectory::{Phase, Sample, State};
use sim_kernel::event::{self, Direction, Event};
use sim_kernel::{Array, Mechanism};
use std::collections::VecDeque;
use std::ops::ControlFlow;

/// So many events that change something within an instant, and they chatter.
const MOST_AT_ONCE: usize = 32;
/// The instant, as a part of the whole time.
const INSTANT: f64 = 1e-9;

/// Watches the steps of a run: finds events and does what they say, and keeps what is to be recorded.
pub(crate) struct Recorder<M: Mechanism> {
    pub(crate) samples: Vec<Sample<M>>,
    pub(crate) phases: Vec<Phase<M>>,
    pub(crate) events: EventSearch<M>,
    rows: Rows,
    stop: Option<StopAt>,
    begin: f64,
    end: f64,
    /// The next row, of those at equal intervals.
    next: usize,
    expected: usize,
    /// How often each event has happened that does something.
    counts: Vec<usize>,
    /// When each of them has last happened.
    last: Vec<f64>,
    /// When the last of all happened.
    acted: VecDeque<f64>,
    /// The kinetic energy that events have taken, in joules.
    energy_taken: f64,
    /// What the next phase starts from.
    next_phase: Option<(M, State<M>)>,
    /// Whether an event has ended the run.
    has_ended: bool,
    /// The end of the last step.
    reached: Option<State<M>>,
}

/// Whether any event does something.
const fn any_acts(events: &[Event]) -> bool {
    let mut i = 0;
    while i < events.len() {
        if !events[i].steps.is_empty() {
            return true;
        }
        i += 1;
    }
    false
}

impl<M: Mechanism> Recorder<M> {
    pub(crate) fn new(settings: &Settings, begin: f64) -> Recorder<M> {
        let expected = match (settings.rows, settings.stepping) {
            (Rows::Even(count), _) => count,
            (Rows::Steps, Stepping::Equal(count)) => count,
            (Rows::Steps, Stepping::Adaptive(_)) => 1024,
        };
        Recorder {
            samples: Vec::new(),
            phases: Vec::new(),
            events: EventSearch::new(begin),
            rows: settings.rows,
            stop: settings.stop,
            begin,
            end: settings.end,
            next: 1,
            expected,
            counts: vec![0; M::Events::LEN],
            last: vec![f64::NEG_INFINITY; M::Events::LEN],
            acted: VecDeque::new(),
            energy_taken: 0.0,
            next_phase: None,
            has_ended: false,
            reached: None,
        }
    }

    pub(crate) fn make_room(&mut self) -> Result<(), What> {
        let rows = self.expected.checked_add(2);
        match rows.is_some_and(|rows| self.samples.try_reserve_exact(rows).is_ok()) {
            true => Ok(()),
            false => Err(What::TooManyRows { rows: self.expected }),
        }
    }

    /// When the run has begun.
    pub(crate) fn begin(&self) -> f64 {
        self.begin
    }

    /// Starts a phase: records its first row, and does what events say that happen there.
    ///
    /// # Errors
    /// As what events do.
    pub(crate) fn start(&mut self, motion: &Motion<M>, sample: Sample<M>) -> Result<(), Failure> {
        let (mechanism, first) = (*motion.mechanism(), self.samples.len());
        self.phases.push(Phase { mechanism, first, energy_taken: self.energy_taken });
        self.samples.push(sample);
        if self.has_ended {
            return Ok(());
        }
        let onset = match const { any_acts(M::DESCRIPTION.events) } {
            true => Some(Onset::of(motion, &sample, self.end - self.begin)?),
            false => None,
        };
        self.events.restart(sample.state.time, onset);
        let at = self.events.found.len();
        for event in 0..M::Events::LEN {
            if onset.is_some_and(|onset| self.is_due(&onset, event, sample.state.time)) {
                self.happen_at_start(event, &sample)?;
            }
        }
        if self.events.found.len() > at { self.act_from(motion.mechanism(), at) } else { Ok(()) }
    }

    /// Whether an event with actions and a direction happens at the start of a phase: its condition holds there and goes on
    /// through zero. Where the event has just happened that is only so if it was an impact, which should have turned it
    /// back, or if the condition returns to zero within an instant.
    fn is_due(&self, onset: &Onset<M>, index: usize, time: f64) -> bool {
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

    fn happen_at_start(&mut self, event: usize, sample: &Sample<M>) -> Result<(), Failure> {
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

    /// Whether the motion goes on from where the phase has started.
    pub(crate) fn goes_on(&self) -> bool {
        let now = self.samples.last().map_or(self.end, |sample| sample.state.time);
        !self.has_ended && self.next_phase.is_none() && now < self.end
    }

    /// What the next phase starts from, if there is one.
    pub(crate) fn next_phase(&mut self) -> Option<(M, State<M>)> {
        self.next_phase.take()
    }

    /// Where the last step ended, unless an event has ended the run.
    pub(crate) fn reached(&self) -> Option<State<M>> {
        self.reached.filter(|_| !self.has_ended)
    }

    pub(crate) fn watch<A: Advance<M>>(&mut self, step: &mut Step<M, A>) -> Result<ControlFlow<()>, Failure> {
        self.reached = Some(step.to.state);
        let first = self.events.found.len();
        self.events.search(step)?;
        let acting = self.first_acting(first);
        let stop = self.stopping_state();
        let until = stop.or(acting.map(|at| self.events.found[at].state));
        self.record(step, until.map_or(step.to.state.time, |state| state.time))?;
        let Some(state) = until else { return Ok(ControlFlow::Continue(())) };
        let last = self.samples.last().map_or(self.begin, |sample| sample.state.time);
        if state.time > last {
            self.samples.push(step.motion.sample(state)?);
        }
        match (stop, acting) {
            (None, Some(at)) => self.act_from(step.motion.mechanism(), at)?,
            _ => self.has_ended = true,
        }
        Ok(ControlFlow::Break(()))
    }

    /// The first occurrence in a step that does something. What happens after it is forgotten, but for what happens at
    /// the same time.
    fn first_acting(&mut self, first: usize) -> Option<usize> {
        let found = &mut self.events.found;
        let does_something = |event: &Occurrence<M>| !M::DESCRIPTION.events[event.event].steps.is_empty();
        let at = first + found[first..].iter().position(does_something)?;
        let time = found[at].state.time;
        let same = found[at..].iter().take_while(|event| event.state.time - time <= 2.0 * tolerance(time)).count();
        found.truncate(at + same);
        found[at..].sort_by_key(|event| event.event);
        Some(at)
    }

    /// Does what the occurrences from here on say, one after the other.
    fn act_from(&mut self, mechanism: &M, at: usize) -> Result<(), Failure> {
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

    /// Where the event that ends the run has happened.
    fn stopping_state(&mut self) -> Option<State<M>> {
        let stop = self.stop?;
        let mut occurrences = self.events.found.iter().enumerate().filter(|(_, event)| event.event == stop.event);
        let (at, event) = occurrences.nth(stop.occurrence.checked_sub(1)?)?;
        let state = event.state;
        self.events.found.truncate(at + 1);
        Some(state)
    }

    fn record<A: Advance<M>>(&mut self, step: &mut Step<M, A>, until: f64) -> Result<(), Failure> {
        match self.rows {
            Rows::Steps if until == step.to.state.time => self.samples.push(*step.to),
            Rows::Steps => {}
            Rows::Even(count) => {
                while self.next <= count {
                    let time = self.begin + (self.end - self.begin) * (self.next as f64 / count as f64);
                    if time > until {
                        break;
                    }
                    let is_end = time == step.to.state.time;
                    let sample = if is_end { *step.to } else { step.sample(time)? };
                    self.samples.push(sample);
                    self.next += 1;
                }
            }
        }
        Ok(())
    }
}
