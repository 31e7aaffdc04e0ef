//! Kernels and equations against each other, against other formulations, and against their promises.

#![allow(missing_docs, clippy::unwrap_used)]

mod all;
mod allocation;
mod by_hand;
mod derivatives;
mod determinism;
mod dual;
mod evaluation;
mod growth;
mod intervals;
mod lagrange;
mod lanes;
mod mechanisms;
mod oracle;
mod printed;
mod refusal;
mod sparse;
mod tabled;
