//! The record of a run: rows, dead points, and the phases between events that change something.

mod dead_points;
mod grid;
pub(crate) mod table;
mod watch;

use crate::integrate::Step;
use crate::motion::Motion;
use crate::motion::mobility::Mobility;
use crate::state::failure::{Failure, What};
use crate::state::settings::{Rows, Settings, Stepping};
use crate::state::trajectory::{Phase, Sample, State};
pub use dead_points::DeadPoint;
use dead_points::DeadPoints;
use grid::Grid;
use sim_kernel::Mechanism;
pub(crate) use watch::Watch;

/// Watches the steps of a run, and keeps the record.
pub(crate) struct Recorder<M: Mechanism> {
    pub(crate) samples: Vec<Sample<M>>,
    pub(crate) phases: Vec<Phase<M>>,
    /// The grid of rows at equal intervals; without one, each step is a row.
    grid: Option<Grid>,
    begin: f64,
    end: f64,
    /// The rows to make room for.
    expected: Option<usize>,
    /// The end of the last step, if it has been recorded as far as rows lie in it.
    last_step: Option<Sample<M>>,
    dead_points: Option<DeadPoints<M>>,
    /// The largest |work| at the end of any step, in joules.
    pub(crate) largest_work: f64,
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
            grid,
            begin,
            end: settings.end,
            expected,
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

    /// Searches dead points from here on.
    pub(crate) fn seek_dead_points(&mut self, mechanism: &M, start: &State<M>, mobility: &Mobility) {
        self.dead_points = DeadPoints::new(mechanism, start, mobility);
    }

    /// Those that were found.
    pub(crate) fn dead_points(&mut self) -> Vec<DeadPoint<M>> {
        self.dead_points.take().map_or(Vec::new(), |sought| sought.found)
    }

    /// A row that lies on no grid.
    fn push(&mut self, sample: Sample<M>) {
        self.samples.push(sample);
        self.grid.iter_mut().for_each(Grid::add_other);
    }

    /// Ends the record. If the run came to its end, it has the requested rows; otherwise all rows stay, with the last
    /// state.
    pub(crate) fn finish(&mut self) {
        let last = self.samples.last().map_or(self.begin, |sample| sample.state.time);
        if let Some(reached) = self.last_step.take().filter(|reached| reached.state.time > last) {
            self.push(reached);
        } else if let Some(grid) = self.grid.as_mut().filter(|_| last == self.end) {
            grid.finish(&mut self.samples, &mut self.phases);
        }
    }

    #[inline]
    fn record(&mut self, step: &mut Step<M>, until: f64) -> Result<(), Failure> {
        let Some(grid) = &mut self.grid else {
            // The usual row is copied once.
            match step.regular_end(until) {
                Some(end) => self.samples.push(end.clone()),
                None if until == step.to.state.time => self.samples.push(step.sample(until)?),
                None => {}
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

impl<M: Mechanism> Watch<M> for Recorder<M> {
    fn starts(&mut self, motion: &Motion<M>, sample: &Sample<M>, energy_taken: f64) {
        let (mechanism, first) = (motion.mechanism().clone(), self.samples.len());
        self.phases.push(Phase { mechanism, first, energy_taken });
        self.push(sample.clone());
        self.dead_points.iter_mut().for_each(DeadPoints::restart);
    }

    #[inline]
    fn steps(&mut self, step: &mut Step<M>, until: Option<&State<M>>) -> Result<(), Failure> {
        self.largest_work = self.largest_work.max(step.to.state.work.abs());
        let end = until.map_or(step.to.state.time, |state| state.time);
        self.record(step, end)?;
        if let Some(dead_points) = &mut self.dead_points {
            dead_points.watch(step, end)?;
        }
        let Some(state) = until else {
            // Without a grid it is a row.
            if self.grid.is_some() {
                self.last_step = Some(step.to.clone());
            }
            return Ok(());
        };
        let last = self.samples.last().map_or(self.begin, |sample| sample.state.time);
        match (&mut self.grid, state.time > last) {
            (_, true) => self.push(Sample { state: state.clone(), ..step.sample(state.time)? }),
            (Some(grid), false) => grid.keep_last(),
            (None, false) => {}
        }
        Ok(())
    }
}
