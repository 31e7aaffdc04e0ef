//! Arithmetic in `f64` that knows how wrong it may be.

use codegen::symbolic::Function;

/// The relative error granted to every operation: the engine may do it as a few roundings of half an
/// epsilon each, in another order, and the functions of the platform are good to about one epsilon.
const ROUNDING: f64 = 8.0 * f64::EPSILON;

/// Beyond this, powers of factors overflow though that of their product does not.
const LARGEST_EXPONENT: i64 = 100;

/// A value with what is known of it.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Tracked {
    Finite(Approximation),
    /// Infinite, of a sign that depends on the sign of a zero.
    Pole,
    Nan,
    /// Rounding, the range of `f64` or the sign of a zero decide what the value is; or a difference of two
    /// infinite or undefined values, which is 0 in the engine if they are the same.
    Unknown,
}

#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) enum Kind {
    Finite,
    NotFinite,
    Unknown,
}

#[derive(Clone, Copy, Debug)]
pub(crate) struct Approximation {
    value: f64,
    /// How far the exact value, and any other way to compute it, can be away. Propagated to first order:
    /// it is kept below a millionth.
    error: f64,
    /// The sum of the magnitudes of the terms when numbers are multiplied out, as the engine does. Roundings
    /// are relative to this, not to the value.
    size: f64,
    /// Set if the value is exact and a multiple of `2^-bits`, where `size` is so small that every order of
    /// additions and multiplications is exact as well.
    bits: Option<i32>,
}

impl Tracked {
    /// A value without error.
    pub(crate) fn exact(value: f64) -> Tracked {
        let bits = (0..8).find(|bits| (value * 2f64.powi(*bits)).fract() == 0.0);
        Approximation { value, error: 0.0, size: value.abs(), bits }.settle()
    }

    /// A value rounded once.
    pub(crate) fn rounded(value: f64) -> Tracked {
        Approximation::of(value, 0.0).settle()
    }

    pub(crate) fn kind(self) -> Kind {
        match self {
            Tracked::Finite(_) => Kind::Finite,
            Tracked::Pole | Tracked::Nan => Kind::NotFinite,
            Tracked::Unknown => Kind::Unknown,
        }
    }

    /// Whether a value computed in another way agrees; `None` if that cannot be told.
    pub(crate) fn agrees(self, value: f64) -> Option<bool> {
        match self {
            Tracked::Finite(a) => Some((value - a.value).abs() <= a.error),
            Tracked::Pole => Some(value.is_infinite()),
            Tracked::Nan => Some(value.is_nan()),
            Tracked::Unknown => None,
        }
    }

    pub(crate) fn plus(self, other: Tracked) -> Tracked {
        use Tracked::*;
        match (self, other) {
            (Finite(a), Finite(b)) => a.plus(b).settle(),
            (Finite(_), unbounded @ (Pole | Nan)) | (unbounded @ (Pole | Nan), Finite(_)) => unbounded,
            _ => Unknown,
        }
    }

    pub(crate) fn minus(self, other: Tracked) -> Tracked {
        self.plus(Tracked::exact(-1.0).times(other))
    }

    pub(crate) fn times(self, other: Tracked) -> Tracked {
        use Tracked::*;
        match (self, other) {
            (Finite(a), Finite(b)) => a.times(b).settle(),
            (Unknown, _) | (_, Unknown) => Unknown,
            (Nan, _) | (_, Nan) => Nan,
            (Pole, Pole) => Pole,
            (Pole, Finite(a)) | (Finite(a), Pole) => match a.sign() {
                Some(0) => Nan,
                Some(_) => Pole,
                None => Unknown,
            },
        }
    }

    pub(crate) fn over(self, other: Tracked) -> Tracked {
        self.times(other.power(-1))
    }

    /// The integer power; the zeroth is 1 for all values, as in `f64::powi`.
    pub(crate) fn power(self, exponent: i64) -> Tracked {
        if exponent.abs() > LARGEST_EXPONENT {
            return Tracked::Unknown;
        }
        let power = (0..exponent.unsigned_abs()).fold(Tracked::exact(1.0), |power, _| power.times(self));
        if exponent < 0 { power.inverse() } else { power }
    }

