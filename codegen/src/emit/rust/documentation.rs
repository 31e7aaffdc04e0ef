//! The documentation of generated fields.

use crate::model::Unit;

/// Documentation of a quantity with its unit, a line each.
pub(super) fn documented(docs: &str, unit: &Unit) -> Vec<String> {
    let text = docs.trim_end_matches('.');
    let unit = unit.si_text();
    let text = if text.is_empty() { format!("In `{unit}`.") } else { format!("{text}, in `{unit}`.") };
    text.lines().map(|line| format!(" {line}")).collect()
}
