//! Arrays whose lengths are known at run time.

use sim_kernel::{Array, Element};
use std::fmt::Debug;
use std::ops::{Index, IndexMut};

/// How the arrays of a mechanism are stored whose sizes are known at run time.
pub trait Storage: Copy + Debug + Send + Sync + 'static {
    /// A vector or, of rows, a matrix.
    type Array<T: Element>: Array<T>;

    /// The largest length.
    const MOST: usize;
}

/// In place: for few coordinates, where an allocation would take longer than the computation.
#[derive(Clone, Copy, Debug)]
pub struct InPlace<const MOST: usize>;

/// On the heap, of any length: what is copied grows with the mechanism.
#[derive(Clone, Copy, Debug)]
pub struct OnHeap;

impl<const MOST: usize> Storage for InPlace<MOST> {
    type Array<T: Element> = Bounded<T, MOST>;

    const MOST: usize = MOST;
}

impl Storage for OnHeap {
    type Array<T: Element> = List<T>;

    const MOST: usize = usize::MAX;
}

/// At most `MOST` elements, in place.
#[derive(Clone, Copy, Debug)]
pub struct Bounded<T, const MOST: usize> {
    len: usize,
    elements: [T; MOST],
}

impl<T: Element, const MOST: usize> Element for Bounded<T, MOST> {
    const BLANK: Self = Bounded { len: 0, elements: [T::BLANK; MOST] };
}

impl<T: Element, const MOST: usize> Array<T> for Bounded<T, MOST> {
    #[inline]
    fn with_len(len: usize, mut f: impl FnMut(usize) -> T) -> Self {
        let mut array = Bounded { len, ..Self::BLANK };
        array.elements[..len].iter_mut().enumerate().for_each(|(i, element)| *element = f(i));
        array
    }
}

impl<T, const MOST: usize> AsRef<[T]> for Bounded<T, MOST> {
    #[inline]
    fn as_ref(&self) -> &[T] {
        &self.elements[..self.len]
    }
}

impl<T, const MOST: usize> AsMut<[T]> for Bounded<T, MOST> {
    #[inline]
    fn as_mut(&mut self) -> &mut [T] {
        &mut self.elements[..self.len]
    }
}

impl<T, const MOST: usize> Index<usize> for Bounded<T, MOST> {
    type Output = T;

    #[inline]
    fn index(&self, index: usize) -> &T {
        &self.as_ref()[index]
    }
}

impl<T, const MOST: usize> IndexMut<usize> for Bounded<T, MOST> {
    #[inline]
    fn index_mut(&mut self, index: usize) -> &mut T {
        &mut self.as_mut()[index]
    }
}

/// Any number of elements, on the heap.
#[derive(Clone, Debug)]
pub struct List<T>(Vec<T>);

impl<T: Element> Element for List<T> {
    const BLANK: Self = List(Vec::new());
}

impl<T: Element> Array<T> for List<T> {
    #[inline]
    fn with_len(len: usize, f: impl FnMut(usize) -> T) -> Self {
        List((0..len).map(f).collect())
    }
}

impl<T> AsRef<[T]> for List<T> {
    #[inline]
    fn as_ref(&self) -> &[T] {
        &self.0
    }
}

impl<T> AsMut<[T]> for List<T> {
    #[inline]
    fn as_mut(&mut self) -> &mut [T] {
        &mut self.0
    }
}

impl<T> Index<usize> for List<T> {
    type Output = T;

    #[inline]
    fn index(&self, index: usize) -> &T {
        &self.0[index]
    }
}

impl<T> IndexMut<usize> for List<T> {
    #[inline]
    fn index_mut(&mut self, index: usize) -> &mut T {
        &mut self.0[index]
    }
}
