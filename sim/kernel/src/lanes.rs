//! Several numbers side by side, one for each of several trajectories.
//!
//! Vector types of `core::arch` would need `unsafe` in every operation and a type for every width. What is not inlined
//! into a function compiled for wide vectors is compiled for the baseline: therefore `dynamics` is always inlined, and
//! batches loop instead of passing closures.

use crate::wave::{give_sin_cos, sin_cos_each};
use crate::{Mask, Scalar, Vectors, Work};
use core::ops::{Add, BitAnd, BitOr, Div, Mul, Neg, Sub};

/// `N` numbers side by side, on which every operation is that of `f64` lane by lane, with the same bits.
///
/// Plain arrays and loops of known length: the compiler turns them into vector instructions, as wide as the function
/// allows into which a kernel is inlined; results do not depend on it.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(align(64))]
pub struct Lanes<const N: usize>([f64; N]);

/// One truth value for each lane.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(align(64))]
pub struct LaneMask<const N: usize>([u64; N]);

impl<const N: usize> Lanes<N> {
    /// The lanes `f(0), f(1), ..`
    #[inline(always)]
    pub fn from_fn(f: impl FnMut(usize) -> f64) -> Self {
        Lanes(core::array::from_fn(f))
    }

    /// All lanes.
    #[inline(always)]
    pub fn to_array(self) -> [f64; N] {
        self.0
    }

    /// One lane.
    #[inline(always)]
    pub fn lane(&self, lane: usize) -> f64 {
        self.0[lane]
    }

    /// Sets one lane.
    #[inline(always)]
    pub fn set_lane(&mut self, lane: usize, value: f64) {
        self.0[lane] = value;
    }

    /// The lanes in memory.
    #[inline(always)]
    pub fn as_array(&self) -> &[f64; N] {
        &self.0
    }

    /// The lanes in memory, to be written.
    #[inline(always)]
    pub fn as_array_mut(&mut self) -> &mut [f64; N] {
        &mut self.0
    }

    #[inline(always)]
    fn each(self, f: impl Fn(f64) -> f64) -> Self {
        Lanes::from_fn(|lane| f(self.0[lane]))
    }

    #[inline(always)]
    fn both(self, other: Self, f: impl Fn(f64, f64) -> f64) -> Self {
        Lanes::from_fn(|lane| f(self.0[lane], other.0[lane]))
    }
}

impl<const N: usize> From<[f64; N]> for Lanes<N> {
    #[inline(always)]
    fn from(lanes: [f64; N]) -> Self {
        Lanes(lanes)
    }
}

impl<const N: usize> LaneMask<N> {
    /// Whether it is true in this lane.
    #[inline(always)]
    pub fn lane(&self, lane: usize) -> bool {
        self.0[lane] != 0
    }

    /// All bits of a lane are set for true, as with vector instructions.
    #[inline(always)]
    fn from_fn(f: impl Fn(usize) -> bool) -> Self {
        LaneMask(core::array::from_fn(|lane| if f(lane) { u64::MAX } else { 0 }))
    }
}

impl<const N: usize> Mask for LaneMask<N> {
    const NONE: Self = LaneMask([0; N]);

    #[inline(always)]
    fn any(self) -> bool {
        self.0 != [0; N]
    }
}

impl<const N: usize> BitAnd for LaneMask<N> {
    type Output = Self;

    #[inline(always)]
    fn bitand(self, other: Self) -> Self {
        LaneMask(core::array::from_fn(|lane| self.0[lane] & other.0[lane]))
    }
}

impl<const N: usize> BitOr for LaneMask<N> {
    type Output = Self;

    #[inline(always)]
    fn bitor(self, other: Self) -> Self {
        LaneMask(core::array::from_fn(|lane| self.0[lane] | other.0[lane]))
    }
}

macro_rules! operators {
    ($($trait:ident $function:ident $operator:tt),*) => {
        $(impl<const N: usize> $trait for Lanes<N> {
            type Output = Self;

            #[inline(always)]
            fn $function(self, other: Self) -> Self {
                self.both(other, |a, b| a $operator b)
            }
        })*
    };
}

operators!(Add add +, Sub sub -, Mul mul *, Div div /);

impl<const N: usize> Neg for Lanes<N> {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        self.each(|x| -x)
    }
}

/// As many at once as the widest vector holds, so that what is computed on the way stays in vector registers.
#[inline(always)]
fn sin_cos_in_place(angles_and_sines: &mut [f64], cosines: &mut [f64]) {
    let (sines, few_sines) = angles_and_sines.as_chunks_mut::<8>();
    let (cosines, few_cosines) = cosines.as_chunks_mut::<8>();
    for (sine, cosine) in sines.iter_mut().zip(cosines) {
        give_sin_cos(*sine, |sines, cosines| (*sine, *cosine) = (sines, cosines));
    }
    for (sine, cosine) in few_sines.iter_mut().zip(few_cosines) {
        ([*sine], [*cosine]) = sin_cos_each([*sine]);
    }
}

macro_rules! lane_by_lane {
    ($($function:ident),*) => {
        $(#[inline(always)]
        fn $function(self) -> Self {
            self.each(Scalar::$function)
        })*
    };
}

impl<const N: usize> Scalar for Lanes<N> {
    type Mask = LaneMask<N>;
    const HALF_DIGITS: f64 = <f64 as Scalar>::HALF_DIGITS;
    const ZERO: Lanes<N> = Lanes([0.0; N]);

    #[inline(always)]
    fn compute_part<W: Work>(work: W) -> W::Output {
        Vectors::widest().run(work)
    }

    #[inline(always)]
    fn from_f64(value: f64) -> Self {
        Lanes([value; N])
    }

    #[inline(always)]
    fn first_value(self) -> f64 {
        self.0[0]
    }

    #[inline(always)]
    fn greater(self, other: Self) -> LaneMask<N> {
        LaneMask::from_fn(|lane| self.0[lane] > other.0[lane])
    }

    #[inline(always)]
    fn at_most(self, other: Self) -> LaneMask<N> {
        LaneMask::from_fn(|lane| self.0[lane] <= other.0[lane])
    }

    #[inline(always)]
    fn not(mask: LaneMask<N>) -> LaneMask<N> {
        LaneMask::from_fn(|lane| !mask.lane(lane))
    }

    #[inline(always)]
    fn select(mask: LaneMask<N>, yes: Self, no: Self) -> Self {
        Lanes::from_fn(|lane| if mask.lane(lane) { yes.0[lane] } else { no.0[lane] })
    }

    #[inline(always)]
    fn gather<const K: usize>(self, of: impl Fn(f64) -> [f64; K]) -> [Self; K] {
        let found = self.0.map(of);
        core::array::from_fn(|i| Lanes::from_fn(|lane| found[lane][i]))
    }

    #[inline(always)]
    fn sin_cos_each<const K: usize>(angles: [Self; K]) -> ([Self; K], [Self; K]) {
        let (mut sines, mut cosines) = (angles, angles);
        for i in 0..K {
            sin_cos_in_place(&mut sines[i].0, &mut cosines[i].0);
        }
        (sines, cosines)
    }

    lane_by_lane!(tan, asin, acos, atan, sinh, cosh, tanh, exp, ln, sqrt, abs, sign);

    #[inline(always)]
    fn atan2(self, x: Self) -> Self {
        self.both(x, Scalar::atan2)
    }

    #[inline(always)]
    fn powf(self, exponent: Self) -> Self {
        self.both(exponent, Scalar::powf)
    }
}
