//! Arrays whose lengths depend on the mechanism.

use crate::{Input, Scalar};
use core::fmt::Debug;
use core::ops::{Index, IndexMut};

/// The elements of arrays.
pub trait Element: Copy + Debug {
    /// A value to begin with.
    const BLANK: Self;
}

impl<S: Scalar> Element for S {
    const BLANK: S = S::ZERO;
}

impl<S: Scalar> Element for Input<S> {
    const BLANK: Input<S> = Input::Declared;
}

impl<T: Element, const N: usize> Element for [T; N] {
    const BLANK: [T; N] = [T::BLANK; N];
}

/// A fixed-size array, named by an associated type because `[S; Self::N]` cannot be.
pub trait Array<T: Element>: Element + AsRef<[T]> + AsMut<[T]> + Index<usize, Output = T> + IndexMut<usize> {
    /// The number of elements.
    const LEN: usize;

    /// The array of `f(0), f(1), ..`
    fn from_fn(f: impl FnMut(usize) -> T) -> Self;

    /// The array of equal elements.
    fn filled(value: T) -> Self;

    /// Element by element.
    fn iter(&self) -> core::slice::Iter<'_, T> {
        self.as_ref().iter()
    }
}

impl<T: Element, const N: usize> Array<T> for [T; N] {
    const LEN: usize = N;

    /// Like `core::array::from_fn`, which takes several times as long to compile.
    #[inline(always)]
    fn from_fn(mut f: impl FnMut(usize) -> T) -> Self {
        let mut array = [T::BLANK; N];
        let mut i = 0;
        while i < N {
            array[i] = f(i);
            i += 1;
        }
        array
    }

    #[inline(always)]
    fn filled(value: T) -> Self {
        [value; N]
    }
}
