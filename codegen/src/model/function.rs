//! Functions given by rows, by their names.

use super::{Dimension, Unit};
use crate::symbolic::TableId;

/// The meaning of a table's name.
#[derive(Clone)]
pub(super) struct Function {
    pub(super) table: TableId,
    pub(super) argument: Unit,
    pub(super) value: Dimension,
}
