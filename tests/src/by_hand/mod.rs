//! Equations of motion as an expert writes them for one mechanism: what generated kernels are measured against.
//!
//! Parameters at run time, the standard library's sines, no general matrices. Written before anything was tuned
//! against them, and checked against the declarations of the same mechanisms.

mod chain;
mod four_bars;

pub use chain::{Chain, chain_absolute, chain_relative};
pub use four_bars::{FourBars, FourBarsSolution, four_bars};
