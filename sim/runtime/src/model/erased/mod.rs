//! Mechanisms whose sizes are known at run time, run by the same loops as those that the compiler knows.
//!
//! A [`Model`] gives kernels on slices. [`Erased`] makes a [`Mechanism`](sim_kernel::Mechanism) of it, whose vectors
//! have a largest length in place of a length: they are copied like the arrays of a compiled mechanism, and the loops
//! need no second form. A loop is compiled for a few [`Storage`]s, since what is copied grows with the largest length.

mod arrays;
mod each;
mod entered;
mod mechanism;
mod model;
mod one_by_one;
mod place;
mod typed;

pub use arrays::{Bounded, InPlace, List, OnHeap, Shared, Small, Storage};
pub use each::{Results, States};
pub use mechanism::{Erased, ErasedPrepared};
pub use model::{Found, Kernel, Model, Prepared, Values};
pub(crate) use one_by_one::one_by_one;
pub use typed::erase;
