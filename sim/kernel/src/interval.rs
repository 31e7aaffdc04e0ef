//! Bounds that are carried through a kernel.

use crate::{Mask, Scalar};
use core::f64::consts::{FRAC_PI_2, PI, TAU};
use core::ops::{Add, BitAnd, BitOr, Div, Mul, Neg, Sub};

/// All numbers from one to another: a kernel on intervals gives intervals that hold all its values on the numbers of the
/// given ones, rounding included (Moore, Kearfott, Cloud: Introduction to Interval Analysis, 2009, chapters 2 to 5).
///
/// Functions count where they have a value: the root of [-1, 4] is [0, 2]. What has no value, and what may be infinite, has no
/// bounds. A [`Dual`](crate::Dual) of intervals bounds the derivative too, wherever the value does not [jump](Interval::jumps).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interval {
    from: f64,
    to: f64,
    jumps: bool,
}

/// More than a function of `libm` is wrong by, in units in the last place.
const ULPS: u32 = 2;

impl Interval {
    /// All numbers.
    pub const ALL: Interval = Interval { from: f64::NEG_INFINITY, to: f64::INFINITY, jumps: false };

    /// One number; of NaN, all.
    pub const fn exactly(value: f64) -> Interval {
        Interval::between(value, value)
    }

    /// The numbers between two; of NaN, all.
    pub const fn between(one: f64, other: f64) -> Interval {
        match (one <= other, other <= one) {
            (true, _) => Interval { from: one, to: other, jumps: false },
            (_, true) => Interval { from: other, to: one, jumps: false },
            _ => Interval::ALL,
        }
    }

    /// The least of the numbers.
    pub const fn least(self) -> f64 {
        self.from
    }

    /// The greatest of the numbers.
    pub const fn greatest(self) -> f64 {
        self.to
    }

    /// Whether the value may jump within, as `sign` does at 0: no derivative tells of that.
    pub const fn jumps(self) -> bool {
        self.jumps
    }

    const ENDS: [f64; 2] = [f64::NEG_INFINITY, f64::INFINITY];

    /// Whether a number is one of these.
    pub fn holds(self, value: f64) -> bool {
        self.from <= value && value <= self.to
    }

    fn is_one(self) -> bool {
        self.from == self.to
    }

    /// The same numbers, of a value that jumps where one of these do.
    fn after(self, others: &[Interval]) -> Interval {
        Interval { jumps: self.jumps || others.iter().any(|other| other.jumps), ..self }
    }

    /// The numbers of both, and those between.
    fn hull(self, other: Interval) -> Interval {
        Interval { from: self.from.min(other.from), to: self.to.max(other.to), jumps: self.jumps || other.jumps }
    }

    /// From the least to the greatest of the values, and as many places beyond as rounding may hide.
    fn around<const N: usize>(values: [f64; N], ulps: u32) -> Interval {
        let [mut from, mut to] = [f64::INFINITY, f64::NEG_INFINITY];
        for value in values {
            if value.is_nan() {
                return Interval::ALL;
            }
            (from, to) = (from.min(value), to.max(value));
        }
        for _ in 0..ulps {
            (from, to) = (from.next_down(), to.next_up());
        }
        Interval::between(from, to)
    }

    /// A function that nowhere falls, or nowhere rises, of the numbers that are in its domain.
    fn monotone(self, domain: [f64; 2], f: impl Fn(f64) -> f64) -> Interval {
        let (from, to) = (self.from.max(domain[0]), self.to.min(domain[1]));
        match from <= to {
            true => Interval::around([f(from), f(to)], ULPS).after(&[self]),
            false => Interval::ALL.after(&[self]),
        }
    }

    /// Within these bounds, which a function keeps whatever is rounded.
    fn within(self, least: f64, greatest: f64) -> Interval {
        Interval { from: self.from.clamp(least, greatest), to: self.to.clamp(least, greatest), ..self }
    }

    /// Whether one of `first + k step`, for whole k, may lie within.
    fn meets(self, first: f64, step: f64) -> bool {
        // The rounding of quotients of this size.
        let slack = 4.0 * f64::EPSILON * (1.0 + self.from.abs().max(self.to.abs()) / step);
        let [from, to] = [self.from, self.to].map(|end| (end - first) / step);
        !(libm::floor(to + slack) < libm::ceil(from - slack))
    }

