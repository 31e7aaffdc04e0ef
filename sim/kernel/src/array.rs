//! Arrays whose lengths depend on the mechanism.

use crate::{Input, Scalar};
use core::fmt::Debug;
use core::ops::{Index, IndexMut};

/// The elements of arrays.
pub trait Element: Clone + Debug + 'static {
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

/// An array whose length is given by its mechanism: at compile time, by an associated type because `[S; Self::N]` cannot
/// be named, or at run time.
pub trait Array<T: Element>: Element + AsRef<[T]> + AsMut<[T]> + Index<usize, Output = T> + IndexMut<usize> {
    /// The array of `f(0), f(1), ..` with this length, which must be that of the type if the type has one.
    fn with_len(len: usize, f: impl FnMut(usize) -> T) -> Self;

    /// The array of equal elements, with this length.
    #[inline(always)]
    fn repeat(len: usize, value: T) -> Self {
        Self::with_len(len, |_| value.clone())
    }

    /// The array of `f(0), f(1), ..` with the length of this one.
    #[inline(always)]
    fn like(&self, f: impl FnMut(usize) -> T) -> Self {
        Self::with_len(self.len(), f)
    }

    /// The array of `f` of each element. `f` may also be called on blank elements, and must be cheap.
    #[inline(always)]
    fn apply(&self, f: impl Fn(&T) -> T) -> Self {
        self.like(|i| f(&self[i]))
    }

    /// The array of `f` of each element and that of another array of this length, as in [`apply`](Array::apply).
    #[inline(always)]
    fn zip_with(&self, other: &Self, f: impl Fn(&T, &T) -> T) -> Self {
        self.like(|i| f(&self[i], &other[i]))
    }

    /// Replaces each element as [`zip_with`](Array::zip_with).
    #[inline(always)]
    fn update(&mut self, other: &Self, f: impl Fn(&T, &T) -> T) {
        for i in 0..self.len() {
            self[i] = f(&self[i], &other[i]);
        }
    }

    /// The number of elements.
    #[inline(always)]
    fn len(&self) -> usize {
        self.as_ref().len()
    }

    /// Whether it has no elements.
    #[inline(always)]
    fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Element by element.
    #[inline(always)]
    fn iter(&self) -> core::slice::Iter<'_, T> {
        self.as_ref().iter()
    }
}

/// An array whose length is that of its type.
pub trait FixedArray<T: Element>: Array<T> + Copy {
    /// The number of elements.
    const LEN: usize;

    /// The array of `f(0), f(1), ..`
    #[inline(always)]
    fn from_fn(f: impl FnMut(usize) -> T) -> Self {
        Self::with_len(Self::LEN, f)
    }

    /// The array of equal elements.
    #[inline(always)]
    fn filled(value: T) -> Self {
        Self::repeat(Self::LEN, value)
    }
}

impl<T: Element + Copy, const N: usize> FixedArray<T> for [T; N] {
    const LEN: usize = N;
}

impl<T: Element, const N: usize> Array<T> for [T; N] {
    /// Like `core::array::from_fn`, which takes several times as long to compile.
    #[inline(always)]
    fn with_len(len: usize, mut f: impl FnMut(usize) -> T) -> Self {
        debug_assert_eq!(len, N, "an array of another length");
        let mut array = [T::BLANK; N];
        let mut i = 0;
        while i < N {
            array[i] = f(i);
            i += 1;
        }
        array
    }

    #[inline(always)]
    fn repeat(len: usize, value: T) -> Self {
        Self::with_len(len, |_| value.clone())
    }

    #[inline(always)]
    fn len(&self) -> usize {
        N
    }
}
