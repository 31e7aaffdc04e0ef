//! States and trajectories, the settings of a run, and its failures.

pub(crate) mod digest;
pub(crate) mod failure;
pub(crate) mod interpolate;
pub(crate) mod saved;
pub(crate) mod settings;
pub(crate) mod trajectory;
pub(crate) mod what;
