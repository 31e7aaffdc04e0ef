//! Motions against solutions that this code did not make.

#![allow(missing_docs, clippy::unwrap_used, clippy::panic)]

mod andrews;
mod assembly;
mod auxiliary;
mod constraints;
mod elements;
mod events;
mod failure;
mod faulty;
mod impacts;
mod inputs;
mod linkages;
mod long;
mod nonholonomic;
mod order;
mod pendulum;
mod quick_return;
mod statics;
mod stiff;
mod units;
mod verification;
