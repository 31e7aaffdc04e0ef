//! Pictures.

use crate::{Run, Table, WriteError};
use sim_kernel::Mechanism;
use std::path::Path;

/// Draws every figure of a run.
pub fn figures<M: Mechanism>(_run: &Run<M>, _table: &Table, _directory: &Path) -> Result<usize, WriteError> {
    Ok(0)
}
