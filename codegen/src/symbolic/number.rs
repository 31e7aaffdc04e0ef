//! Exact rational numbers, the only constants of the engine.
//!
//! Nearly all numbers of a mechanism are small fractions, so they live in two machine words; what does
//! not fit moves to arbitrary precision and comes back when it can. The representation is unique (a
//! value that fits in words never stays large), so equality and hashing are structural. Sums and products that have become very
//! long are rounded to the nearest `f64`.

use dashu_base::{BitTest, Gcd, Signed};
use dashu_int::UBig;
use dashu_ratio::RBig;
use std::borrow::Cow;
use std::cmp::Ordering;
use std::fmt;
use std::ops::{Add, Mul, Neg, Sub};

/// An exact rational number in lowest terms.
#[derive(Clone, PartialEq, Eq, Hash)]
pub struct Number(Repr);

#[derive(Clone, PartialEq, Eq, Hash)]
enum Repr {
    /// Numerator and positive denominator, coprime.
    Small(i64, i64),
    /// Only what does not fit in [`Repr::Small`].
    Big(Box<RBig>),
}

/// Numerator and denominator have together at most so many bits, as three decimals of 16 digits multiplied.
const MOST_BITS: usize = 384;

/// The quotient of two words, neither of them zero, rounded once.
fn nearest_quotient(n: u64, d: u64) -> f64 {
    // At least 64 bits of the quotient, the last of which stands for all behind it.
    let shift = 64 + n.leading_zeros();
    let (shifted, d) = (u128::from(n) << shift, u128::from(d));
    let quotient = (shifted / d) | u128::from(shifted % d != 0);
    // Divided by a power of two, which is exact.
    quotient as f64 / (1u128 << shift) as f64
}

fn bits(value: &RBig) -> usize {
    value.numerator().bit_len() + value.denominator().bit_len()
}

impl Number {
    /// 0.
    pub const ZERO: Number = Number(Repr::Small(0, 1));
    /// 1.
    pub const ONE: Number = Number(Repr::Small(1, 1));
    /// 1/2.
    pub const HALF: Number = Number(Repr::Small(1, 2));
    /// -1.
    pub const MINUS_ONE: Number = Number(Repr::Small(-1, 1));

    /// The fraction `numerator / denominator`; `None` if the denominator is zero.
    pub fn fraction(numerator: i64, denominator: i64) -> Option<Number> {
        (denominator != 0).then(|| Number::reduced(numerator.into(), denominator.into()))
    }

    /// The fraction of two 128-bit integers, the denominator not zero.
    fn reduced(numerator: i128, denominator: i128) -> Number {
        // Nearly all numbers are short, and dividing long ones takes many times as long.
        if let (Ok(n), Ok(d)) = (i64::try_from(numerator), i64::try_from(denominator))
            && n != i64::MIN
            && d > 0
        {
            let divisor = n.unsigned_abs().gcd(d.unsigned_abs()) as i64;
            return Number(Repr::Small(n / divisor, d / divisor));
        }
        Number::from_big(RBig::from_parts_signed(numerator.into(), denominator.into()))
    }

    fn from_big(value: RBig) -> Number {
        match (i64::try_from(value.numerator()), i64::try_from(value.denominator())) {
            (Ok(n), Ok(d)) => Number(Repr::Small(n, d)),
            _ => Number(Repr::Big(Box::new(value))),
        }
    }

    /// A sum or a product. One that has become very long is the nearest `f64`, as generated code would have it: along chains of
    /// rotations given by decimals, numbers would otherwise grow with each.
    fn shortened(value: RBig) -> Number {
        if bits(&value) <= MOST_BITS {
            return Number::from_big(value);
        }
        let nearest = Some(value.to_f64().value()).filter(|x| x.is_normal());
        Number::from_big(nearest.and_then(|x| RBig::try_from(x).ok()).unwrap_or(value))
    }

