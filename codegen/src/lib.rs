//! Mechanism declarations to Rust kernels.
pub mod dsl;
pub mod nearest;
pub mod oracle;
pub mod symbolic;
