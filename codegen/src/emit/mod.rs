//! Stage 6: programs in other languages. No numerical decision is made here: each language computes the same bits.

pub mod bytecode;
mod rust;

pub use rust::{emit, format, stub};
