//! Numbers as the file writes them.

use std::borrow::Cow;
use std::fmt::{Display, Formatter, Result};

/// A finite number, and how the declaration writes it.
#[derive(Clone, PartialEq, Debug)]
pub(super) struct Number {
    pub(super) value: f64,
    text: Cow<'static, str>,
}

/// Numbers with more characters than these are written by their value.
const LONGEST: usize = 40;

impl Number {
    pub(super) const ZERO: Number = Number { value: 0.0, text: Cow::Borrowed("0") };
    pub(super) const ONE: Number = Number { value: 1.0, text: Cow::Borrowed("1") };

    /// A number with the fewest digits that give it back.
    pub(super) fn of(value: f64) -> Number {
        if value == 0.0 {
            return Number::ZERO;
        }
        let text = format!("{value:?}");
        Number { value, text: text.strip_suffix(".0").map(str::to_owned).unwrap_or(text).into() }
    }

    /// Reads a number. `None` if it is none, or not finite.
    pub(super) fn read(text: &str) -> Option<Number> {
        let is_plain = |c: char| c.is_ascii_digit() || "+-.eE".contains(c);
        let value: f64 = text.parse().ok().filter(|value: &f64| value.is_finite() && text.chars().all(is_plain))?;
        if value == 0.0 {
            return Some(Number::ZERO);
        }
        let (sign, size) = match text.strip_prefix('-') {
            Some(size) => ("-", size),
            None => ("", text.strip_prefix('+').unwrap_or(text)),
        };
        let (digits, exponent) = match size.split_once(['e', 'E']) {
            Some((digits, exponent)) => (digits, format!("e{}", exponent.strip_prefix('+').unwrap_or(exponent))),
            None => (size, String::new()),
        };
        let (whole, rest) = digits.split_once('.').unwrap_or((digits, ""));
        let whole = whole.trim_start_matches('0');
        let whole = if whole.is_empty() { "0" } else { whole };
        let rest = rest.trim_end_matches('0');
        let point = if rest.is_empty() { "" } else { "." };
        let text = format!("{sign}{whole}{point}{rest}{exponent}");
        Some(if text.len() > LONGEST { Number::of(value) } else { Number { value, text: text.into() } })
    }

    pub(super) fn is_zero(&self) -> bool {
        self.value == 0.0
    }

    /// With a unit, but for 0, which fits everywhere.
    pub(super) fn with(&self, unit: &str) -> String {
        if self.is_zero() { self.to_string() } else { format!("{self} [{unit}]") }
    }
}

impl Display for Number {
    fn fmt(&self, f: &mut Formatter) -> Result {
        f.write_str(&self.text)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_kept_as_they_are_written() {
        let kept = [
            ("1.57079632679", "1.57079632679"),
            ("+.5", "0.5"),
            ("-00.250", "-0.25"),
            ("1.", "1"),
            ("1E+3", "1e3"),
            ("-2.5e-04", "-2.5e-04"),
            ("-0.0", "0"),
        ];
        for (text, written) in kept {
            let number = Number::read(text).unwrap();
            assert_eq!((number.to_string().as_str(), number.value), (written, text.parse().unwrap()), "{text}");
        }
        for text in ["", "a", "nan", "inf", "1e999", "0x10", "1,5", "1 2"] {
            assert_eq!(Number::read(text), None, "{text}");
        }
        let long = format!("0.{}", "3".repeat(100));
        assert_eq!(Number::read(&long).unwrap().to_string(), "0.3333333333333333");
    }
}