    fn wave(self, f: impl Fn(f64) -> f64, greatest_at: f64) -> Interval {
        if !(self.to - self.from < TAU) {
            return Interval::between(-1.0, 1.0).after(&[self]);
        }
        let mut values = Interval::around([f(self.from), f(self.to)], ULPS).within(-1.0, 1.0);
        if self.meets(greatest_at, TAU) {
            values.to = 1.0;
        }
        if self.meets(greatest_at + PI, TAU) {
            values.from = -1.0;
        }
        values.after(&[self])
    }
}

/// The result of comparing intervals: whether it may be true of some of their numbers, and whether it may be false.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Possible {
    is_true: bool,
    is_false: bool,
}

impl BitAnd for Possible {
    type Output = Possible;
    fn bitand(self, other: Possible) -> Possible {
        Possible { is_true: self.is_true && other.is_true, is_false: self.is_false || other.is_false }
    }
}

impl BitOr for Possible {
    type Output = Possible;
    fn bitor(self, other: Possible) -> Possible {
        Possible { is_true: self.is_true || other.is_true, is_false: self.is_false && other.is_false }
    }
}

impl Mask for Possible {
    const NONE: Possible = Possible { is_true: false, is_false: true };
    fn any(self) -> bool {
        self.is_true
    }
}

/// A sum, and what rounding has taken from it (Knuth, The Art of Computer Programming 2, 4.2.2).
fn sum(a: f64, b: f64) -> [f64; 2] {
    let sum = a + b;
    let of_b = sum - a;
    [sum, (a - (sum - of_b)) + (b - of_b)]
}

impl Add for Interval {
    type Output = Interval;
    fn add(self, other: Interval) -> Interval {
        let ([from, above], [to, below]) = (sum(self.from, other.from), sum(self.to, other.to));
        // Sums of infinite bounds have no rest.
        let from = if above >= 0.0 { from } else { from.next_down() };
        let to = if below <= 0.0 { to } else { to.next_up() };
        Interval::between(from, to).after(&[self, other])
    }
}

impl Sub for Interval {
    type Output = Interval;
    fn sub(self, other: Interval) -> Interval {
        self + -other
    }
}

impl Neg for Interval {
    type Output = Interval;
    fn neg(self) -> Interval {
        Interval { from: -self.to, to: -self.from, ..self }
    }
}

impl Mul for Interval {
    type Output = Interval;
    fn mul(self, other: Interval) -> Interval {
        // Zero times what has no bound is zero: the numbers themselves are finite.
        let product = |a: f64, b: f64| if a == 0.0 || b == 0.0 { 0.0 } else { a * b };
        let [a, b] = [self, other];
        let corners = [product(a.from, b.from), product(a.from, b.to), product(a.to, b.from), product(a.to, b.to)];
        let exact = [a, b].iter().any(|one| one.is_one() && [-1.0, 0.0, 1.0].contains(&one.from));
        Interval::around(corners, u32::from(!exact)).after(&[self, other])
    }
}

impl Div for Interval {
    type Output = Interval;
    fn div(self, other: Interval) -> Interval {
        if other.holds(0.0) {
            return Interval::ALL.after(&[self, other]);
        }
        let [a, b] = [self, other];
        let corners = [a.from / b.from, a.from / b.to, a.to / b.from, a.to / b.to];
        Interval::around(corners, 1).after(&[self, other])
    }
}

impl Scalar for Interval {
    type Mask = Possible;
    const HALF_DIGITS: f64 = <f64 as Scalar>::HALF_DIGITS;
    const ZERO: Interval = Interval::exactly(0.0);

