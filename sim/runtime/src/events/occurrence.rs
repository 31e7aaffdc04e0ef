//! What is told of an event that happened.

use super::act::Change;
use crate::state::saved::{Bytes, Damaged};
use crate::state::trajectory::State;
use sim_kernel::Mechanism;

/// The direction in which a condition, left - right, passes zero.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Crossing {
    /// From below.
    Rising,
    /// From above.
    Falling,
    /// It touches zero and turns back.
    Touching,
}

/// A condition that came to hold.
#[derive(Clone, Debug)]
pub struct Occurrence<M: Mechanism> {
    /// Which event, by index.
    pub event: usize,
    /// The event's name.
    pub name: &'static str,
    /// How.
    pub crossing: Crossing,
    /// Time, positions and speeds, before any change.
    pub state: State<M>,
    /// Its change, if it has actions.
    pub change: Option<Change<M>>,
}

impl<M: Mechanism> Occurrence<M> {
    pub(super) fn transfer(&mut self, bytes: &mut Bytes, blank: &Change<M>) -> Result<(), Damaged> {
        const CROSSINGS: [Crossing; 3] = [Crossing::Rising, Crossing::Falling, Crossing::Touching];
        let events = blank.mechanism.description().events;
        bytes.index(&mut self.event, events.len())?;
        self.name = events[self.event].name;
        let mut crossing = CROSSINGS.iter().position(|crossing| *crossing == self.crossing).unwrap_or(0);
        bytes.index(&mut crossing, CROSSINGS.len())?;
        self.crossing = CROSSINGS[crossing];
        bytes.state(&mut self.state)?;
        bytes.option(&mut self.change, || blank.clone(), |bytes, change| change.transfer(bytes))
    }
}
