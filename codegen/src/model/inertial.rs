//! Masses and moments of inertia.

use super::Dependence;
use super::interpreter::Interpreter;
use super::level::MOVING;
use crate::dsl::Expression;
use crate::symbolic::Expr;

/// Refuses a mass or moment of inertia that is not made of parameters.
pub(super) fn inertial(expression: &Expression, value: Expr, interpreter: &mut Interpreter) -> Option<Expr> {
    interpreter.restrict(
        expression.region,
        &[value],
        MOVING.or(Dependence::TIME).or(Dependence::INPUT),
        "a mass or inertia is made of numbers and parameters; it cannot change with the motion",
    )?;
    if interpreter.graph.as_number(value).is_some_and(|number| number.is_negative()) {
        return interpreter.refuse(expression.region, "a mass or inertia cannot be negative");
    }
    Some(value)
}
