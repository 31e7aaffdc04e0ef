//! Arrays that are replaced as a whole, behind shared references.

use sim_kernel::Element;
use std::cell::Cell;
use std::fmt;

/// An array that is taken out, changed and put back; it costs nothing beside that, and cannot be borrowed twice.
pub(crate) struct Slot<T>(Cell<T>);

impl<T: Element> Slot<T> {
    pub(crate) fn new(array: T) -> Slot<T> {
        Slot(Cell::new(array))
    }

    /// The array; a blank one stays.
    #[inline(always)]
    pub(crate) fn take(&self) -> T {
        self.0.replace(T::BLANK)
    }

    #[inline(always)]
    pub(crate) fn set(&self, array: T) {
        self.0.set(array);
    }

    /// A copy.
    pub(crate) fn get(&self) -> T {
        let array = self.take();
        let copy = array.clone();
        self.set(array);
        copy
    }

    /// The array itself, where nothing else refers to it.
    pub(crate) fn get_mut(&mut self) -> &mut T {
        self.0.get_mut()
    }
}

impl<T: Element> Clone for Slot<T> {
    fn clone(&self) -> Slot<T> {
        Slot::new(self.get())
    }
}

impl<T: Element> fmt::Debug for Slot<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.get().fmt(f)
    }
}
