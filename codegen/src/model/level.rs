//! What an expression in a given place may depend on.

use super::homogeneity::Measured;
use super::interpret::Interpreter;
use super::{Dependence, Dimension, Point};
use crate::dsl::{Expression, Region};
use crate::symbolic::Expr;

pub(super) const MOVING: Dependence = Dependence::COORDINATE.or(Dependence::SPEED).or(Dependence::ACCELERATION);

pub(super) const BEYOND_POSITION: Dependence =
    Dependence::SPEED.or(Dependence::ACCELERATION).or(Dependence::MULTIPLIER);

pub(super) const BEYOND_SPEED: Dependence = Dependence::ACCELERATION.or(Dependence::MULTIPLIER);

pub(super) fn position_level(expression: &Expression, values: &[Expr], what: &str, i: &mut Interpreter) -> Option<()> {
    no_input(expression.region, values, what, i)?;
    let rule = format!("{what} is made of coordinates, parameters and time; `dot()` cannot stand in it");
    i.restrict(expression.region, values, BEYOND_POSITION, &rule)
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

/// An angle, with what it is for messages: "the angle of a body".
pub(super) fn angle(expression: &Expression, what: &str, i: &mut Interpreter) -> Option<Expr> {
    position_scalar(expression, &Dimension::none(), what, i)
}

/// A length.
pub(super) fn length(expression: &Expression, what: &str, i: &mut Interpreter) -> Option<Expr> {
    position_scalar(expression, &Dimension::length(), what, i)
}

/// A position in the plane.
pub(super) fn position(expression: &Expression, what: &str, i: &mut Interpreter) -> Option<Point> {
    let (point, dimension) = i.point_value(expression)?;
    position_level(expression, &point, what, i)?;
    i.expect_in_place(Measured { expression, dimension: &dimension }, &Dimension::length(), what);
    Some(point)
}

pub(super) fn position_scalar(
    expression: &Expression,
    needed: &Dimension,
    what: &str,
    i: &mut Interpreter,
) -> Option<Expr> {
    let (value, dimension) = i.scalar_value(expression)?;
    position_level(expression, &[value], what, i)?;
    i.expect_in_place(Measured { expression, dimension: &dimension }, needed, what);
    Some(value)
}

/// Refuses what a load cannot be made of.
pub(super) fn load_level(expression: &Expression, values: Point, i: &mut Interpreter) -> Option<Point> {
    i.restrict(
        expression.region,
        &values,
        BEYOND_SPEED,
        "a load is made of coordinates, speeds, parameters and time; `ddot()` cannot stand in it",
    )?;
    Some(values)
}
