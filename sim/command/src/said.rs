//! What a command has to say, for programs and for readers.

use crate::arguments::Voice;
use crate::{Stop, print};
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

/// Ten digits at most, the shortest way.
pub(super) fn short(value: f64) -> String {
    let rounded: f64 = format!("{value:.9e}").parse().unwrap_or(value);
    let plain = rounded == 0.0 || (1e-4..1e7).contains(&rounded.abs());
    if plain { format!("{rounded}") } else { format!("{rounded:e}") }
}
