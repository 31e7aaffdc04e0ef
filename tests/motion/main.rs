//! Motions against solutions that this code did not make.

#![allow(missing_docs, clippy::unwrap_used, clippy::panic)]

mod andrews;
mod assembly;
mod chains;
mod constraints;
mod events;
mod failure;
mod faulty;
mod linkages;
mod long;
mod order;
mod pendulum;
mod quick_return;
mod six_bar;
mod statics;
mod stiff;
mod units;
mod verification;
mod yokes;
