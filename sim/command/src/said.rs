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

/// So many decimals; of a small or large number, of what a power of ten multiplies, so that no digits are lost.
pub(super) fn decimals(value: f64, count: usize) -> String {
    // Zero has no sign here.
    let value = value + 0.0;
    let plain = value == 0.0 || (1e-3..1e6).contains(&value.abs());
    if plain { format!("{value:.count$}") } else { format!("{value:.count$e}") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn decimals_keep_the_digits_of_small_and_large_numbers() {
        let texts = [0.25, -0.0, -2.5e-9, 4e12].map(|value| decimals(value, 6));
        assert_eq!(texts, ["0.250000", "0.000000", "-2.500000e-9", "4.000000e12"]);
    }
}
