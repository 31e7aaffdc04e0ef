//! Other formats to declarations. Nothing after the declaration's text knows them.

pub mod urdf;
