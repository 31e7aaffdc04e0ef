//! Physical dimensions: exact rational exponents of metre, kilogram, second, ampere and kelvin.
//!
//! Angles have no dimension, so arcs are lengths, and torques are J/rad. A vector has one dimension: mixed ones would
//! make `norm` and `inner` meaningless.

use crate::symbolic::Number;

/// Names of the base units, in the order of the exponents.
const BASE: [&str; 5] = ["m", "kg", "s", "A", "K"];
/// The order in which they are printed.
const PRINTED: [usize; 5] = [1, 0, 2, 3, 4];

/// Units with names of their own, and those better known in terms of a force than of a mass.
const NAMED: [([i64; 5], &str); 11] = [
    ([1, 1, -2, 0, 0], "N"),
    ([2, 1, -2, 0, 0], "N*m"),
    ([0, 1, -2, 0, 0], "N/m"),
    ([0, 1, -1, 0, 0], "N*s/m"),
    ([1, 1, -1, 0, 0], "N*s"),
    ([2, 1, -1, 0, 0], "N*m*s"),
    ([2, 1, -3, 0, 0], "W"),
    ([-1, 1, -2, 0, 0], "Pa"),
    ([2, 1, -3, -1, 0], "V"),
    ([2, 1, -3, -2, 0], "Ohm"),
    ([2, 1, -2, -2, 0], "H"),
];

/// A physical dimension.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Dimension([Number; 5]);

impl Dimension {
    /// A pure number.
    pub fn none() -> Dimension {
        Dimension::of([0; 5])
    }

    /// By exponents of m, kg, s, A and K.
    pub fn of(exponents: [i64; 5]) -> Dimension {
        Dimension(exponents.map(Number::from))
    }

    /// Whether it is that of a pure number.
    pub fn is_none(&self) -> bool {
        self.0.iter().all(Number::is_zero)
    }

    /// Length.
    pub fn length() -> Dimension {
        Dimension::of([1, 0, 0, 0, 0])
    }

    /// Mass.
    pub fn mass() -> Dimension {
        Dimension::of([0, 1, 0, 0, 0])
    }

    /// Moment of inertia.
    pub fn inertia() -> Dimension {
        Dimension::of([2, 1, 0, 0, 0])
    }

    /// Acceleration.
    pub fn acceleration() -> Dimension {
        Dimension::of([1, 0, -2, 0, 0])
    }

    /// Force.
    pub fn force() -> Dimension {
        Dimension::of([1, 1, -2, 0, 0])
    }

    /// Energy, which is also the dimension of a torque.
    pub fn energy() -> Dimension {
        Dimension::of([2, 1, -2, 0, 0])
    }

    /// Time.
    pub fn time() -> Dimension {
        Dimension::of([0, 0, 1, 0, 0])
    }

    /// The dimension of a product.
    pub fn times(&self, other: &Dimension) -> Dimension {
        Dimension(std::array::from_fn(|i| &self.0[i] + &other.0[i]))
    }

    /// The dimension of a power.
    pub fn to_the(&self, exponent: &Number) -> Dimension {
        Dimension(std::array::from_fn(|i| &self.0[i] * exponent))
    }

    /// The dimension of a quotient.
    pub fn over(&self, other: &Dimension) -> Dimension {
        self.times(&other.to_the(&Number::MINUS_ONE))
    }

    /// The coherent SI unit of this dimension, as engineers write it: `N`, `N*m`, `N/m`, `m/s^2`.
    pub fn si_unit(&self) -> String {
        if let Some((_, name)) = NAMED.iter().find(|(exponents, _)| Dimension::of(*exponents) == *self) {
            return (*name).to_owned();
        }
        let part = |negative: bool| -> Vec<String> {
            let printed = PRINTED.iter().map(|i| (BASE[*i], &self.0[*i]));
            let exponents = printed.filter(|(_, e)| !e.is_zero() && e.is_negative() == negative);
            exponents
                .map(|(base, e)| match e.abs() {
                    one if one.is_one() => base.to_owned(),
                    whole if whole.is_integer() => format!("{base}^{whole}"),
                    fraction => format!("{base}^({fraction})"),
                })
                .collect()
        };
        let (above, below) = (part(false), part(true));
        let above = if above.is_empty() { "1".to_owned() } else { above.join("*") };
        match below.as_slice() {
            [] => above,
            [one] => format!("{above}/{one}"),
            _ => format!("{above}/({})", below.join("*")),
        }
    }
}
