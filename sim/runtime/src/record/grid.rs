//! Rows at equal intervals, of a run that may end at any time.
//!
//! The requested intervals divide the whole time, so a run that ends early would have few rows, or one. So rows lie
//! closer at first, by a power of two, and every second one is dropped when there are more than twice the requested
//! number. Extra rows are at most one in four steps, so that they cost little if steps are few.
//!
//! A row costs dense output, a projection and a right-hand side; where equal steps end at finer places, rows there cost
//! nothing. A run that ends early has up to 2N rows, and beside those at the requested places at most one for four steps; one
//! that reaches its end has exactly those asked for. Rows at events, and the state where a run ends, are on no grid and stay.

use crate::state::trajectory::{Phase, Sample};
use sim_kernel::Mechanism;
use std::cmp::Ordering;

/// The least number of steps for each extra row.
const STEPS_A_ROW: usize = 4;
/// Indices of places are exact up to this power of two.
const MOST_PLACES: f64 = 4_503_599_627_370_496.0;

/// The places of rows: place i of N 2^level intervals.
pub(super) struct Grid {
    begin: f64,
    end: f64,
    /// N, the requested intervals.
    asked: usize,
    level: u32,
    /// The place of the next row.
    next: u64,
    /// The place of each row that is held, while the level is above 0.
    places: Vec<Option<u64>>,
    /// The number of places with a row.
    held: usize,
    /// The steps until now.
    steps: usize,
    /// The number of steps that a finer row costs: none if equal steps end at its place.
    steps_a_row: usize,
}

impl Grid {
    pub(super) fn new(begin: f64, end: f64, asked: usize, equal_steps: Option<usize>) -> Grid {
        // If a power of two of them makes an interval, steps end at all finer places, and rows there cost nothing.
        let halved = equal_steps.filter(|steps| steps.is_multiple_of(asked) && (steps / asked).is_power_of_two());
        let level = halved.map_or(0, |steps| (steps / asked).trailing_zeros());
        let steps_a_row = if halved.is_some() { 0 } else { STEPS_A_ROW };
        Grid { begin, end, asked, level, next: 1, places: Vec::new(), held: 0, steps: 0, steps_a_row }
    }

    /// The requested intervals.
    pub(super) fn asked(&self) -> usize {
        self.asked
    }

    /// The largest number of rows that may be held.
    pub(super) fn most(&self) -> Option<usize> {
        self.asked.checked_mul(2)?.checked_add(3)
    }

    pub(super) fn make_room(&mut self, rows: usize) -> bool {
        self.places.try_reserve_exact(rows).is_ok()
    }

    /// The time of the next row, if there is one.
    pub(super) fn next_time(&self) -> Option<f64> {
        let places = self.asked as f64 * f64::from(self.level).exp2();
        match (self.next as f64).partial_cmp(&places)? {
            Ordering::Less => Some(self.begin + (self.end - self.begin) * (self.next as f64 / places)),
            Ordering::Equal => Some(self.end),
            Ordering::Greater => None,
        }
    }

    /// Records a row at the next place.
    pub(super) fn advance(&mut self) {
        if self.level > 0 {
            self.places.push(Some(self.next));
            self.held += 1;
        }
        self.next += 1;
    }

    /// Records a row that lies on no grid, and stays.
    pub(super) fn add_other(&mut self) {
        if self.level > 0 {
            self.places.push(None);
        }
    }

    /// Keeps the last row, wherever it lies.
    pub(super) fn keep_last(&mut self) {
        if let Some(last) = self.places.last_mut() {
            self.held -= usize::from(last.take().is_some());
        }
    }

    /// Before a step is recorded: chooses a spacing of about the length of the first step, and thins the rows to make
    /// room for those of the step.
    pub(super) fn prepare<M: Mechanism>(
        &mut self,
        [from, until]: [f64; 2],
        samples: &mut Vec<Sample<M>>,
        phases: &mut [Phase<M>],
    ) {
        if self.steps == 0 && self.steps_a_row > 0 {
            self.refine(until - from, samples.len());
        }
        self.steps += 1;
        let budget = self.steps.checked_div(self.steps_a_row).map_or(usize::MAX, |rows| rows + STEPS_A_ROW);
        while self.level > 0 && self.held.saturating_add(self.added_by(until)) > budget.min(2 * self.asked) {
            self.coarsen(samples, phases);
        }
    }

    /// Before the first step: the finest grid whose intervals are no shorter.
    fn refine(&mut self, step: f64, rows: usize) {
        let interval = (self.end - self.begin) / self.asked as f64;
        let finest = (interval / step).min(MOST_PLACES / self.asked as f64).log2().floor();
        // Not a number, or below 0, is 0.
        self.level = finest.max(0.0) as u32;
        self.places.resize(if self.level > 0 { rows } else { 0 }, None);
    }

    /// The number of rows in a step that ends at this time.
    fn added_by(&self, until: f64) -> usize {
        let places = self.asked as f64 * f64::from(self.level).exp2();
        let last = (until - self.begin) / (self.end - self.begin) * places;
        (last as u64 + 1).saturating_sub(self.next) as usize
    }

    /// Thins the rows to the requested ones.
    pub(super) fn finish<M: Mechanism>(&mut self, samples: &mut Vec<Sample<M>>, phases: &mut [Phase<M>]) {
        while self.level > 0 {
            self.coarsen(samples, phases);
        }
    }

    /// Doubles the interval.
    fn coarsen<M: Mechanism>(&mut self, samples: &mut Vec<Sample<M>>, phases: &mut [Phase<M>]) {
        let stays = |place: &Option<u64>| place.is_none_or(|place| place.is_multiple_of(2));
        let (mut phases, mut dropped) = (phases.iter_mut().peekable(), 0);
        for (row, place) in self.places.iter().enumerate() {
            while let Some(phase) = phases.next_if(|phase| phase.first == row) {
                phase.first -= dropped;
            }
            dropped += usize::from(!stays(place));
        }
        let mut places = self.places.iter();
        samples.retain(|_| places.next().is_none_or(stays));
        self.places.retain(stays);
        self.places.iter_mut().flatten().for_each(|place| *place /= 2);
        self.held = self.places.iter().flatten().count();
        self.next = self.next.div_ceil(2);
        self.level -= 1;
        if self.level == 0 {
            self.places.clear();
        }
    }
}
