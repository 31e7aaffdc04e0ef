//! Arrays as vectors.

use super::numbers::sum;
use sim_kernel::{Array, Scalar};

/// a' b.
#[inline(always)]
pub(crate) fn inner<S: Scalar, A: Array<S>>(a: &A, b: &A) -> S {
    sum(a.iter().zip(b.iter()).map(|(a, b)| *a * *b))
}

/// Subtracts a correction from an array.
#[inline(always)]
pub(crate) fn subtract<S: Scalar, A: Array<S>>(from: &mut A, correction: &A) {
    for (value, correction) in from.as_mut().iter_mut().zip(correction.iter()) {
        *value = *value - *correction;
    }
}

/// The array of this length that begins with these numbers; those that are left out are zero.
pub(crate) fn array<S: Scalar, A: Array<S>>(len: usize, values: &[S]) -> A {
    let mut array = A::repeat(len, S::ZERO);
    copy(values, array.as_mut());
    array
}

fn copy<S: Scalar>(from: &[S], to: &mut [S]) {
    to.iter_mut().zip(from).for_each(|(to, from)| *to = *from);
}
