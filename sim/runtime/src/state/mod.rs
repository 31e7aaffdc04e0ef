//! States and trajectories, the settings of a run, why it fails, and where files come from.

mod codes;
pub(crate) mod digest;
pub(crate) mod failure;
pub(crate) mod interpolate;
pub(crate) mod provenance;
pub(crate) mod readable;
pub(crate) mod saved;
pub(crate) mod settings;
pub(crate) mod slot;
pub(crate) mod trajectory;
pub(crate) mod what;
