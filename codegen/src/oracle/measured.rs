//! Numbers that carry the magnitude of their terms.

use std::iter::Sum;
use std::ops::{Add, Mul, Neg, Sub};

/// A value and the sum of the absolute values that went into it.
///
/// A given number has its own absolute value as magnitude; sums and differences add magnitudes, and f(u) has
/// |f(u)| + |f'(u)| times the magnitude of u, each derivative of f likewise. The errors of factors make the error
/// a db + b da in a product (running error analysis: Higham, Accuracy and Stability of Numerical Algorithms, 2nd ed.,
/// 3.3), so with magnitudes A and B it has |a| B + |b| A, but at most A B. So if every given number and every operation
/// is off by a relative eps, then a result of N operations is off by at most N eps magnitude (to first order in eps),
/// and two evaluations may be compared within a small multiple of that.
///
/// Where both factors are sums that cancel, an evaluation that multiplies out is off by eps A B, although a and b vanish.
/// A thousandth of A B is added for that: comparisons allow thousands of eps.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub struct Measured {
    /// The value.
    pub value: f64,
    /// The sum of the absolute values of its terms; never below |value|.
    pub magnitude: f64,
}

impl Measured {
    /// Nothing.
    pub const ZERO: Measured = Measured { value: 0.0, magnitude: 0.0 };

    /// A given number.
    pub fn given(value: f64) -> Measured {
        Measured { value, magnitude: value.abs() }
    }

    /// f(u) from the values there of f and of its derivative.
    pub(super) fn function(f: f64, slope: f64, u: Measured) -> Measured {
        Measured { value: f, magnitude: f.abs() + product(slope.abs(), u.magnitude) }
    }
}

/// The part of A B in the magnitude of a product: of the 4500 eps that the strictest comparison allows (1e-12), it
/// leaves 4 eps A B.
const MULTIPLIED_OUT: f64 = 1e-3;

/// a*b of magnitudes, with 0 times infinity as 0.
fn product(a: f64, b: f64) -> f64 {
    if a == 0.0 || b == 0.0 { 0.0 } else { a * b }
}

impl Add for Measured {
    type Output = Measured;
    fn add(self, other: Measured) -> Measured {
        Measured { value: self.value + other.value, magnitude: self.magnitude + other.magnitude }
    }
}

impl Sub for Measured {
    type Output = Measured;
    fn sub(self, other: Measured) -> Measured {
        self + -other
    }
}

impl Mul for Measured {
    type Output = Measured;
    fn mul(self, other: Measured) -> Measured {
        let ([a, b], [size_a, size_b]) = ([self.value.abs(), other.value.abs()], [self.magnitude, other.magnitude]);
        let most = product(size_a, size_b);
        let magnitude = (product(a, size_b) + product(b, size_a) + MULTIPLIED_OUT * most).min(most);
        Measured { value: self.value * other.value, magnitude }
    }
}

impl Neg for Measured {
    type Output = Measured;
    fn neg(self) -> Measured {
        Measured { value: -self.value, ..self }
    }
}

impl Sum for Measured {
    fn sum<I: Iterator<Item = Measured>>(terms: I) -> Measured {
        terms.fold(Measured::ZERO, |sum, term| sum + term)
    }
}

/// The scalar product of two rows of equal length.
pub(super) fn inner(a: &[Measured], b: &[Measured]) -> Measured {
    a.iter().zip(b).map(|(a, b)| *a * *b).sum()
}
