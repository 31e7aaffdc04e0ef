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
            let (point, angle) = (drawn_point(at, i), level::angle(along, "the angle of a slider", i));
            Some(Shape::Slider(point?, angle?))
        }
        dsl::Shape::Circle { at, radius } => {
            let (point, radius) = (drawn_point(at, i), level::length(radius, "a radius", i));
            Some(Shape::Circle(point?, radius?))
        }
    }
}

fn drawn_points(points: &[Expression], i: &mut Interpreter) -> Option<Vec<Point>> {
    let points: Vec<_> = points.iter().map(|point| drawn_point(point, i)).collect();
    points.into_iter().collect()
}

fn drawn_point(expression: &Expression, i: &mut Interpreter) -> Option<Point> {
    level::position(expression, "a drawn point", i)
}
