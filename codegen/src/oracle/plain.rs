//! Plain numbers, which are in the declared unit.

use super::function::is_function;
use crate::dsl::{Expression, Kind};

/// Whether neither a unit nor a name, other than that of a constant, stands in the expression.
pub(super) fn is_plain(expression: &Expression) -> bool {
    match &expression.kind {
        // A table has its own units.
        Kind::Call(function, _) if !is_function(&function.to_string()) => false,
        Kind::Number { unit, .. } => unit.is_none(),
        Kind::Name(name) => name == "pi" || name == "e",
        _ => expression.parts().into_iter().all(is_plain),
    }
}
