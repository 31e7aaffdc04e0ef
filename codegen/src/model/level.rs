//! What an expression in a given place may depend on.

use super::Dependence;
use super::interpret::Interpreter;
use crate::dsl::Expression;
use crate::symbolic::Expr;

pub(super) const MOVING: Dependence = Dependence::COORDINATE.or(Dependence::SPEED).or(Dependence::ACCELERATION);

pub(super) const BEYOND_POSITION: Dependence =
    Dependence::SPEED.or(Dependence::ACCELERATION).or(Dependence::MULTIPLIER);

pub(super) const BEYOND_SPEED: Dependence = Dependence::ACCELERATION.or(Dependence::MULTIPLIER);

pub(super) fn position_level<const N: usize>(
    expression: &Expression,
    values: [Expr; N],
    what: &str,
    i: &mut Interpreter,
) -> Option<[Expr; N]> {
    i.restrict(
        expression.region,
        &values,
        BEYOND_POSITION,
        &format!("{what} is made of coordinates, parameters and time; `dot()` cannot stand in it"),
    )?;
    Some(values)
}

pub(super) fn position_scalar(expression: &Expression, what: &str, i: &mut Interpreter) -> Option<Expr> {
    let value = i.scalar(expression)?;
    position_level(expression, [value], what, i).map(|[value]| value)
}
