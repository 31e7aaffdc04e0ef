//! Motions against solutions that this code did not make.

#![allow(missing_docs, clippy::unwrap_used, clippy::panic)]

mod andrews;
mod assembly;
mod failure;
mod linkages;
mod pendulum;
mod quick_return;
mod units;
