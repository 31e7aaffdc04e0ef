//! Numbers that carry a derivative through a kernel.

use crate::Scalar;
use core::ops::{Add, Div, Mul, Neg, Sub};

/// A number and its derivative in one direction: a kernel on dual numbers gives its own directional derivative
/// (forward differentiation; Griewank, Walther: Evaluating Derivatives, 2nd ed., 2008, ch. 3).
///
/// Comparisons, and with them refused pivots, are those of the values. At kinks the derivative is that of the
/// engine: of |x| it is sign(x), 0 at 0, and of sign(x) it is 0 everywhere. Where a function has no finite derivative, as
/// sqrt at 0, the result is infinite or NaN. `S` may be [`Lanes`](crate::Lanes) or dual itself.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dual<S = f64> {
    /// The number.
    pub value: S,
    /// Its derivative.
    pub derivative: S,
}

impl<S: Scalar> Dual<S> {
    /// A number that does not change.
    #[inline(always)]
    pub fn constant(value: S) -> Self {
        Dual { value, derivative: S::from_f64(0.0) }
    }

    /// The variable of differentiation.
    #[inline(always)]
    pub fn variable(value: S) -> Self {
        Dual { value, derivative: S::from_f64(1.0) }
    }

    /// f(self), with the derivative `slope` there.
    #[inline(always)]
    fn chain(self, value: S, slope: S) -> Self {
        Dual { value, derivative: slope * self.derivative }
    }
}

impl<S: Scalar> Add for Dual<S> {
    type Output = Self;

    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Dual { value: self.value + other.value, derivative: self.derivative + other.derivative }
    }
}

impl<S: Scalar> Sub for Dual<S> {
    type Output = Self;

    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Dual { value: self.value - other.value, derivative: self.derivative - other.derivative }
    }
}

impl<S: Scalar> Mul for Dual<S> {
    type Output = Self;

    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        let derivative = self.derivative * other.value + self.value * other.derivative;
        Dual { value: self.value * other.value, derivative }
    }
}

impl<S: Scalar> Div for Dual<S> {
    type Output = Self;

    #[inline(always)]
    fn div(self, other: Self) -> Self {
        let value = self.value / other.value;
        Dual { value, derivative: (self.derivative - value * other.derivative) / other.value }
    }
}

impl<S: Scalar> Neg for Dual<S> {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        Dual { value: -self.value, derivative: -self.derivative }
    }
}

impl<S: Scalar> Scalar for Dual<S> {
    type Mask = S::Mask;
    const HALF_DIGITS: f64 = S::HALF_DIGITS;
    const ZERO: Dual<S> = Dual { value: S::ZERO, derivative: S::ZERO };

    #[inline(always)]
    fn from_f64(value: f64) -> Self {
        Dual::constant(S::from_f64(value))
    }

    #[inline(always)]
    fn first_value(self) -> f64 {
        self.value.first_value()
    }

    #[inline(always)]
    fn greater(self, other: Self) -> S::Mask {
        self.value.greater(other.value)
    }

    #[inline(always)]
    fn at_most(self, other: Self) -> S::Mask {
        self.value.at_most(other.value)
    }

    #[inline(always)]
    fn not(mask: S::Mask) -> S::Mask {
        S::not(mask)
    }

    #[inline(always)]
    fn select(mask: S::Mask, yes: Self, no: Self) -> Self {
        Dual { value: S::select(mask, yes.value, no.value), derivative: S::select(mask, yes.derivative, no.derivative) }
    }

    #[inline(always)]
    fn gather<const N: usize>(self, of: impl Fn(f64) -> [f64; N]) -> [Self; N] {
        self.value.gather(of).map(Dual::constant)
    }

    #[inline(always)]
    fn sin_cos_each<const N: usize>(angles: [Self; N]) -> ([Self; N], [Self; N]) {
        let (sines, cosines) = S::sin_cos_each(angles.map(|angle| angle.value));
        (
            core::array::from_fn(|i| angles[i].chain(sines[i], cosines[i])),
            core::array::from_fn(|i| angles[i].chain(cosines[i], -sines[i])),
        )
    }

    fn tan(self) -> Self {
        let value = self.value.tan();
        self.chain(value, one::<S>() + value * value)
    }

    fn asin(self) -> Self {
        self.chain(self.value.asin(), one::<S>() / leg(self.value))
    }

    fn acos(self) -> Self {
        self.chain(self.value.acos(), -one::<S>() / leg(self.value))
    }

    fn atan(self) -> Self {
        self.chain(self.value.atan(), one::<S>() / (one::<S>() + self.value * self.value))
    }

    fn atan2(self, x: Self) -> Self {
        let squared = self.value * self.value + x.value * x.value;
        let derivative = (self.derivative * x.value - self.value * x.derivative) / squared;
        Dual { value: self.value.atan2(x.value), derivative }
    }

    fn sinh(self) -> Self {
        self.chain(self.value.sinh(), self.value.cosh())
    }

    fn cosh(self) -> Self {
        self.chain(self.value.cosh(), self.value.sinh())
    }

    fn tanh(self) -> Self {
        let value = self.value.tanh();
        self.chain(value, one::<S>() - value * value)
    }

    fn exp(self) -> Self {
        let value = self.value.exp();
        self.chain(value, value)
    }

    fn ln(self) -> Self {
        self.chain(self.value.ln(), one::<S>() / self.value)
    }

    fn sqrt(self) -> Self {
        let value = self.value.sqrt();
        self.chain(value, S::from_f64(0.5) / value)
    }

    /// A constant exponent contributes nothing to the derivative: the logarithm exists only for positive bases.
    fn powf(self, exponent: Self) -> Self {
        let value = self.value.powf(exponent.value);
        let by_base = exponent.value * self.value.powf(exponent.value - one::<S>()) * self.derivative;
        let changes = exponent.derivative.abs().greater(S::from_f64(0.0));
        let by_exponent = S::select(changes, value * self.value.ln() * exponent.derivative, exponent.derivative);
        Dual { value, derivative: by_base + by_exponent }
    }

    fn abs(self) -> Self {
        self.chain(self.value.abs(), self.value.sign())
    }

    fn sign(self) -> Self {
        Dual::constant(self.value.sign())
    }
}

fn one<S: Scalar>() -> S {
    S::from_f64(1.0)
}

/// sqrt(1 - x^2), in factors that keep their digits near 1.
fn leg<S: Scalar>(x: S) -> S {
    ((one::<S>() - x) * (one::<S>() + x)).sqrt()
}