    fn from_f64(value: f64) -> Self {
        Interval::exactly(value)
    }
    fn first_value(self) -> f64 {
        self.from + (self.to - self.from) / 2.0
    }
    fn greater(self, other: Self) -> Possible {
        Possible { is_true: self.to > other.from, is_false: self.from <= other.to }
    }
    fn at_most(self, other: Self) -> Possible {
        Self::not(self.greater(other))
    }
    fn not(mask: Possible) -> Possible {
        Possible { is_true: mask.is_false, is_false: mask.is_true }
    }
    fn select(mask: Possible, yes: Self, no: Self) -> Self {
        match mask {
            Possible { is_false: false, .. } => yes,
            Possible { is_true: false, .. } => no,
            _ => Interval { jumps: true, ..yes.hull(no) },
        }
    }
    fn choose(self, above: Self, otherwise: Self) -> Self {
        Self::select(self.greater(Self::ZERO), above, otherwise)
    }
    fn gather<const N: usize>(self, of: impl Fn(f64) -> [f64; N]) -> [Self; N] {
        let is_bounded = self.from.is_finite() && self.to.is_finite();
        let [from, to] = if is_bounded { [of(self.from), of(self.to)] } else { [[f64::NAN; N]; 2] };
        let one =
            |i: usize| if from == to { Interval::exactly(from[i]) } else { Interval { jumps: true, ..Interval::ALL } };
        core::array::from_fn(one)
    }
    fn sin_cos_each<const N: usize>(angles: [Self; N]) -> ([Self; N], [Self; N]) {
        let sin = |angle: Interval| angle.wave(Scalar::sin, FRAC_PI_2);
        let cos = |angle: Interval| angle.wave(Scalar::cos, 0.0);
        (angles.map(sin), angles.map(cos))
    }
    fn tan(self) -> Self {
        match !(self.to - self.from < PI) || self.meets(FRAC_PI_2, PI) {
            true => Interval { jumps: true, ..Interval::ALL },
            false => self.monotone(Interval::ENDS, Scalar::tan),
        }
    }
    fn asin(self) -> Self {
        self.monotone([-1.0, 1.0], Scalar::asin)
    }
    fn acos(self) -> Self {
        self.monotone([-1.0, 1.0], Scalar::acos)
    }
    fn atan(self) -> Self {
        self.monotone(Interval::ENDS, Scalar::atan)
    }
    fn atan2(self, x: Self) -> Self {
        if self.holds(0.0) && x.from <= 0.0 {
            return Interval { jumps: true, ..Interval::between(-PI.next_up(), PI.next_up()) };
        }
        let corners = [(self.from, x.from), (self.from, x.to), (self.to, x.from), (self.to, x.to)];
        Interval::around(corners.map(|(y, x)| y.atan2(x)), ULPS).after(&[self, x])
    }
    fn sinh(self) -> Self {
        self.monotone(Interval::ENDS, Scalar::sinh)
    }
    fn cosh(self) -> Self {
        Scalar::abs(self).monotone(Interval::ENDS, Scalar::cosh)
    }
    fn tanh(self) -> Self {
        self.monotone(Interval::ENDS, Scalar::tanh).within(-1.0, 1.0)
    }
    fn exp(self) -> Self {
        self.monotone(Interval::ENDS, Scalar::exp).within(0.0, f64::INFINITY)
    }
    fn ln(self) -> Self {
        self.monotone([0.0, f64::INFINITY], Scalar::ln)
    }
    fn sqrt(self) -> Self {
        self.monotone([0.0, f64::INFINITY], Scalar::sqrt).within(0.0, f64::INFINITY)
    }
    fn powf(self, exponent: Self) -> Self {
        let power = |base: f64| Scalar::powf(base, exponent.from);
        let is_whole = exponent.is_one() && libm::rint(exponent.from) == exponent.from;
        let found = match (is_whole, exponent.is_one()) {
            (true, _) if exponent.from < 0.0 && self.holds(0.0) => Interval { jumps: true, ..Interval::ALL },
            (true, _) if exponent.from % 2.0 == 0.0 => Scalar::abs(self).monotone(Interval::ENDS, power),
            (true, _) => self.monotone(Interval::ENDS, power),
            (_, true) => self.monotone([0.0, f64::INFINITY], power),
            _ => (exponent * self.ln()).exp(),
        };
        found.after(&[self, exponent])
    }
    fn abs(self) -> Self {
        let (least, greatest) = (self.from.abs().min(self.to.abs()), self.from.abs().max(self.to.abs()));
        Interval::between(if self.holds(0.0) { 0.0 } else { least }, greatest).after(&[self])
    }
    fn sign(self) -> Self {
        let [from, to] = [self.from, self.to].map(Scalar::sign);
        Interval { jumps: self.jumps || from != to, ..Interval::between(from, to) }
    }
}
