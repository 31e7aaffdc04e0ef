//! The output of a run: text, tables, files and pictures.

pub(crate) mod formats;
pub(crate) mod happening;
pub(crate) mod outcome;
pub mod show;
pub(crate) mod whole;
pub(crate) mod write;
