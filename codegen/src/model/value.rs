//! The value of an expression of the language: a scalar, a vector of the plane or of space, or a rotation, with its
//! dimension.

use super::Dimension;
use super::measured::Measured;
use super::space::{Bases, Spatial, Turn};
use crate::dsl::Expression;
use crate::symbolic::Expr;

/// A scalar, a vector or a rotation.
#[derive(Clone)]
pub(super) enum Shape {
    Scalar(Expr),
    Vector([Expr; 2]),
    Spatial(Spatial),
    Rotation(Turn),
}

/// A value with its dimension, where that is known. A bare 0 may have any.
#[derive(Clone)]
pub(super) struct Value {
    pub(super) shape: Shape,
    pub(super) dimension: Option<Dimension>,
    /// The frames of a vector or a rotation of space.
    pub(super) bases: Bases,
}

impl Value {
    /// Without a known frame.
    pub(super) fn new(shape: Shape, dimension: Option<Dimension>) -> Value {
        Value { shape, dimension, bases: Bases::default() }
    }

    pub(super) fn scalar(value: Expr, dimension: Option<Dimension>) -> Value {
        Value::new(Shape::Scalar(value), dimension)
    }

    /// The expression that it is the value of, with its dimension.
    pub(super) fn measured<'a>(&'a self, expression: &'a Expression) -> Measured<'a> {
        Measured { expression, dimension: &self.dimension }
    }

    /// The same linear operation on every component; rotations stay.
    pub(super) fn map(self, mut f: impl FnMut(Expr) -> Expr) -> Value {
        let shape = match self.shape {
            Shape::Scalar(value) => Shape::Scalar(f(value)),
            Shape::Vector(components) => Shape::Vector(components.map(f)),
            Shape::Spatial(vector) => Shape::Spatial(vector.map(f)),
            rotation => rotation,
        };
        Value { shape, ..self }
    }

    /// Its kind, in words.
    pub(super) fn kind(&self) -> &'static str {
        match self.shape {
            Shape::Scalar(_) => "a scalar",
            Shape::Vector(_) => "a vector",
            Shape::Spatial(_) => "a vector of space",
            Shape::Rotation(_) => "a rotation",
        }
    }
}