    fn to_big(&self) -> Cow<'_, RBig> {
        match &self.0 {
            Repr::Small(n, 1) => Cow::Owned((*n).into()),
            Repr::Small(n, d) => Cow::Owned(RBig::from_parts_signed((*n).into(), (*d).into())),
            Repr::Big(value) => Cow::Borrowed(value),
        }
    }

    /// Reads a decimal literal such as `0.2`, `1_000` or `6.02e23` exactly.
    ///
    /// `None` if it is not one, or if its magnitude is outside the range of `f64`.
    pub fn parse_decimal(text: &str) -> Option<Number> {
        let text: String = text.chars().filter(|c| *c != '_').collect();
        let (mantissa, exponent) = match text.split_once(['e', 'E']) {
            Some((mantissa, exponent)) => (mantissa, exponent.parse::<i32>().ok()?),
            None => (text.as_str(), 0),
        };
        let (whole, decimals) = mantissa.split_once('.').unwrap_or((mantissa, ""));
        let digits = format!("{whole}{decimals}");
        if digits.is_empty() || !digits.bytes().all(|b| b.is_ascii_digit()) {
            return None;
        }
        let exponent = exponent.checked_sub(i32::try_from(decimals.len()).ok()?)?;
        if digits.len() > 400 || exponent.unsigned_abs() > 700 {
            return None;
        }
        let digits = UBig::from_str_radix(&digits, 10).ok()?;
        let power = UBig::from(10u8).pow(exponent.unsigned_abs() as usize);
        let value = match exponent >= 0 {
            true => RBig::from(digits * power),
            false => RBig::from_parts(digits.into(), power),
        };
        let number = Number::from_big(value);
        let in_range = number.to_f64().is_finite() && (number.to_f64() != 0.0 || number.is_zero());
        in_range.then_some(number)
    }

    /// The nearest `f64`.
    pub fn to_f64(&self) -> f64 {
        match &self.0 {
            Repr::Small(n, d) if n.unsigned_abs() <= 1 << 53 && *d <= 1 << 53 => *n as f64 / *d as f64,
            Repr::Small(n, d) => nearest_quotient(n.unsigned_abs(), d.unsigned_abs()).copysign(*n as f64),
            Repr::Big(value) => value.to_f64().value(),
        }
    }

    /// Whether this is a whole number, of any size.
    pub fn is_integer(&self) -> bool {
        match &self.0 {
            Repr::Small(_, d) => *d == 1,
            Repr::Big(value) => value.is_int(),
        }
    }

    /// The value as an integer, if it is one that fits.
    pub fn to_integer(&self) -> Option<i64> {
        match self.0 {
            Repr::Small(n, 1) => Some(n),
            _ => None,
        }
    }

    /// Numerator and denominator, if both fit in a word.
    pub fn to_fraction(&self) -> Option<(i64, i64)> {
        match self.0 {
            Repr::Small(n, d) => Some((n, d)),
            Repr::Big(_) => None,
        }
    }

    /// Whether this is 0.
    pub fn is_zero(&self) -> bool {
        *self == Number::ZERO
    }

    /// Whether this is 1.
    pub fn is_one(&self) -> bool {
        *self == Number::ONE
    }

    /// Whether this is below 0.
    pub fn is_negative(&self) -> bool {
        match &self.0 {
            Repr::Small(n, _) => *n < 0,
            Repr::Big(value) => value.is_negative(),
        }
    }

    /// The absolute value.
    pub fn abs(&self) -> Number {
        if self.is_negative() { -self } else { self.clone() }
    }

    /// `1 / self`; `None` for 0.
    pub fn recip(&self) -> Option<Number> {
        match &self.0 {
            Repr::Small(0, _) => None,
            Repr::Small(n, d) => Some(Number::reduced((*d).into(), (*n).into())),
            Repr::Big(value) => Some(Number::from_big(RBig::from_parts_signed(
                value.denominator().clone().into(),
                value.numerator().clone(),
            ))),
        }
    }

    /// `self` to an integer power.
    ///
    /// `None` for a negative power of 0, and for results of more than about 4,000 bits, which are better
    /// left unevaluated.
    pub fn pow(&self, exponent: i64) -> Option<Number> {
        if let (Repr::Small(n, d), Ok(exponent)) = (&self.0, u32::try_from(exponent))
            && let (Some(n), Some(d)) = (n.checked_pow(exponent), d.checked_pow(exponent))
        {
            return Some(Number(Repr::Small(n, d)));
        }
        let base = if exponent < 0 { self.recip()? } else { self.clone() };
        let base = base.to_big();
        let bits = bits(&base) as u64;
        let exponent = match exponent.unsigned_abs() {
            // Powers of 0, 1 and -1 depend on little of the exponent.
            large if bits <= 2 => large.min(2 + large % 2),
            exponent if bits.saturating_mul(exponent) > 4096 => return None,
            exponent => exponent,
        };
        Some(Number::from_big(base.pow(exponent as isize)))
    }

    /// The exact root of the given degree of a number that is not negative, if it is rational.
    pub fn exact_root(&self, degree: u32) -> Option<Number> {
        if self.is_negative() {
            return None;
        }
        let big = self.to_big();
        let (n, d) = (big.numerator().nth_root(degree as usize), big.denominator().nth_root(degree as usize));
        let root = RBig::from_parts_signed(n, d.into());
        (root.pow(degree as isize) == *big).then(|| Number::from_big(root))
    }

    /// The largest number `g > 0` such that both are integer multiples of it; the magnitude of the other if
    /// one is 0.
    pub fn gcd(&self, other: &Number) -> Number {
        if self.is_zero() || other.is_zero() {
            return if self.is_zero() { other.abs() } else { self.abs() };
        }
        if let (Repr::Small(a, b), Repr::Small(c, d)) = (&self.0, &other.0)
            && let Ok(divisor) = i64::try_from(a.unsigned_abs().gcd(c.unsigned_abs()))
            && let Some(multiple) = (b / b.unsigned_abs().gcd(d.unsigned_abs()) as i64).checked_mul(*d)
        {
            return Number(Repr::Small(divisor, multiple));
        }
        // In lowest terms: what both numerators have in common has nothing in common with either denominator.
        let (a, b) = (self.to_big(), other.to_big());
        let divisor = a.numerator().gcd(b.numerator());
        let multiple = a.denominator() / a.denominator().gcd(b.denominator()) * b.denominator();
        Number::from_big(RBig::from_parts(divisor.into(), multiple))
    }
}

