//! Analyses of mechanisms against closed forms and other formulations.

#![allow(missing_docs, clippy::unwrap_used, clippy::panic)]

mod dyads;
mod inverse;
mod limits;
mod linear;
mod peaks;
mod sections;
mod straight;
mod sweeps;
