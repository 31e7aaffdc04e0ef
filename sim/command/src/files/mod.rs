//! The files that commands write and read, and the folders that they are in.

pub(super) mod asked;
pub(super) mod folder;
pub(super) mod identity;
pub(super) mod json;
pub(super) mod new;
pub(super) mod reproduction;
pub(super) mod run_file;
pub(super) mod stored;
pub(super) mod written;
