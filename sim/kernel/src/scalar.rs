//! The numbers that kernels run on.

use crate::root;
use crate::vectors::{Work, apart};
use crate::wave::sin_cos_each;
use core::fmt::Debug;
use core::ops::{Add, BitAnd, BitOr, Div, Mul, Neg, Sub};

/// The result of a comparison: one truth value, or one for each lane.
pub trait Mask: Copy + BitAnd<Output = Self> + BitOr<Output = Self> {
    /// False everywhere.
    const NONE: Self;
    /// Whether it is true anywhere.
    fn any(self) -> bool;
}

impl Mask for bool {
    const NONE: bool = false;
    fn any(self) -> bool {
        self
    }
}

/// A real number, or several side by side. Functions behave as those of `f64`: outside their domain they are
/// NaN.
#[allow(missing_docs)]
pub trait Scalar:
    'static
    + Copy
    + Send
    + Sync
    + Debug
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// The result of comparing two.
    type Mask: Mask;
    /// The square root of the unit roundoff: where half of the digits are gone.
    const HALF_DIGITS: f64;
    /// 0.
    const ZERO: Self;

    fn from_f64(value: f64) -> Self;
    /// The number, without derivatives; of several side by side, the first. For messages.
    fn first_value(self) -> f64;
    /// Whether `self > other`; false for NaN.
    fn greater(self, other: Self) -> Self::Mask;
    /// Whether `self <= other`; false for NaN.
    fn at_most(self, other: Self) -> Self::Mask;
    /// Truth values swapped.
    fn not(mask: Self::Mask) -> Self::Mask;
    /// `yes` where the mask is true and `no` elsewhere.
    fn select(mask: Self::Mask, yes: Self, no: Self) -> Self;

    /// `above` where `self > 0`, `otherwise` where it is not, and NaN where it is NaN. The value not chosen may be
    /// anything.
    #[inline(always)]
    fn choose(self, above: Self, otherwise: Self) -> Self {
        let is_number = self.abs().greater(Self::from_f64(-1.0));
        let no = Self::select(is_number, otherwise, self);
        Self::select(self.greater(Self::from_f64(0.0)), above, no)
    }

    /// Does the work of a long kernel. On single numbers with the vector instructions that the processor has, which are looked for;
    /// numbers that are vectors themselves are within a function for such instructions already.
    #[inline(always)]
    fn compute<W: Work>(work: W) -> W::Output {
        work.run::<1>()
    }

    /// Does a part of the work of a long kernel, in a function of its own: then numbers that are vectors look for instructions, too.
    #[inline(always)]
    fn compute_part<W: Work>(work: W) -> W::Output {
        Self::compute(work)
    }

    /// Numbers that are looked up by the value of `self`; they do not change with it.
    fn gather<const N: usize>(self, of: impl Fn(f64) -> [f64; N]) -> [Self; N];

    /// Sines and cosines of several angles side by side: the same bits as one by one.
    fn sin_cos_each<const N: usize>(angles: [Self; N]) -> ([Self; N], [Self; N]);
    #[inline(always)]
    fn sin(self) -> Self {
        Self::sin_cos_each([self]).0[0]
    }
    #[inline(always)]
    fn cos(self) -> Self {
        Self::sin_cos_each([self]).1[0]
    }
    fn tan(self) -> Self;
    fn asin(self) -> Self;
    fn acos(self) -> Self;
    fn atan(self) -> Self;
    /// The angle of the point (x, self).
    fn atan2(self, x: Self) -> Self;
    fn sinh(self) -> Self;
    fn cosh(self) -> Self;
    fn tanh(self) -> Self;
    fn exp(self) -> Self;
    fn ln(self) -> Self;
    fn sqrt(self) -> Self;
    fn powf(self, exponent: Self) -> Self;
    fn abs(self) -> Self;
    /// -1, 0 or 1.
    fn sign(self) -> Self;
}

macro_rules! real {
    ($type:ident, half_digits $half:expr, $sqrt:ident, $atan2:ident, $pow:ident, [$($name:ident $function:ident),*]) => {
        impl Scalar for $type {
            type Mask = bool;
            const HALF_DIGITS: f64 = $half;
            const ZERO: $type = 0.0;

            #[inline(always)]
            fn compute<W: Work>(work: W) -> W::Output {
                apart(work)
            }
            #[inline(always)]
            fn from_f64(value: f64) -> Self {
                value as $type
            }
            #[inline(always)]
            fn first_value(self) -> f64 {
                f64::from(self)
            }
            #[inline(always)]
            fn greater(self, other: Self) -> bool {
                self > other
            }
            #[inline(always)]
            fn at_most(self, other: Self) -> bool {
                self <= other
            }
            #[inline(always)]
            fn not(mask: bool) -> bool {
                !mask
            }
            #[inline(always)]
            fn select(mask: bool, yes: Self, no: Self) -> Self {
                if mask { yes } else { no }
            }
            #[inline(always)]
            fn sign(self) -> Self {
                match self {
                    _ if self > 0.0 => 1.0,
                    _ if self < 0.0 => -1.0,
                    // Zero, and NaN as it is.
                    _ => self * 0.0,
                }
            }
            #[inline(always)]
            fn gather<const N: usize>(self, of: impl Fn(f64) -> [f64; N]) -> [Self; N] {
                of(f64::from(self)).map(Self::from_f64)
            }
            #[inline(always)]
            fn sin_cos_each<const N: usize>(angles: [Self; N]) -> ([Self; N], [Self; N]) {
                let (sines, cosines) = sin_cos_each(angles.map(f64::from));
                (sines.map(|sine| sine as $type), cosines.map(|cosine| cosine as $type))
            }
            #[inline(always)]
            fn sqrt(self) -> Self {
                root::$sqrt(self)
            }
            #[inline]
            fn atan2(self, x: Self) -> Self {
                libm::$atan2(self, x)
            }
            #[inline]
            fn powf(self, exponent: Self) -> Self {
                libm::$pow(self, exponent)
            }
            $(#[inline]
            fn $name(self) -> Self {
                libm::$function(self)
            })*
        }
    };
}

#[rustfmt::skip]
real!(f64, half_digits 1.490_116_119_384_765_6e-8, sqrt, atan2, pow, [
    tan tan, asin asin, acos acos, atan atan, sinh sinh, cosh cosh, tanh tanh, exp exp, ln log, abs fabs
]);
#[rustfmt::skip]
real!(f32, half_digits 3.452_669_8e-4, sqrtf, atan2f, powf, [
    tan tanf, asin asinf, acos acosf, atan atanf, sinh sinhf, cosh coshf, tanh tanhf, exp expf, ln logf, abs fabsf
]);
