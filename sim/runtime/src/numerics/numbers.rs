//! Numbers of any kind: several side by side, or with derivatives. Comparisons give masks.

use sim_kernel::{Mask, Scalar};

/// The sum in this order. It begins with -0, which keeps the bits of what is added to it.
#[inline(always)]
pub(crate) fn sum<S: Scalar>(values: impl Iterator<Item = S>) -> S {
    let mut sum = S::from_f64(-0.0);
    // A loop is compiled in place, where `fold` may become a call.
    for value in values {
        sum = sum + value;
    }
    sum
}

/// The larger of both; `a` if `b` is NaN.
#[inline(always)]
pub(crate) fn larger<S: Scalar>(a: S, b: S) -> S {
    S::select(b.greater(a), b, a)
}

/// The smaller of both; `b` if `a` is NaN.
#[inline(always)]
pub(crate) fn smaller<S: Scalar>(a: S, b: S) -> S {
    S::select(b.greater(a), a, b)
}

/// Where a number is finite.
#[inline(always)]
pub(crate) fn finite<S: Scalar>(value: S) -> S::Mask {
    S::from_f64(f64::INFINITY).greater(value.abs())
}

/// Where all of these are true.
#[inline(always)]
pub(crate) fn all<S: Scalar>(count: usize, is_true: impl Fn(usize) -> S::Mask) -> S::Mask {
    let mut mask = S::not(S::Mask::NONE);
    for i in 0..count {
        mask = mask & is_true(i);
    }
    mask
}

/// Whether all of these are, in all lanes.
#[inline(always)]
pub(crate) fn are_finite<S: Scalar>(values: &[S]) -> bool {
    values.iter().all(|value| !S::not(finite(*value)).any())
}
