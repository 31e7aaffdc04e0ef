//! Kernels and equations against each other, against other formulations, and against their promises.

#![allow(missing_docs, clippy::unwrap_used)]

mod allocation;
mod determinism;
mod evaluation;
mod lagrange;
mod mechanisms;
mod oracle;
