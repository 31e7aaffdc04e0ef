//! Mechanism declarations to Rust kernels.
pub mod symbolic;
