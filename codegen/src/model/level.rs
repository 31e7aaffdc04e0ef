//! What an expression in a given place may depend on.

use super::Dependence;
use super::interpret::Interpreter;
use crate::dsl::{Expression, Region};
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
    no_input(expression.region, &values, what, i)?;
    i.restrict(
        expression.region,
        &values,
        BEYOND_POSITION,
        &format!("{what} is made of coordinates, parameters and time; `dot()` cannot stand in it"),
    )?;
    Some(values)
}

/// Refuses inputs where derivatives are needed.
pub(super) fn no_input(place: Region, values: &[Expr], what: &str, i: &mut Interpreter) -> Option<()> {
    i.restrict(
        place,
        values,
        Dependence::INPUT,
        &format!("{what} cannot depend on an input, which may jump; an input acts by loads, and shows in outputs"),
    )
}

pub(super) fn position_scalar(expression: &Expression, what: &str, i: &mut Interpreter) -> Option<Expr> {
    let value = i.scalar(expression)?;
    position_level(expression, [value], what, i).map(|[value]| value)
}
