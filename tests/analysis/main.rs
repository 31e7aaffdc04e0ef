//! Analyses of mechanisms against closed forms and other formulations.

#![allow(missing_docs, clippy::unwrap_used, clippy::panic)]

mod inverse;
mod limits;
mod sweeps;