    fn inverse(self) -> Tracked {
        match self {
            Tracked::Finite(a) => match a.sign() {
                Some(0) => Tracked::Pole,
                Some(_) => a.inverse().settle(),
                None => Tracked::Unknown,
            },
            Tracked::Pole => Tracked::exact(0.0),
            other => other,
        }
    }

    /// The power as `f64::powf` defines it, at values that are only approximately known.
    ///
    /// A fraction p/q is the p-th power of a root in the engine, which takes about p roundings.
    pub(crate) fn to_the(self, exponent: Tracked, roundings: u32) -> Tracked {
        use Tracked::*;
        let Finite(exponent) = exponent else { return Unknown };
        if exponent.value.abs() > LARGEST_EXPONENT as f64 {
            return Unknown;
        }
        if let Some(integer) = exponent.as_integer() {
            return self.power(integer);
        }
        match (self, exponent.sign()) {
            (Nan, Some(_)) => Nan,
            (Finite(base), sign) => match (base.sign(), sign) {
                (Some(0), Some(1)) => Tracked::exact(0.0),
                (Some(0), Some(-1)) => Pole,
                (Some(1), _) => base.to_the(exponent, roundings),
                (Some(-1), _) if !exponent.may_be_integer() => Nan,
                _ => Unknown,
            },
            _ => Unknown,
        }
    }

    pub(crate) fn call(self, function: Function) -> Tracked {
        use Tracked::*;
        match (function, self) {
            (_, Finite(a)) => a.call(function),
            (_, Nan) => Nan,
            (Function::Sin | Function::Cos | Function::Tan | Function::Asin | Function::Acos, Pole) => Nan,
            (Function::Sinh | Function::Cosh | Function::Abs, Pole) => Pole,
            _ => Unknown,
        }
    }

    /// The first where this is above zero, the second where it is not.
    pub(crate) fn choose(self, above: Tracked, otherwise: Tracked) -> Tracked {
        match self {
            Tracked::Finite(difference) => match difference.sign() {
                Some(1) => above,
                Some(_) => otherwise,
                None => Tracked::Unknown,
            },
            Tracked::Nan => Tracked::Nan,
            Tracked::Pole | Tracked::Unknown => Tracked::Unknown,
        }
    }

    pub(crate) fn atan2(self, x: Tracked) -> Tracked {
        use Tracked::*;
        match (self, x) {
            (Finite(y), Finite(x)) => match (y.sign(), x.sign()) {
                // On the cut, the sign of a zero decides between pi and -pi.
                (Some(1 | -1), _) | (_, Some(1)) => {
                    // To first order; doubled for what that leaves out.
                    let turn = (x.error + y.error) / x.value.hypot(y.value);
                    Approximation::of(y.value.atan2(x.value), 2.0 * turn).settle()
                }
                _ => Unknown,
            },
            (Nan, Finite(_) | Nan) | (Finite(_), Nan) => Nan,
            _ => Unknown,
        }
    }
}

impl Approximation {
    /// A value rounded once, from arguments whose errors move it this far.
    fn of(value: f64, moved: f64) -> Approximation {
        Approximation { value, error: moved + ROUNDING * value.abs(), size: value.abs(), bits: None }
    }

    /// Gives up where the first-order error, or the range of `f64`, is left.
    fn settle(self) -> Tracked {
        let in_range = |x: f64| x == 0.0 || (1e-100..1e100).contains(&x.abs());
        let known = self.error <= 1e-6 * (1.0 + self.value.abs());
        let exact = self.bits.filter(|bits| self.size * 2f64.powi(*bits) < 2f64.powi(45));
        match in_range(self.value) && in_range(self.size) && known {
            true if exact.is_some() => Tracked::Finite(Approximation { error: 0.0, ..self }),
            true => Tracked::Finite(Approximation { bits: None, ..self }),
            false => Tracked::Unknown,
        }
    }

    /// -1, 0 or 1 if it is certain.
    fn sign(self) -> Option<i32> {
        match self.value {
            0.0 if self.error == 0.0 => Some(0),
            value if value.abs() > self.error => Some(value.signum() as i32),
            _ => None,
        }
    }

