//! Mechanisms whose declarations are read at run time: their programs are executed as they are, without a compiler.
//!
//! The results are those of the generated Rust, to the last bit: the same operations in the same order, on the same
//! routines for sines and other functions.

mod block_sums;
mod blocks;
mod compact;
mod derivatives;
mod execute;
mod file;
mod kernels;
mod leaked;
mod model;
mod one_program;
mod programs;
mod registers;

pub use file::{DeclarationFile, LoadError, load};
pub use model::interpret;
