//! The `drawing` block.

use super::interpret::Interpreter;
use super::level;
use super::{Point, Shape};
use crate::dsl::{self, Declaration, Expression};

pub(super) fn resolve_drawing(declaration: &Declaration, i: &mut Interpreter) -> Vec<Shape> {
    declaration.drawing.iter().filter_map(|shape| resolve_shape(shape, i)).collect()
}

fn resolve_shape(shape: &dsl::Shape, i: &mut Interpreter) -> Option<Shape> {
    match shape {
        dsl::Shape::Points { mark, points } => Some(Shape::Points(*mark, drawn_points(points, i)?)),
        dsl::Shape::Slider { at, along } => {
            let point = drawn_point(at, i);
            let along = match i.is_spatial() {
                true => direction(along, i),
                false => level::angle(along, "the angle of a slider", i).map(|angle| vec![angle]),
            };
            Some(Shape::Slider(point?, along?))
        }
        dsl::Shape::Circle { at, radius, normal } => {
            let (point, radius) = (drawn_point(at, i), level::length(radius, "a radius", i));
            let normal = match (normal, i.is_spatial()) {
                (Some(normal), true) => direction(normal, i),
                (None, false) => Some(vec![]),
                (None, true) => i.refuse(at.region, "a circle in space has a normal: `circle P radius r normal n;`"),
                (Some(normal), false) => i.refuse(normal.region, "a circle in the plane has no normal; leave it out"),
            };
            Some(Shape::Circle(point?, radius?, normal?))
        }
    }
}

/// A direction in space, of whatever length and dimension.
fn direction(expression: &Expression, i: &mut Interpreter) -> Option<Point> {
    let (direction, _) = i.point_value(expression)?;
    level::position_level(expression, &direction, "a direction", i)?;
    Some(direction)
}

fn drawn_points(points: &[Expression], i: &mut Interpreter) -> Option<Vec<Point>> {
    let points: Vec<_> = points.iter().map(|point| drawn_point(point, i)).collect();
    points.into_iter().collect()
}

fn drawn_point(expression: &Expression, i: &mut Interpreter) -> Option<Point> {
    level::position(expression, "a drawn point", i)
}