    /// The value, if it certainly is an integer.
    fn as_integer(self) -> Option<i64> {
        (self.error == 0.0 && self.value.fract() == 0.0).then_some(self.value as i64)
    }

    fn may_be_integer(self) -> bool {
        (self.value - self.value.round()).abs() <= self.error
    }

    fn plus(self, other: Approximation) -> Approximation {
        let size = self.size + other.size;
        Approximation {
            value: self.value + other.value,
            error: self.error + other.error + ROUNDING * size,
            size,
            bits: self.bits.zip(other.bits).map(|(a, b)| a.max(b)),
        }
    }

    fn times(self, other: Approximation) -> Approximation {
        let size = self.size * other.size;
        let moved = self.value.abs() * other.error + self.error * (other.value.abs() + other.error);
        Approximation {
            value: self.value * other.value,
            error: moved + ROUNDING * size,
            size,
            bits: self.bits.zip(other.bits).map(|(a, b)| a + b),
        }
    }

    /// Exact only for powers of two.
    fn inverse(self) -> Approximation {
        let value = self.value.recip();
        let moved = self.error / (self.value.abs() * (self.value.abs() - self.error));
        let exponent = self.value.abs().log2();
        let bits = self.bits.filter(|_| exponent.fract() == 0.0).map(|_| (exponent as i32).max(0));
        Approximation { bits, ..Approximation::of(value, moved) }
    }

    /// As in `call`, with corners for ends.
    fn to_the(self, exponent: Approximation, roundings: u32) -> Tracked {
        let power = |base: f64, exponent: f64| base.powf(exponent);
        let value = power(self.value, exponent.value);
        if value == 0.0 {
            // Underflow.
            return Tracked::Unknown;
        }
        let moved = |d: f64, e: f64| (power(self.value + d, exponent.value + e) - value).abs();
        let (d, e) = (self.error, exponent.error);
        // That the exponent is rounded counts ln(base) times.
        let rounded = ROUNDING * (f64::from(roundings) + (exponent.value * self.value.ln()).abs()) * value;
        let corners = moved(d, e).max(moved(d, -e)).max(moved(-d, e)).max(moved(-d, -e));
        Approximation::of(value, 2.0 * corners + rounded).settle()
    }

    /// Every function is monotonic on intervals as short as the error, or changes even less: the ends tell how
    /// far the value moves. That is doubled, since the ends are themselves rounded.
    fn call(self, function: Function) -> Tracked {
        let at = |x: f64| apply(function, x);
        let (below, value, above) = (at(self.value - self.error), at(self.value), at(self.value + self.error));
        match (function, self.sign()) {
            (Function::Sign, None) => return Tracked::Unknown,
            (Function::Sign, Some(sign)) => return Tracked::exact(sign.into()),
            (Function::Abs, _) => return Approximation { value, ..self }.settle(),
            (Function::Ln, Some(0)) => return Tracked::Pole,
            // Underflow.
            (Function::Exp, _) if value == 0.0 => return Tracked::Unknown,
            _ if [below, value, above].iter().all(|x| x.is_nan()) => return Tracked::Nan,
            _ if [below, value, above].iter().any(|x| !x.is_finite()) => return Tracked::Unknown,
            _ => {}
        }
        let moved = (below - value).abs().max((above - value).abs());
        match value == 0.0 && moved == 0.0 {
            true => Tracked::exact(0.0),
            false => Approximation::of(value, 2.0 * moved).settle(),
        }
    }
}

fn apply(function: Function, x: f64) -> f64 {
    match function {
        Function::Sin => x.sin(),
        Function::Cos => x.cos(),
        Function::Tan => x.tan(),
        Function::Asin => x.asin(),
        Function::Acos => x.acos(),
        Function::Atan => x.atan(),
        Function::Sinh => x.sinh(),
        Function::Cosh => x.cosh(),
        Function::Tanh => x.tanh(),
        Function::Exp => x.exp(),
        Function::Ln => x.ln(),
        Function::Abs => x.abs(),
        Function::Sign => x.signum(),
    }
}
