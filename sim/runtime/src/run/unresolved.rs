//! Motions that are smaller than what tolerances tell.

use super::Run;
use crate::motion::measured::known_length;
use crate::motion::measures::Measures;
use crate::state::settings::Stepping;
use crate::state::trajectory::Sample;
use sim_kernel::{Mechanism, Start};

/// So few rows say nothing of how far a coordinate comes.
const FEW: usize = 10;
/// A start that is this part of what counts as 1 is rounding: one that was assembled, and one that is given, as `sin(20*pi)`.
const ASSEMBLED: f64 = 1e-12;
const GIVEN: f64 = 1e-14;
/// Errors carry what starts within the absolute tolerance to a few times this.
const CARRIED: f64 = 10.0;

/// A coordinate whose motion is no larger than what a step may be wrong by.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Unresolved {
    /// Which, by index.
    pub coordinate: usize,
    /// How far from 0 it starts, in SI units.
    pub begins: f64,
    /// How far from 0 it comes.
    pub farthest: f64,
    /// The change that counts as 1, which the absolute tolerance is a part of.
    pub scale: f64,
}

impl<M: Mechanism> Run<M> {
    /// Where nothing tells the mechanism's own length, the farthest that a length comes from 0, in metres.
    #[inline(never)]
    pub fn farthest_unmeasured(&self) -> Option<f64> {
        let samples = &self.trajectory.samples;
        let start = &samples.first()?.state;
        let coordinates = self.mechanism.description().coordinates;
        let lengths: Vec<usize> = (0..coordinates.len()).filter(|j| coordinates[*j].position.is_length).collect();
        let is_known = known_length(&self.mechanism, start.time, &start.positions).is_some();
        if lengths.is_empty() || is_known {
            return None;
        }
        let all = samples.iter().flat_map(|sample| lengths.iter().map(|j| sample.state.positions[*j].abs()));
        Some(all.fold(0.0, f64::max))
    }

    /// A coordinate that starts within the absolute tolerance and stays there, if there is one.
    #[inline(never)]
    pub fn unresolved(&self) -> Option<Unresolved> {
        let (Stepping::Adaptive(tolerance), samples) = (self.settings.stepping, &self.trajectory.samples) else {
            return None;
        };
        let start = &samples.first()?.state;
        if samples.len() < FEW {
            return None;
        }
        let measures = Measures::at(&self.mechanism, start.time, &start.positions);
        let has_length = known_length(&self.mechanism, start.time, &start.positions).is_some();
        let coordinates = self.mechanism.description().coordinates.iter().enumerate();
        let mut measured = coordinates.filter(|(_, coordinate)| has_length || !coordinate.position.is_length);
        measured.find_map(|(coordinate, declared)| {
            let scale = measures.coordinates()[coordinate];
            let farthest = samples.iter().map(|sample| sample.state.positions[coordinate].abs()).fold(0.0, f64::max);
            let begins = start.positions[coordinate];
            let way = |sample: &Sample<M>| (sample.state.positions[coordinate] - begins).abs();
            let rounding = if declared.start == Start::Given { GIVEN } else { ASSEMBLED };
            // What stays where it is, as a lock holds it, is no motion.
            let moves =
                begins.abs() > rounding * scale && samples.iter().map(way).fold(0.0, f64::max) > begins.abs() / 2.0;
            let most = tolerance.absolute * scale;
            let is_within = begins.abs() <= most && farthest <= CARRIED * most;
            (moves && is_within).then_some(Unresolved { coordinate, begins: begins.abs(), farthest, scale })
        })
    }
}
