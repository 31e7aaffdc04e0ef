//! Values with units, and assignments, from the command line.

use crate::Stop;
use codegen::model::Unit;

/// `NAME=VALUE` in two.
pub(super) fn split_assignment<'a>(option: &str, text: &'a str) -> Result<(&'a str, &'a str), Stop> {
    text.split_once('=')
        .map(|(name, value)| (name.trim(), value.trim()))
        .filter(|(name, value)| !name.is_empty() && !value.is_empty())
        .ok_or_else(|| Stop::Usage(format!("`{option} {text}`: expected NAME=VALUE, as in `{option} x=1.5`")))
}

/// A value in SI units: a number in `default_unit`, or a number with a unit of its dimension.
pub(super) fn parse_quantity(what: &str, text: &str, default_unit: &str) -> Result<f64, Stop> {
    let fail = |reason: String| -> Stop { Stop::Usage(format!("{what}: {reason}")) };
    let finite = |si: f64| if si.is_finite() { Ok(si) } else { Err(fail(format!("`{text}` is too large"))) };
    let (number, unit) = split_number(text.trim());
    let value: f64 = number
        .parse()
        .ok()
        .filter(|value: &f64| value.is_finite())
        .ok_or_else(|| fail(format!("`{text}` does not start with a number; write it like `180mm` or `0.18`")))?;
    // Numbers of very many digits are rounded before they are multiplied.
    let in_si = |unit: &Unit| finite(unit.to_si(number).unwrap_or(value * unit.factor()));
    let declared = Unit::parse(default_unit).map_err(fail)?;
    let unit = unit.trim().trim_start_matches('[').trim_end_matches(']');
    if unit.is_empty() {
        return in_si(&declared);
    }
    let given = Unit::parse(unit).map_err(|why| fail(multiplied(unit).unwrap_or(why)))?;
    if given.dimension() != declared.dimension() {
        return Err(fail(format!(
            "`{unit}` is a unit of dimension {}, but {} is needed, as in `{default_unit}`",
            given.dimension().si_unit(),
            declared.dimension().si_unit()
        )));
    }
    match given.mistaken_for(&declared) {
        Some(why) => Err(fail(why)),
        None => in_si(&given),
    }
}

/// What would be right for units that are multiplied by spaces or dots, as in `N m`.
fn multiplied(unit: &str) -> Option<String> {
    let words: Vec<&str> = unit.split([' ', '·', '⋅', '×']).filter(|word| !word.is_empty()).collect();
    let right = words.join("*");
    (words.len() > 1 && Unit::parse(&right).is_ok()).then(|| format!("`{unit}` is not a unit; write `{right}`"))
}

/// The longest start that is a number, and the rest.
fn split_number(text: &str) -> (&str, &str) {
    let ends = (1..=text.len()).rev().filter(|end| text.is_char_boundary(*end));
    let is_number =
        |text: &str| text.parse::<f64>().is_ok() && text.ends_with(|c: char| c.is_ascii_digit() || c == '.');
    match ends.into_iter().find(|end| is_number(&text[..*end])) {
        Some(end) => text.split_at(end),
        None => ("", text),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn value(text: &str, unit: &str) -> Result<f64, String> {
        parse_quantity("O2A", text, unit).map_err(|stop| match stop {
            Stop::Usage(message) => message,
            Stop::Failed(error) | Stop::Interrupted(error) => error.to_string(),
            Stop::Told => String::new(),
        })
    }

    #[test]
    fn units_convert_to_si() {
        let pi = std::f64::consts::PI;
        let rows = [
            ("180mm", "m", 0.18),
            ("0.18", "m", 0.18),
            ("180", "mm", 0.18),
            ("180 mm", "m", 0.18),
            ("1e-1 m", "m", 0.1),
            ("30deg", "rad", pi / 6.0),
            ("-75rpm", "rad/s", -2.5 * pi),
            ("2 [kN]", "N", 2000.0),
            ("1.5", "1", 1.5),
        ];
        for (text, unit, si) in rows {
            let found = value(text, unit).unwrap();
            assert!((found - si).abs() <= 2.0 * f64::EPSILON * si.abs(), "{text}: {found}");
        }
    }

    /// A number and its unit give the bits of a declaration, and are read back from them.
    #[test]
    fn numbers_have_the_bits_of_their_decimals() {
        let unit = |text| Unit::parse(text).unwrap();
        for (text, si) in [("170", 0.17), ("700", 0.7), ("-0.3", -3e-4), ("1.1e+3", 1.1), (".9", 9e-4), ("7.", 7e-3)] {
            assert_eq!((value(text, "mm"), value(&format!("{text} mm"), "m")), (Ok(si), Ok(si)), "{text}");
            assert_eq!(unit("mm").from_si(si), text.parse::<f64>().unwrap());
        }
        for tenths in -2000..2000 {
            let (number, name) =
                (f64::from(tenths) / 10.0, ["deg", "um", "inch", "rpm", "percent"][tenths as usize % 5]);
            let si = value(&format!("{number:?}"), name).unwrap();
            assert_eq!(unit(name).from_si(si), number, "{number} {name}");
        }
        // More digits than are multiplied exactly.
        let (long, short) = (value(&format!("0.{}", "3".repeat(500)), "mm"), value("0.3333333333333333", "mm"));
        assert!((long.unwrap() - short.unwrap()).abs() < 1e-19);
    }

    #[test]
    fn mistakes_say_what_is_needed() {
        assert_eq!(value("180kg", "m").unwrap_err(), "O2A: `kg` is a unit of dimension kg, but m is needed, as in `m`");
        assert_eq!(value("1 mmm", "m").unwrap_err(), "O2A: `mmm` is not a known unit (did you mean `mm`?)");
        assert!(value("50Hz", "rad/s").unwrap_err().contains("`Hz` counts cycles and `rad/s` angles; write `rev/s`"));
        for bad in ["5 N m", "5 N·m", "5N⋅m"] {
            assert!(value(bad, "N*m").unwrap_err().ends_with("is not a unit; write `N*m`"), "{bad}");
        }
        for bad in ["", "mm", "inf", "NaN", "1e999"] {
            assert!(value(bad, "m").unwrap_err().contains("does not start with a number"), "{bad}");
        }
    }
}
