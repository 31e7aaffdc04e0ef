//! Arrays whose length is a mechanism's business.

use core::fmt::Debug;
use core::ops::{Index, IndexMut};

/// A fixed-size array, named by an associated type because `[S; Self::N]` cannot be.
pub trait Array<T: Copy + Debug>:
    Copy + Debug + AsRef<[T]> + AsMut<[T]> + Index<usize, Output = T> + IndexMut<usize>
{
    /// How many elements it has.
    const LEN: usize;

    /// The array of `f(0), f(1), ..`
    fn from_fn(f: impl FnMut(usize) -> T) -> Self;

    /// The array of equal elements.
    #[inline(always)]
    fn filled(value: T) -> Self {
        Self::from_fn(|_| value)
    }

    /// Element by element.
    fn iter(&self) -> core::slice::Iter<'_, T> {
        self.as_ref().iter()
    }
}

impl<T: Copy + Debug, const N: usize> Array<T> for [T; N] {
    const LEN: usize = N;

    #[inline(always)]
    fn from_fn(f: impl FnMut(usize) -> T) -> Self {
        core::array::from_fn(f)
    }
}