impl From<i64> for Number {
    fn from(value: i64) -> Number {
        Number(Repr::Small(value, 1))
    }
}

impl Add for &Number {
    type Output = Number;
    fn add(self, other: &Number) -> Number {
        if let (Repr::Small(a, 1), Repr::Small(c, 1)) = (&self.0, &other.0)
            && let Some(sum) = a.checked_add(*c)
        {
            return Number(Repr::Small(sum, 1));
        }
        if let (Repr::Small(a, b), Repr::Small(c, d)) = (&self.0, &other.0) {
            let (a, b, c, d) = (i128::from(*a), i128::from(*b), i128::from(*c), i128::from(*d));
            // |a d|, |c b| < 2^126, so the sum cannot overflow.
            return Number::reduced(a * d + c * b, b * d);
        }
        Number::shortened(&*self.to_big() + &*other.to_big())
    }
}

impl Mul for &Number {
    type Output = Number;
    fn mul(self, other: &Number) -> Number {
        if let (Repr::Small(a, 1), Repr::Small(c, 1)) = (&self.0, &other.0)
            && let Some(product) = a.checked_mul(*c)
        {
            return Number(Repr::Small(product, 1));
        }
        if let (Repr::Small(a, b), Repr::Small(c, d)) = (&self.0, &other.0) {
            return Number::reduced(i128::from(*a) * i128::from(*c), i128::from(*b) * i128::from(*d));
        }
        Number::shortened(&*self.to_big() * &*other.to_big())
    }
}

