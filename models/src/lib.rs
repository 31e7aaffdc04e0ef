//! Mechanisms declared in the language, one file each. The library is `no_std`, as kernels are.

#![no_std]

mod quick_return;
mod quick_return_ratio;

pub use quick_return::*;
pub use quick_return_ratio::*;
