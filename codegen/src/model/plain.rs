//! Plain numbers, which are in the declared unit.

use super::interpreter::Interpreter;
use super::measured::Measured;
use super::scope::functions;
use super::{Dependence, Unit};
use crate::dsl::{Expression, Kind};
use crate::symbolic::Expr;

/// A scalar for a quantity with a unit, with forbidden dependences and the reason. If it consists of plain numbers,
/// they are in that unit.
pub(super) fn in_unit(
    expression: &Expression,
    what: &str,
    unit: &Unit,
    (forbidden, rule): (Dependence, &str),
    interpreter: &mut Interpreter,
) -> Option<Expr> {
    let (value, dimension) = interpreter.scalar_value(expression)?;
    interpreter.restrict(expression.region, &[value], forbidden, rule)?;
    if !is_plain(expression) {
        let found = Measured { expression, dimension: &dimension };
        let (name, is) = match what.strip_prefix("dot(").and_then(|rest| rest.strip_suffix(')')) {
            Some(name) => (name, "is"),
            None => (what, "is declared"),
        };
        // Any value fits if the unit of the name is invalid.
        let is_mistaken = interpreter.values.get(name).is_some_and(|value| value.dimension.is_none());
        if !is_mistaken {
            interpreter.expect_unit(found, &format!("`{what}` {is}"), name, unit);
        }
        return Some(value);
    }
    let factor = unit.factor_expression(&mut interpreter.graph);
    let value = interpreter.graph.mul(value, factor);
    interpreter.check_constants(expression.region, &[value])?;
    Some(value)
}

/// Whether no name but pi and e occurs.
pub(super) fn is_of_numbers(expression: &Expression) -> bool {
    match &expression.kind {
        Kind::Number { .. } => true,
        Kind::Name(name) => name == "pi" || name == "e",
        // A table has its own units.
        Kind::Call(function, _) if !functions().any(|known| function == known) => false,
        _ => expression.parts().into_iter().all(is_of_numbers),
    }
}

/// Whether no unit occurs either.
pub(super) fn is_plain(expression: &Expression) -> bool {
    is_of_numbers(expression) && !has_unit(expression)
}

fn has_unit(expression: &Expression) -> bool {
    match &expression.kind {
        Kind::Number { unit, .. } => unit.is_some(),
        Kind::Name(_) => false,
        _ => expression.parts().into_iter().any(has_unit),
    }
}