impl Neg for &Number {
    type Output = Number;
    fn neg(self) -> Number {
        self * &Number::MINUS_ONE
    }
}

impl Sub for &Number {
    type Output = Number;
    fn sub(self, other: &Number) -> Number {
        self + &-other
    }
}

impl PartialOrd for Number {
    fn partial_cmp(&self, other: &Number) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Number {
    fn cmp(&self, other: &Number) -> Ordering {
        let difference = self - other;
        match (difference.is_zero(), difference.is_negative()) {
            (true, _) => Ordering::Equal,
            (_, true) => Ordering::Less,
            _ => Ordering::Greater,
        }
    }
}

impl fmt::Display for Number {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.to_big())
    }
}

impl fmt::Debug for Number {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn n(text: &str) -> Number {
        Number::parse_decimal(text).unwrap()
    }

    #[test]
    fn decimal_literals_are_exact() {
        assert_eq!(n("0.2"), Number::fraction(1, 5).unwrap());
        assert_eq!(n("1.5e-3"), Number::fraction(3, 2000).unwrap());
        assert_eq!(n("1_000"), Number::from(1000));
        assert_eq!(n("6.02e23").to_string(), "602000000000000000000000");
        assert_eq!(n("1e-300").to_f64(), 1e-300);
        for bad in ["", ".", "1e999", "1e-400", "1e99999999999", "x", "1.2.3"] {
            assert_eq!(Number::parse_decimal(bad), None, "{bad}");
        }
    }

    #[test]
    fn representation_is_unique_across_the_word_limit() {
        let large = Number::from(i64::MAX);
        let larger = &large + &Number::ONE;
        assert_eq!(&larger - &Number::ONE, large);
        assert_eq!(&(&large * &large) * &(&large * &large).recip().unwrap(), Number::ONE);
        assert_eq!((&Number::from(i64::MIN) * &Number::MINUS_ONE).to_string(), "9223372036854775808");
    }

    #[test]
    fn quotients_of_words_are_rounded_once() {
        let halfway = (1 << 53) + 1;
        let quotient = |n: i64, d: i64| Number::fraction(n, d).unwrap().to_f64();
        let [below, above] = [1u64 << 53, (1 << 53) + 2].map(|x| x as f64);
        assert_eq!(quotient(halfway, 1), below);
        assert_eq!(quotient(3 * halfway - 1, 3), below);
        assert_eq!(quotient(3 * halfway + 1, 3), above);
        assert_eq!(quotient(-3 * halfway - 1, 3), -above);
        assert_eq!(quotient(i64::MIN, 3), -2f64.powi(63) / 3.0);
        // (2^53 + 9) / 2^54 is halfway, and this is greater by a 2^54th of a part of its denominator.
        assert_eq!(quotient(5_504_399_544_563_945, 11_008_799_089_127_879), (below + 10.0) / 2f64.powi(54));
    }

    #[test]
    fn powers_and_roots() {
        assert_eq!(n("0.5").pow(-3), Some(Number::from(8)));
        assert_eq!(Number::ZERO.pow(-1), None);
        assert_eq!(n("10").pow(1_000_000), None);
        assert_eq!(Number::MINUS_ONE.pow(1_000_001), Some(Number::MINUS_ONE));
        assert_eq!(Number::MINUS_ONE.pow(i64::MIN), Some(Number::ONE));
        assert_eq!(Number::ZERO.pow(i64::MAX), Some(Number::ZERO));
        assert_eq!(n("2.25").exact_root(2), Some(n("1.5")));
        assert_eq!(n("2").exact_root(2), None);
        assert_eq!(n("1.5").gcd(&n("2.5")), n("0.5"));
    }
}
