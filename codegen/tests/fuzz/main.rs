//! Random declarations, in the plane and in space: sound ones are derived, compiled and compared with the oracle; mangled
//! ones give an error or kernels, and never a panic.
//!
//! Seeds are fixed. `LINKWRIGHT_FUZZ=20` makes twenty times as many cases, other ones each.

#![allow(missing_docs, clippy::unwrap_used, clippy::panic)]

mod build;
mod compare;
mod derivatives;
mod expression;
mod mangle;
mod parts;
mod plane;
mod random;
mod space;
mod table;

use std::env;

/// How many times as many cases as usual.
fn scale() -> usize {
    env::var("LINKWRIGHT_FUZZ").ok().and_then(|scale| scale.parse().ok()).unwrap_or(1)
}
