//! What is kept of a run: rows, events, and the phases between events that change something.

mod actions;
mod dead_points;
mod grid;

use crate::events::EventSearch;
use crate::failure::{Failure, What};
use crate::integrate::Step;
use crate::mobility::Mobility;
use crate::motion::Motion;
use crate::onset::Onset;
use crate::settings::{Rows, Settings, Stepping, StopAt};
use crate::trajectory::{Phase, Sample, State};
use dead_points::DeadPoints;
pub use dead_points::{DeadPoint, dead_points};
use grid::Grid;
use sim_kernel::event::Event;
use sim_kernel::{Array, Mechanism};
use std::collections::VecDeque;
use std::ops::ControlFlow;

/// Watches the steps of a run: finds events and does what they say, and keeps what is to be recorded.
pub(crate) struct Recorder<M: Mechanism> {
    pub(crate) samples: Vec<Sample<M>>,
    pub(crate) phases: Vec<Phase<M>>,
    pub(crate) events: EventSearch<M>,
    /// Where rows at equal intervals lie; without one, each step is a row.
    grid: Option<Grid>,
    stop: Option<StopAt>,
    begin: f64,
    end: f64,
    /// The rows to make room for.
    expected: Option<usize>,
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
    /// The same, if it has been recorded as far as rows lie in it.
    last_step: Option<Sample<M>>,
    dead_points: Option<DeadPoints<M>>,
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
        let equal_steps = match settings.stepping {
            Stepping::Equal(count) => Some(count),
            Stepping::Adaptive(_) => None,
        };
        let grid = match settings.rows {
            Rows::Even(count) => Some(Grid::new(begin, settings.end, count, equal_steps)),
            Rows::Steps => None,
        };
        let expected = grid.as_ref().map_or(equal_steps.unwrap_or(1024).checked_add(2), Grid::most);
        Recorder {
            samples: Vec::new(),
            phases: Vec::new(),
            events: EventSearch::new(begin),
            grid,
            stop: settings.stop,
            begin,
            end: settings.end,
            expected,
            counts: vec![0; M::Events::LEN],
            last: vec![f64::NEG_INFINITY; M::Events::LEN],
            acted: VecDeque::new(),
            energy_taken: 0.0,
            next_phase: None,
            has_ended: false,
            reached: None,
            last_step: None,
            dead_points: None,
            largest_work: 0.0,
        }
    }

    pub(crate) fn make_room(&mut self) -> Result<(), What> {
        let (samples, grid) = (&mut self.samples, &mut self.grid);
        let asked = grid.as_ref().map(Grid::asked);
        let mut has_room = |rows: usize| {
            samples.try_reserve_exact(rows).is_ok() && grid.as_mut().is_none_or(|grid| grid.make_room(rows))
        };
        match self.expected.is_some_and(&mut has_room) {
            true => Ok(()),
            false => Err(What::TooManyRows { rows: asked.or(self.expected).unwrap_or(usize::MAX) }),
        }
    }

    /// Looks for dead points from here on.
    pub(crate) fn seek_dead_points(&mut self, mechanism: &M, start: &State<M>, mobility: &Mobility) {
        self.dead_points = DeadPoints::new(mechanism, start, mobility);
    }

    /// Those that were found.
    pub(crate) fn dead_points(&mut self) -> Vec<DeadPoint<M>> {
        self.dead_points.take().map_or(Vec::new(), |sought| sought.found)
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
        self.push(sample);
        self.dead_points.iter_mut().for_each(DeadPoints::restart);
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
        let end = until.map_or(step.to.state.time, |state| state.time);
        self.record(step, end)?;
        if let Some(dead_points) = &mut self.dead_points {
            dead_points.watch(step, end)?;
        }
        let Some(state) = until else {
            // Without a grid it is a row.
            self.last_step = self.grid.is_some().then_some(*step.to);
            return Ok(ControlFlow::Continue(()));
        };
        let last = self.samples.last().map_or(self.begin, |sample| sample.state.time);
        match (&mut self.grid, state.time > last) {
            (_, true) => self.push(Sample { state, ..step.sample(state.time)? }),
            (Some(grid), false) => grid.keep_last(),
            (None, false) => {}
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

    /// A row that lies on no grid.
    fn push(&mut self, sample: Sample<M>) {
        self.samples.push(sample);
        self.grid.iter_mut().for_each(Grid::add_other);
    }

    /// Ends the record. What was asked for is there where the run came to its end; where it did not, all rows stay, with the
    /// state that it came to.
    pub(crate) fn finish(&mut self) {
        let last = self.samples.last().map_or(self.begin, |sample| sample.state.time);
        if let Some(reached) = self.last_step.take().filter(|reached| reached.state.time > last) {
            self.push(reached);
        } else if let Some(grid) = self.grid.as_mut().filter(|_| last == self.end) {
            grid.finish(&mut self.samples, &mut self.phases);
        }
    }

    fn record(&mut self, step: &mut Step<M>, until: f64) -> Result<(), Failure> {
        let Some(grid) = &mut self.grid else {
            if until == step.to.state.time {
                self.samples.push(step.sample(until)?);
            }
            return Ok(());
        };
        grid.prepare([step.from.state.time, until], &mut self.samples, &mut self.phases);
        while let Some(time) = grid.next_time().filter(|time| *time <= until) {
            self.samples.push(step.sample(time)?);
            grid.advance();
        }
        Ok(())
    }
}
