//! Simulations saved and restored.

use super::Simulation;
use crate::events::Change;
use crate::integrate::Stepper;
use crate::state::digest::Digest;
use crate::state::provenance::{COMMIT, VERSION};
use crate::state::saved::{Bytes, Damaged};
use crate::state::settings::{Settings, Stepping};
use sim_kernel::Mechanism;

/// Bytes that no simulation can be restored from.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum NotRestored {
    /// They are something else.
    #[error("these bytes are no saved simulation")]
    NotSaved,
    /// They are not as they were saved.
    #[error("the saved simulation is damaged: its bytes end early, or have been altered")]
    Damaged,
    /// The motion that was saved had come to an end that nothing leads on from.
    #[error("the simulation had failed before it was saved: no motion goes on from there")]
    Failed,
    /// Something is not what it was.
    #[error("the simulation was saved with another {what}: `{saved}` there, `{here}` here")]
    Other {
        /// What is different: the version of this library, the mechanism, its declaration, a setting.
        what: String,
        /// What it was.
        saved: String,
        /// What it is.
        here: String,
    },
}

const MAGIC: &[u8; 8] = b"linkwrt1";

impl<M: Mechanism> Simulation<M> {
    /// All that the motion is to go on from, to the last bit: state, parameters, inputs, the size of the next step and what it
    /// follows from, the stages that foretell an implicit one, the signs of events, and what has happened.
    pub fn save(&self) -> Vec<u8> {
        let mut bytes = Bytes::Written(MAGIC.to_vec());
        let mut identity = self.identity();
        // Nothing fails where bytes are written.
        let _ = identity.iter_mut().try_for_each(|(_, value)| bytes.text(value));
        // Which commit has saved it is told, and does not matter: the version says whether it can be read.
        let _ = bytes.text(&mut COMMIT.to_owned());
        let _ = bytes.flag(&mut self.failure.is_some());
        let _ = self.clone().transfer(&mut bytes);
        let Bytes::Written(mut bytes) = bytes else { return Vec::new() };
        bytes.extend(Digest::of(&bytes).to_le_bytes());
        bytes
    }

    /// Goes on from where another simulation of the same mechanism with the same settings was saved. Where it cannot, it stays as
    /// it is.
    ///
    /// # Errors
    /// [`NotRestored`].
    pub fn restore(&mut self, bytes: &[u8]) -> Result<(), NotRestored> {
        if !bytes.starts_with(MAGIC) {
            return Err(NotRestored::NotSaved);
        }
        let (content, sum) = bytes.split_last_chunk().ok_or(NotRestored::Damaged)?;
        if content.len() < MAGIC.len() || Digest::of(content) != u64::from_le_bytes(*sum) {
            return Err(NotRestored::Damaged);
        }
        let mut bytes = Bytes::Read(&content[MAGIC.len()..]);
        for (what, here) in self.identity() {
            let mut saved = String::new();
            bytes.text(&mut saved).map_err(|Damaged| NotRestored::Damaged)?;
            if saved != here {
                return Err(NotRestored::Other { what, saved, here });
            }
        }
        bytes.text(&mut String::new()).map_err(|Damaged| NotRestored::Damaged)?;
        let mut has_failed = false;
        bytes.flag(&mut has_failed).map_err(|Damaged| NotRestored::Damaged)?;
        if has_failed {
            return Err(NotRestored::Failed);
        }
        let mut restored = Simulation { failure: None, ..self.clone() };
        restored.transfer(&mut bytes).map_err(|Damaged| NotRestored::Damaged)?;
        match bytes {
            Bytes::Read([]) => {
                *self = restored;
                Ok(())
            }
            _ => Err(NotRestored::Damaged),
        }
    }

    /// What has to be the same where a simulation is restored.
    fn identity(&self) -> Vec<(String, String)> {
        let description = const { &M::DESCRIPTION };
        let Settings { end, method, stepping, stabilisation, stop, .. } = self.settings;
        let stepping = match stepping {
            Stepping::Equal(count) => format!("{count} equal steps"),
            Stepping::Adaptive(tolerance) => format!("rtol {:e}, atol {:e}", tolerance.relative, tolerance.absolute),
        };
        let stop = stop
            .map_or("none".to_owned(), |stop| format!("{}:{}", description.events[stop.event].name, stop.occurrence));
        let identity = [
            ("version of this library", VERSION.to_owned()),
            ("mechanism", description.name.to_owned()),
            ("declaration, by its hash", description.declaration_hash.to_owned()),
            ("end", format!("{end} s")),
            ("method", method.name().to_owned()),
            ("length of steps", stepping),
            ("stabilisation", stabilisation.to_string()),
            ("event that ends it", stop),
        ];
        identity.map(|(what, value)| (what.to_owned(), value)).into()
    }

    /// All of it as bytes, or from them.
    fn transfer(&mut self, bytes: &mut Bytes) -> Result<(), Damaged> {
        bytes.number(&mut self.begin)?;
        self.mobility.transfer::<M>(bytes)?;
        bytes.state(&mut self.state)?;
        self.measures.transfer(bytes)?;
        self.motion.transfer(bytes)?;
        self.integrator.transfer(bytes)?;
        let course = self.course(self.settings.end);
        Stepper::transfer(&mut self.stepper, bytes, (&course, self.integrator.method()), &self.state)?;
        bytes.flag(&mut self.begins_phase)?;
        self.events.transfer(bytes, &Change::none(*self.motion.mechanism(), self.state))?;
        self.steps.transfer::<M>(bytes)?;
        bytes.tally(&mut self.evaluations)
    }
}
