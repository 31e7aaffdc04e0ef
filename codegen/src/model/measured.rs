//! Expressions with their dimensions.

use super::Dimension;
use crate::dsl::Expression;

/// An expression with its dimension.
#[derive(Clone, Copy)]
pub(super) struct Measured<'a> {
    pub(super) expression: &'a Expression,
    pub(super) dimension: &'a Option<Dimension>,
}
