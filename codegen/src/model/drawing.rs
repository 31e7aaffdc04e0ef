//! The `drawing` block.

use super::interpreter::Interpreter;
use super::level;
use super::{Point, Shape};
use crate::dsl::{self, Declaration, Expression};

pub(super) fn resolve_drawing(declaration: &Declaration, interpreter: &mut Interpreter) -> Vec<Shape> {
    declaration.drawing.iter().filter_map(|shape| resolve_shape(shape, interpreter)).collect()
}

fn resolve_shape(shape: &dsl::Shape, interpreter: &mut Interpreter) -> Option<Shape> {
    match shape {
        dsl::Shape::Points { mark, points } => Some(Shape::Points(*mark, drawn_points(points, interpreter)?)),
        dsl::Shape::Slider { at, along } => {
            let point = drawn_point(at, interpreter);
            let along = match interpreter.is_spatial() {
                true => direction(along, interpreter),
                false => level::angle(along, "the angle of a slider", interpreter).map(|angle| vec![angle]),
            };
            Some(Shape::Slider(point?, along?))
        }
        dsl::Shape::Circle { at, radius, normal } => {
            let (point, radius) = (drawn_point(at, interpreter), level::length(radius, "a radius", interpreter));
            let normal = match (normal, interpreter.is_spatial()) {
                (Some(normal), true) => direction(normal, interpreter),
                (None, false) => Some(vec![]),
                (None, true) => {
                    interpreter.refuse(at.region, "a circle in space has a normal: `circle P radius r normal n;`")
                }
                (Some(normal), false) => {
                    interpreter.refuse(normal.region, "a circle in the plane has no normal; leave it out")
                }
            };
            Some(Shape::Circle(point?, radius?, normal?))
        }
    }
}

/// A direction in space, of whatever length and dimension.
fn direction(expression: &Expression, interpreter: &mut Interpreter) -> Option<Point> {
    let (direction, _) = interpreter.point_value(expression)?;
    level::position_level(expression, &direction, "a direction", interpreter)?;
    Some(direction)
}

fn drawn_points(points: &[Expression], interpreter: &mut Interpreter) -> Option<Vec<Point>> {
    let points: Vec<_> = points.iter().map(|point| drawn_point(point, interpreter)).collect();
    points.into_iter().collect()
}

fn drawn_point(expression: &Expression, interpreter: &mut Interpreter) -> Option<Point> {
    level::position(expression, "a drawn point", interpreter)
}
