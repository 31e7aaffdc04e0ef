//! The table of units, and what a unit in brackets means.

use super::Dimension;
use crate::dsl;
use crate::nearest;
use crate::symbolic::{Constant, Expr, Graph, Number, evaluate};

/// A unit: its dimension, and its size in SI units as an exact rational times a power of pi.
#[derive(Clone, PartialEq, Debug)]
pub struct Unit {
    text: String,
    dimension: Dimension,
    rational: Number,
    pi_power: i64,
    counts: Counts,
}

/// What turns are counted in, where a unit tells: the dimensions of 1 Hz and 1 rad/s are the same.
#[derive(Clone, Copy, PartialEq, Debug)]
enum Counts {
    Angles,
    Cycles,
    /// Neither, or both.
    Unknown,
}

/// One line of the table: name, exponents of m kg s A K, numerator and denominator of the size, power of pi in
/// it, and whether SI prefixes apply.
type UnitRow = (&'static str, [i64; 5], i64, i64, i64, bool);

#[rustfmt::skip]
const UNITS: [UnitRow; 28] = [
    ("m",   [1, 0, 0, 0, 0],   1, 1, 0, true),
    ("g",   [0, 1, 0, 0, 0],   1, 1000, 0, true),
    ("s",   [0, 0, 1, 0, 0],   1, 1, 0, true),
    ("A",   [0, 0, 0, 1, 0],   1, 1, 0, true),
    ("K",   [0, 0, 0, 0, 1],   1, 1, 0, true),
    ("rad", [0, 0, 0, 0, 0],   1, 1, 0, true),
    ("N",   [1, 1, -2, 0, 0],  1, 1, 0, true),
    ("J",   [2, 1, -2, 0, 0],  1, 1, 0, true),
    ("W",   [2, 1, -3, 0, 0],  1, 1, 0, true),
    ("Pa",  [-1, 1, -2, 0, 0], 1, 1, 0, true),
    ("Hz",  [0, 0, -1, 0, 0],  1, 1, 0, true),
    ("V",   [2, 1, -3, -1, 0], 1, 1, 0, true),
    ("Ohm", [2, 1, -3, -2, 0], 1, 1, 0, true),
    ("H",   [2, 1, -2, -2, 0], 1, 1, 0, true),
    ("F",   [-2, -1, 4, 2, 0], 1, 1, 0, true),
    ("bar", [-1, 1, -2, 0, 0], 100_000, 1, 0, true),
    ("l",   [3, 0, 0, 0, 0],   1, 1000, 0, true),
    ("deg", [0, 0, 0, 0, 0],   1, 180, 1, false),
    ("rev", [0, 0, 0, 0, 0],   2, 1, 1, false),
    ("rpm", [0, 0, -1, 0, 0],  1, 30, 1, false),
    ("min", [0, 0, 1, 0, 0],   60, 1, 0, false),
    ("h",   [0, 0, 1, 0, 0],   3600, 1, 0, false),
    ("tonne", [0, 1, 0, 0, 0], 1000, 1, 0, false),
    ("inch", [1, 0, 0, 0, 0],  254, 10_000, 0, false),
    ("ft",  [1, 0, 0, 0, 0],   3048, 10_000, 0, false),
    ("lb",  [0, 1, 0, 0, 0],   45_359_237, 100_000_000, 0, false),
    ("lbf", [1, 1, -2, 0, 0],  44_482_216_152_605, 10_000_000_000_000, 0, false),
    ("percent", [0, 0, 0, 0, 0], 1, 100, 0, false),
];

// Micro is written as `u`, as the micro sign and as the Greek letter.
const PREFIXES: [(&str, i64); 16] = [
    ("T", 12),
    ("G", 9),
    ("M", 6),
    ("k", 3),
    ("h", 2),
    ("da", 1),
    ("d", -1),
    ("c", -2),
    ("m", -3),
    ("u", -6),
    ("\u{b5}", -6),
    ("\u{3bc}", -6),
    ("n", -9),
    ("p", -12),
    ("f", -15),
    ("a", -18),
];

impl Unit {
    /// The pure number 1.
    pub fn none() -> Unit {
        Unit {
            text: "1".into(),
            dimension: Dimension::none(),
            rational: Number::ONE,
            pi_power: 0,
            counts: Counts::Unknown,
        }
    }

    /// Whether it is one of length.
    pub fn is_length(&self) -> bool {
        self.dimension == Dimension::length()
    }

    /// The coherent SI unit of a dimension.
    pub fn coherent(dimension: Dimension) -> Unit {
        Unit { text: dimension.si_unit(), dimension, ..Unit::none() }
    }

    /// The meaning of a unit in brackets.
    ///
    /// # Errors
    /// At a name that is no unit, with the nearest that is.
    pub fn resolve(unit: &dsl::Unit) -> syn::Result<Unit> {
        let counts = Counts::of(unit.factors.iter().map(|(name, _)| name.to_string()));
        let mut resolved = Unit { text: unit.text.clone(), counts, ..Unit::none() };
        for (name, exponent) in &unit.factors {
            let (dimension, rational, pi_power) = look_up(&name.to_string()).ok_or_else(|| unknown(name))?;
            let exponent = i64::from(*exponent);
            let power =
                rational.pow(exponent).ok_or_else(|| syn::Error::new(name.span(), "this unit is out of range"))?;
            resolved.dimension = resolved.dimension.times(&dimension.to_the(&exponent.into()));
            resolved.rational = &resolved.rational * &power;
            resolved.pi_power += pi_power * exponent;
        }
        let factor = resolved.factor();
        if !factor.is_finite() || factor == 0.0 {
            return Err(unit.region.error("the size of this unit is outside the range of numbers"));
        }
        Ok(resolved)
    }

    /// Reads a unit from text without brackets.
    ///
    /// # Errors
    /// The mistake, in one sentence.
    pub fn parse(text: &str) -> Result<Unit, String> {
        dsl::parse_unit(text).and_then(|unit| Unit::resolve(&unit)).map_err(|e| e.to_string())
    }

    /// Why a number in this unit is taken for another where that one is declared, though their dimensions agree.
    pub fn mistaken_for(&self, declared: &Unit) -> Option<String> {
        let (given, needed) = (self.text(), declared.text());
        match (self.counts, declared.counts) {
            (Counts::Cycles, Counts::Angles) => Some(format!(
                "`{given}` counts cycles and `{needed}` angles; write `rev/s` for cycles in a second, or `rad/s`"
            )),
            (Counts::Angles, Counts::Cycles) => {
                Some(format!("`{given}` measures an angle and `{needed}` counts cycles; write `Hz` or `1/s`"))
            }
            _ => None,
        }
    }

    /// Whether it counts cycles where another measures angles.
    pub(super) fn counts_cycles_of(&self, angles: &Unit) -> bool {
        (self.counts, angles.counts) == (Counts::Cycles, Counts::Angles)
    }

    /// Whether numbers in one are numbers in the other: `J` and `N*m`, `rad` and `1`.
    pub fn is_same_as(&self, other: &Unit) -> bool {
        self.dimension == other.dimension
            && self.rational == other.rational
            && self.pi_power == other.pi_power
            && self.mistaken_for(other).is_none()
    }

    /// Whether it was written rather than left out.
    pub fn is_declared(&self) -> bool {
        *self != Unit::none()
    }

    /// As the user wrote it.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// Its dimension.
    pub fn dimension(&self) -> &Dimension {
        &self.dimension
    }

    /// Its size in SI units.
    pub fn factor(&self) -> f64 {
        self.rational.to_f64() * std::f64::consts::PI.powi(self.pi_power as i32)
    }

    /// A decimal number in this unit in SI units, with the bits that a declaration gives it. `None` if it is no number, or out of range.
    pub fn to_si(&self, decimal: &str) -> Option<f64> {
        let (sign, digits) = match decimal.strip_prefix('-') {
            Some(digits) => (-1.0, digits),
            None => (1.0, decimal.strip_prefix('+').unwrap_or(decimal)),
        };
        let mut graph = Graph::new();
        let (number, factor) = (Number::parse_decimal(digits)?, self.factor_expression(&mut graph));
        let number = graph.number(number);
        let value = graph.mul(number, factor);
        evaluate(&graph, &[value], |_| f64::NAN).first().map(|value| sign * value).filter(|value| value.is_finite())
    }

    /// A value in SI units in this unit: with as few digits as [`Unit::to_si`] needs to give it back, or all if none do.
    pub fn from_si(&self, value: f64) -> f64 {
        let near = value / self.factor();
        let decimals = (14..=16).map(|digits| format!("{near:.digits$e}"));
        let again = decimals.filter(|decimal| self.to_si(decimal) == Some(value));
        again.filter_map(|decimal| decimal.parse().ok()).next().unwrap_or(near)
    }

    /// Its size in SI units, exactly.
    pub fn factor_expression(&self, graph: &mut Graph) -> Expr {
        let rational = graph.number(self.rational.clone());
        let pi = graph.constant(Constant::Pi);
        let power = graph.integer_power(pi, self.pi_power);
        graph.mul(rational, power)
    }

    /// The coherent SI unit of its dimension, as the user writes it if that is one: `N*m`, `rad`.
    pub fn si_text(&self) -> String {
        match self.dimension == Dimension::energy() && self.text.contains('J') {
            _ if self.rational.is_one() && self.pi_power == 0 => self.text.clone(),
            true => "J".to_owned(),
            false => self.dimension.si_unit(),
        }
    }

    /// Whether it is a unit of angles, as `deg` is and `percent` is not.
    pub fn is_of_angles(&self) -> bool {
        self.counts == Counts::Angles && self.dimension.is_none()
    }

    /// The unit of this quantity's rate of the given order: `rad/s^2`.
    pub fn per_time(&self, order: u32) -> Unit {
        let below = if order == 1 { "s".to_owned() } else { format!("s^{order}") };
        let text = match self.text.contains('/') {
            true => format!("({})/{below}", self.text),
            false => format!("{}/{below}", self.text),
        };
        let per = Dimension::time().to_the(&(-i64::from(order)).into());
        Unit { text, dimension: self.dimension.times(&per), ..self.clone() }
    }
}

impl Counts {
    /// What a unit of these factors counts in.
    fn of(factors: impl Iterator<Item = String> + Clone) -> Counts {
        let is_angle = |name: &str| name.ends_with("rad") || ["deg", "rev", "rpm"].contains(&name);
        let has_angles = factors.clone().any(|name| is_angle(&name));
        let has_cycles = factors.clone().any(|name| name.ends_with("Hz"));
        match (has_angles, has_cycles) {
            (true, false) => Counts::Angles,
            (false, true) => Counts::Cycles,
            _ => Counts::Unknown,
        }
    }
}

fn look_up(name: &str) -> Option<(Dimension, Number, i64)> {
    let row = |name: &str| UNITS.iter().find(|row| row.0 == name);
    let size = |row: &UnitRow| Number::fraction(row.2, row.3);
    if let Some(row) = row(name) {
        return Some((Dimension::of(row.1), size(row)?, row.4));
    }
    PREFIXES.iter().find_map(|(prefix, power)| {
        let row = name.strip_prefix(prefix).and_then(row).filter(|row| row.5)?;
        let scale = Number::from(10).pow(*power)?;
        Some((Dimension::of(row.1), &size(row)? * &scale, row.4))
    })
}

/// Common spellings of units that the table lists under another name.
const OTHER_SPELLINGS: [(&str, &str); 14] = [
    ("Nm", "N*m"),
    ("metre", "m"),
    ("meter", "m"),
    ("sec", "s"),
    ("second", "s"),
    ("kilogram", "kg"),
    ("gram", "g"),
    ("degree", "deg"),
    ("degrees", "deg"),
    ("radian", "rad"),
    ("rads", "rad"),
    ("newton", "N"),
    ("hour", "h"),
    ("s2", "s^2"),
];

/// The known units, for a name unlike any of them.
const KNOWN: &str = "; known units are m, g, s, N, J, W, Pa, bar, A, V, Hz, rad, \
     deg, rpm, min, inch, lb and others, with SI prefixes";

fn unknown(name: &syn::Ident) -> syn::Error {
    if let Some((_, right)) = OTHER_SPELLINGS.iter().find(|(other, _)| name == other) {
        return syn::Error::new(name.span(), format!("`{name}` is not a known unit; write `{right}`"));
    }
    let common = ["mm", "cm", "km", "kg", "ms", "kN", "mN", "MPa", "kW", "kHz", "mrad"];
    let near = nearest::suggestion(&name.to_string(), UNITS.iter().map(|row| row.0).chain(common));
    let known = if near.is_empty() { KNOWN } else { "" };
    syn::Error::new(name.span(), format!("`{name}` is not a known unit{near}{known}"))
}

#[cfg(test)]
mod tests {
    use super::Unit;

    #[test]
    fn sizes_are_the_defined_ones() {
        let pi = std::f64::consts::PI;
        let table = [
            ("mm", 1e-3),
            ("kg*m^2", 1.0),
            ("rpm", pi / 30.0),
            ("deg", pi / 180.0),
            ("kN", 1e3),
            ("bar", 1e5),
            ("g", 1e-3),
            ("km/h", 1.0 / 3.6),
            ("N*m/rad", 1.0),
            ("W/(m*K)", 1.0),
            ("1/s", 1.0),
            ("min", 60.0),
            ("inch", 0.0254),
            ("cm^2", 1e-4),
            ("us", 1e-6),
            ("\u{b5}s", 1e-6),
            ("\u{3bc}s", 1e-6),
        ];
        for (text, factor) in table {
            let unit = Unit::parse(text).unwrap();
            assert!((unit.factor() / factor - 1.0).abs() < 4.0 * f64::EPSILON, "{text}: {}", unit.factor());
            assert_eq!(unit.text(), text);
        }
    }

    #[test]
    fn cycles_are_not_taken_for_angles() {
        let is_mistaken = |given: &str, declared: &str| {
            Unit::parse(given).unwrap().mistaken_for(&Unit::parse(declared).unwrap()).is_some()
        };
        for (cycles, angles) in [("Hz", "rad/s"), ("kHz", "rpm"), ("Hz", "deg/s"), ("mHz", "urad/s")] {
            assert!(is_mistaken(cycles, angles) && is_mistaken(angles, cycles));
        }
        for (given, declared) in [("rpm", "rad/s"), ("1/s", "rad/s"), ("Hz", "1/s"), ("1/s", "Hz"), ("kHz", "Hz")] {
            assert!(!is_mistaken(given, declared));
        }
    }

    #[test]
    fn names_of_dimensions() {
        for (text, si) in [
            ("kg*m/s^2", "N"),
            ("N*mm", "N*m"),
            ("kg/s^2", "N/m"),
            ("m/s", "m/s"),
            ("rad", "1"),
            ("kg/(m*s)", "kg/(m*s)"),
            ("m^2*kg", "kg*m^2"),
            ("1/s^2", "1/s^2"),
        ] {
            assert_eq!(Unit::parse(text).unwrap().dimension().si_unit(), si);
        }
    }

    #[test]
    fn mistakes_name_the_nearest_unit() {
        for bad in ["m^2s", "01/s", "m)", "(m", "m^+1", &"(".repeat(100_000)] {
            assert!(Unit::parse(bad).is_err(), "{bad}");
        }
        assert_eq!(Unit::parse("m/m*".repeat(200).trim_end_matches('*')).unwrap().factor(), 1.0);
        assert_eq!(Unit::parse("kgg").unwrap_err(), "`kgg` is not a known unit (did you mean `kg`?)");
        assert_eq!(Unit::parse("Rpm").unwrap_err(), "`Rpm` is not a known unit (did you mean `rpm`?)");
        assert!(Unit::parse("m/").unwrap_err().contains("not a unit"));
        assert!(Unit::parse("").unwrap_err().contains("not a unit"));
    }
}
