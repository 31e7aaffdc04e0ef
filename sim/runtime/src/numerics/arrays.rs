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
    from.update(correction, |value, correction| *value - *correction);
}

/// The array of this length that begins with these numbers; those that are left out are zero.
#[inline(always)]
pub(crate) fn array<S: Scalar, A: Array<S>>(len: usize, values: &[S]) -> A {
    let mut array = A::repeat(len, S::ZERO);
    let elements = array.as_mut();
    match values.len() == elements.len() {
        // Of constant length, where the compiler knows that of the array.
        true => elements.copy_from_slice(values),
        false => elements.iter_mut().zip(values).for_each(|(element, value)| *element = *value),
    }
    array
}
