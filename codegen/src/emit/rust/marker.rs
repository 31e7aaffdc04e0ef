//! Types that have no field of their scalar.

use crate::model::Model;

/// Whether the mechanism needs a field for its scalar alone.
pub(super) fn has_no_fields(model: &Model) -> bool {
    model.parameters.is_empty() && model.inputs.is_empty() && model.conditionals.is_empty()
}
