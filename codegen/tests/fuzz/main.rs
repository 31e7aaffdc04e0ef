//! Random declarations: sound ones are derived, compiled and compared with the oracle; mangled ones give an error or
//! kernels, and never a panic.
//!
//! Seeds are fixed. `LINKWRIGHT_FUZZ=20` makes twenty times as many cases, other ones each.

#![allow(missing_docs, clippy::unwrap_used, clippy::panic)]

mod build;
mod compare;
mod declaration;
mod mangle;
mod random;

use std::env;

/// How many times as many cases as usual.
fn scale() -> usize {
    env::var("LINKWRIGHT_FUZZ").ok().and_then(|scale| scale.parse().ok()).unwrap_or(1)
}
