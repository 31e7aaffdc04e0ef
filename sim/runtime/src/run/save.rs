//! Simulations saved and restored.

use super::Simulation;
use crate::events::Change;
use crate::integrate::Stepper;
use crate::state::digest::Digest;
use crate::state::provenance::{COMMIT, VERSION};
use crate::state::saved::{Bytes, Damaged};
use crate::state::settings::{Settings, Stepping};
use sim_kernel::Mechanism;

/// Why a simulation cannot be restored from bytes.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum NotRestored {
    /// They are something else.
    #[error("these bytes are not a saved simulation")]
    NotSaved,
    /// They are not as they were saved.
    #[error("the saved simulation is damaged: its bytes end early, or have been altered")]
    Damaged,
    /// The saved motion had failed and cannot continue.
    #[error("the simulation had failed before it was saved and cannot continue")]
    Failed,
    /// Something is not what it was.
    #[error("the simulation was saved with another {what}: `{saved}` there, `{here}` here")]
    Other {
        /// The difference: the version of this library, the mechanism, its declaration, a setting.
        what: String,
        /// The saved value.
        saved: String,
        /// The present value.
        here: String,
    },
}

const MAGIC: &[u8; 8] = b"linkwrt1";

impl<M: Mechanism> Simulation<M> {
    /// Everything needed to continue with the same bits: state, parameters, inputs, the size of the next step and the
    /// state of its control, the stages that predict an implicit step, the signs of events, and past events.
    #[inline(never)]
    pub fn save(&self) -> Vec<u8> {
        let mut bytes = Bytes::Written(MAGIC.to_vec());
        let mut identity = self.identity();
        // Writing bytes cannot fail.
        let _ = identity.iter_mut().try_for_each(|(_, value)| bytes.text(value));
        // Which commit has saved it is told, and does not matter: the version says whether it can be read.
        let _ = bytes.text(&mut COMMIT.to_owned());
        let _ = bytes.flag(&mut self.failure.is_some());
        let _ = self.clone().transfer(&mut bytes);
        let Bytes::Written(mut bytes) = bytes else { return Vec::new() };
        bytes.extend(Digest::of(&bytes).to_le_bytes());
        bytes
    }

    /// Continues from where another simulation of the same mechanism with the same settings was saved. On failure it
    /// stays unchanged.
    ///
    /// # Errors
    /// [`NotRestored`].
    #[inline(never)]
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

    /// The properties that must match to restore a simulation.
    fn identity(&self) -> Vec<(String, String)> {
        let description = self.mechanism().description();
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
        let mechanism = self.motion.mechanism().clone();
        bytes.number(&mut self.begin)?;
        self.mobility.transfer(&mechanism, bytes)?;
        bytes.state(&mut self.state)?;
        self.measures.transfer(bytes)?;
        self.motion.transfer(bytes)?;
        self.integrator.transfer(bytes)?;
        let course = self.course(self.settings.end);
        Stepper::transfer(&mut self.stepper, bytes, (&course, self.integrator.method()), &mechanism, &self.state)?;
        bytes.flag(&mut self.begins_phase)?;
        self.events.transfer(bytes, &Change::none(mechanism.clone(), self.state.clone()))?;
        self.steps.transfer(&mechanism, bytes)?;
        bytes.tally(&mut self.evaluations)
    }
}
