//! The variables that an expression in a given place may depend on.

use super::interpreter::Interpreter;
use super::measured::Measured;
use super::{Dependence, Dimension, Point};
use crate::dsl::{Expression, Region};
use crate::symbolic::Expr;

pub(super) const MOVING: Dependence = Dependence::COORDINATE.or(Dependence::SPEED).or(Dependence::ACCELERATION);

pub(super) const BEYOND_POSITION: Dependence =
    Dependence::SPEED.or(Dependence::ACCELERATION).or(Dependence::MULTIPLIER);

pub(super) const BEYOND_SPEED: Dependence = Dependence::ACCELERATION.or(Dependence::MULTIPLIER);

pub(super) fn position_level(
    expression: &Expression,
    values: &[Expr],
    what: &str,
    interpreter: &mut Interpreter,
) -> Option<()> {
    no_input(expression.region, values, what, interpreter)?;
    let rule = format!("{what} is made of coordinates, parameters and time; `dot()` cannot stand in it");
    interpreter.restrict(expression.region, values, BEYOND_POSITION, &rule)
}

/// Refuses inputs where derivatives are needed.
pub(super) fn no_input(place: Region, values: &[Expr], what: &str, interpreter: &mut Interpreter) -> Option<()> {
    interpreter.restrict(
        place,
        values,
        Dependence::INPUT,
        &format!("{what} cannot depend on an input, which may jump; use inputs in loads and outputs"),
    )
}

/// An angle, with what it is for messages: "the angle of a body".
pub(super) fn angle(expression: &Expression, what: &str, interpreter: &mut Interpreter) -> Option<Expr> {
    position_scalar(expression, &Dimension::none(), what, interpreter)
}

/// A length.
pub(super) fn length(expression: &Expression, what: &str, interpreter: &mut Interpreter) -> Option<Expr> {
    position_scalar(expression, &Dimension::length(), what, interpreter)
}

/// A position in the plane.
pub(super) fn position(expression: &Expression, what: &str, interpreter: &mut Interpreter) -> Option<Point> {
    let (point, dimension) = interpreter.point_value(expression)?;
    position_level(expression, &point, what, interpreter)?;
    interpreter.expect_in_place(Measured { expression, dimension: &dimension }, &Dimension::length(), what);
    Some(point)
}

pub(super) fn position_scalar(
    expression: &Expression,
    needed: &Dimension,
    what: &str,
    interpreter: &mut Interpreter,
) -> Option<Expr> {
    let (value, dimension) = interpreter.scalar_value(expression)?;
    position_level(expression, &[value], what, interpreter)?;
    interpreter.expect_in_place(Measured { expression, dimension: &dimension }, needed, what);
    Some(value)
}

/// Refuses what a load cannot be made of.
pub(super) fn load_level(expression: &Expression, values: Point, interpreter: &mut Interpreter) -> Option<Point> {
    interpreter.restrict(
        expression.region,
        &values,
        BEYOND_SPEED,
        "a load is made of coordinates, speeds, parameters and time; `ddot()` cannot stand in it",
    )?;
    Some(values)
}
