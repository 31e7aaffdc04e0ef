//! What a command has to say, for programs and for readers.

use crate::cli::arguments::Voice;
use crate::cli::{Stop, print};
use serde_json::Value;

/// The same results twice.
pub(super) struct Said {
    pub(super) json: Value,
    pub(super) text: String,
}

impl Said {
    /// Prints the form that is asked for.
    pub(super) fn tell(&self, voice: Voice) -> Result<(), Stop> {
        match voice {
            Voice { quiet: true, .. } => Ok(()),
            Voice { json: true, .. } => print(&format!("{:#}\n", self.json)),
            _ => print(&self.text),
        }
    }
}

/// `1 step`, `2 steps`.
pub(super) fn counted(n: usize, what: &str) -> String {
    format!("{n} {what}{}", if n == 1 { "" } else { "s" })
}
