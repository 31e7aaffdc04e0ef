//! Analyses of mechanisms against closed forms and other formulations.

#![allow(missing_docs, clippy::unwrap_used, clippy::panic)]

mod dyads;
mod eigenvalues;
mod equilibria;
mod erased;
mod inverse;
mod limits;
mod linear;
mod neutral;
mod peaks;
mod poles;
mod pulses;
mod ratios;
mod sections;
mod steady;
mod stiff;
mod straight;
mod sweeps;
