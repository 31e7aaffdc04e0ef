//! Arrays whose lengths are known at run time.

use sim_kernel::{Array, Element};
use std::fmt::Debug;
use std::ops::{Index, IndexMut};
use std::sync::Arc;

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

/// For most linkages.
pub type Small = InPlace<8>;

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

    #[inline(always)]
    fn apply(&self, f: impl Fn(&T) -> T) -> Self {
        let mut array = self.clone();
        array.update(self, |element, _| f(element));
        array
    }

    #[inline(always)]
    fn zip_with(&self, other: &Self, f: impl Fn(&T, &T) -> T) -> Self {
        let mut array = self.clone();
        array.update(other, f);
        array
    }

    // Loops of constant length are straight-line code, and take less time than one of two elements that has to count.
    #[inline(always)]
    fn update(&mut self, other: &Self, f: impl Fn(&T, &T) -> T) {
        let half = MOST / 2;
        for i in 0..half {
            self.elements[i] = f(&self.elements[i], &other.elements[i]);
        }
        if self.len > half {
            for i in half..MOST {
                self.elements[i] = f(&self.elements[i], &other.elements[i]);
            }
        }
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

/// Elements that are seldom changed, on the heap, if there are any: a copy refers to the same ones.
#[derive(Clone, Debug)]
pub struct Shared<T>(Option<Arc<[T]>>);

impl<T: Element> Element for Shared<T> {
    const BLANK: Self = Shared(None);
}

impl<T: Element> Array<T> for Shared<T> {
    #[inline]
    fn with_len(len: usize, f: impl FnMut(usize) -> T) -> Self {
        Shared((len > 0).then(|| (0..len).map(f).collect()))
    }
}

impl<T> AsRef<[T]> for Shared<T> {
    #[inline]
    fn as_ref(&self) -> &[T] {
        self.0.as_deref().unwrap_or(&[])
    }
}

impl<T: Clone> AsMut<[T]> for Shared<T> {
    #[inline]
    fn as_mut(&mut self) -> &mut [T] {
        self.0.as_mut().map_or(&mut [], |elements| Arc::make_mut(elements))
    }
}

impl<T> Index<usize> for Shared<T> {
    type Output = T;

    #[inline]
    fn index(&self, index: usize) -> &T {
        &self.as_ref()[index]
    }
}

impl<T: Clone> IndexMut<usize> for Shared<T> {
    #[inline]
    fn index_mut(&mut self, index: usize) -> &mut T {
        &mut self.as_mut()[index]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Whatever is computed of the elements beyond its length, an array has those of its length.
    fn check<A: Array<f64>>() {
        for len in 0..=4 {
            let (a, b) = (A::with_len(len, |i| i as f64 + 0.5), A::with_len(len, |i| 3.0 - i as f64));
            let quotients: Vec<f64> = (0..len).map(|i| (i as f64 + 0.5) / (3.0 - i as f64)).collect();
            assert_eq!(a.apply(|a| 1.0 / *a).as_ref(), (0..len).map(|i| 1.0 / (i as f64 + 0.5)).collect::<Vec<_>>());
            assert_eq!(a.zip_with(&b, |a, b| *a / *b).as_ref(), quotients);
            let mut updated = a.clone();
            updated.update(&b, |a, b| *a / *b);
            assert_eq!(updated.as_ref(), quotients);
            assert_eq!([updated.len(), updated.iter().count()], [len; 2]);
        }
    }

    #[test]
    fn all_storages_compute_the_same() {
        check::<Bounded<f64, 4>>();
        check::<List<f64>>();
        check::<Shared<f64>>();
    }

    /// A change of a copy leaves the original as it is.
    #[test]
    fn shared_elements_are_copied_when_they_change() {
        let original = Shared::with_len(2, |i| i as f64);
        let mut copy = original.clone();
        copy[1] = 7.0;
        assert_eq!([original.as_ref(), copy.as_ref()], [[0.0, 1.0], [0.0, 7.0]]);
    }
}
