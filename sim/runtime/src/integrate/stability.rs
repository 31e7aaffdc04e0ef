//! Whether stability limits the length of steps, in place of accuracy: then the mechanism is stiff for an explicit method, and
//! accelerations and forces go to and fro about the right ones while positions are right.

use crate::state::saved::{Bytes, Damaged};

/// A step of this part of the longest stable one is limited by stability.
const LIMITED: f64 = 0.9;
/// The least number of such steps, and their part of those looked at, with which a mechanism counts as stiff.
const LEAST: u64 = 4;
const PART: u64 = 3;

/// Steps that were looked at.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Stability {
    /// All of them.
    pub looked: u64,
    /// Those that stability limits.
    pub limited: u64,
}

impl Stability {
    /// Whether the mechanism is stiff for the method.
    pub fn is_stiff(&self) -> bool {
        self.limited >= LEAST && PART * self.limited >= self.looked
    }

    pub(super) fn look(&mut self, stiffness: Option<f64>) {
        let Some(stiffness) = stiffness else { return };
        self.looked += 1;
        self.limited += u64::from(stiffness > LIMITED);
    }

    pub(super) fn transfer(&mut self, bytes: &mut Bytes) -> Result<(), Damaged> {
        bytes.tally(&mut self.looked)?;
        bytes.tally(&mut self.limited)
    }
}
