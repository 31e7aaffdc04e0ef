//! Detects steps that make no progress.
//!
//! Where a load jumps to and fro, as dry friction on a block at rest does, steps of some 1e-11 s meet the tolerance and
//! a run would take days. Many attempts in a row that advance by a negligible part of the longest step are reported as
//! a tolerance that cannot be met. The length of the run does not matter.

use crate::state::saved::{Bytes, Damaged};

/// The recent progress of attempts.
#[derive(Clone, Debug)]
pub(super) struct Headway {
    since: f64,
    attempts: u32,
    /// The longest step so far, in seconds.
    longest: f64,
}

impl Headway {
    /// The number of attempts, and the fraction of the longest step that each must advance: where a load jumps to and
    /// fro, steps stay short enough to be accepted.
    const ATTEMPTS: u32 = 20_000;
    const LEAST: f64 = 1e-8;

    /// A step that is a smaller fraction of the longest one leads nowhere if it is taken back.
    const SHORT: f64 = 1e-6;

    pub(super) fn from(time: f64) -> Headway {
        Headway { since: time, attempts: 0, longest: 0.0 }
    }

    /// All of it as bytes, or from them.
    pub(super) fn transfer(&mut self, bytes: &mut Bytes) -> Result<(), Damaged> {
        let mut attempts = self.attempts as usize;
        bytes.index(&mut attempts, Headway::ATTEMPTS as usize + 1)?;
        self.attempts = attempts as u32;
        bytes.number(&mut self.since)?;
        bytes.duration(&mut self.longest)
    }

    /// Restarts the count: a step has ended at a requested time.
    pub(super) fn is_asked_to_stop(&mut self, at: f64) {
        (self.since, self.attempts) = (at, 0);
    }

    /// Records a step.
    pub(super) fn comes(&mut self, length: f64) {
        self.longest = self.longest.max(length);
    }

    /// The longest step so far, in seconds.
    pub(super) fn longest(&self) -> f64 {
        self.longest
    }

    /// Whether a step is so short that no shorter one will do where projection takes it back.
    pub(super) fn is_short(&self, length: f64) -> bool {
        length < Headway::SHORT * self.longest
    }

    /// Whether the last attempts have led nowhere.
    pub(super) fn is_lost(&mut self, now: f64) -> bool {
        self.attempts += 1;
        if self.attempts <= Headway::ATTEMPTS {
            return false;
        }
        let come = now - self.since;
        (self.since, self.attempts) = (now, 0);
        come < Headway::LEAST * self.longest * f64::from(Headway::ATTEMPTS)
    }
}
