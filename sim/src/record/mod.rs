//! What is kept of a run: rows, events, and the phases between events that change something.

mod actions;

use crate::events::EventSearch;
use crate::failure::{Failure, What};
use crate::integrate::Step;
use crate::motion::Motion;
use crate::onset::Onset;
use crate::settings::{Rows, Settings, Stepping, StopAt};
use crate::trajectory::{Phase, Sample, State};
use sim_kernel::event::Event;
use sim_kernel::{Array, Mechanism};
use std::collections::VecDeque;
use std::ops::ControlFlow;

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
    /// The largest |work| at the end of any step, in joules.
    pub(crate) largest_work: f64,
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
            largest_work: 0.0,
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

    pub(crate) fn watch(&mut self, step: &mut Step<M>) -> Result<ControlFlow<()>, Failure> {
        self.reached = Some(step.to.state);
        self.largest_work = self.largest_work.max(step.to.state.work.abs());
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

    /// Where the event that ends the run has happened.
    fn stopping_state(&mut self) -> Option<State<M>> {
        let stop = self.stop?;
        let mut occurrences = self.events.found.iter().enumerate().filter(|(_, event)| event.event == stop.event);
        let (at, event) = occurrences.nth(stop.occurrence.checked_sub(1)?)?;
        let state = event.state;
        self.events.found.truncate(at + 1);
        Some(state)
    }

    fn record(&mut self, step: &mut Step<M>, until: f64) -> Result<(), Failure> {
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
