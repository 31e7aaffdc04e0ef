//! Analyses of a mechanism other than its motion in time, and their verification.

pub(crate) mod equilibrium;
mod jumps;
pub(crate) mod kinematics;
pub(crate) mod linearize;
pub(crate) mod poincare;
pub(crate) mod sensitivity;
#[cfg(feature = "analysis")]
pub mod verify;
