//! What is found of a mechanism beside its motion in time, and whether all of it is right.

pub(crate) mod equilibrium;
pub(crate) mod kinematics;
pub(crate) mod linearize;
pub(crate) mod poincare;
#[cfg(feature = "analysis")]
pub mod verify;
