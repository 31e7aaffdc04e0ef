//! The current state of an input: its declared course, or a held value.
//!
//! An input is a field of the mechanism, and the kernels evaluate its course. So every kernel sees a change of input,
//! and no preparation is repeated.

/// An input: it follows its declared course until it is set.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Input<S = f64> {
    /// The declared course, a function of time and parameters.
    #[default]
    Declared,
    /// This value, in SI units, for as long as it is not set again: a zero-order hold.
    Held(S),
}

impl<S: Copy> Input<S> {
    /// Its value, where the declared course is at `course`.
    #[inline(always)]
    pub fn or(self, course: S) -> S {
        match self {
            Input::Declared => course,
            Input::Held(value) => value,
        }
    }

    /// The value it is set to, if any.
    pub fn held(self) -> Option<S> {
        match self {
            Input::Declared => None,
            Input::Held(value) => Some(value),
        }
    }

    /// The same on other numbers.
    pub fn map<T>(self, convert: impl Fn(S) -> T) -> Input<T> {
        match self {
            Input::Declared => Input::Declared,
            Input::Held(value) => Input::Held(convert(value)),
        }
    }
}

impl<S> From<S> for Input<S> {
    fn from(value: S) -> Self {
        Input::Held(value)
    }
}
