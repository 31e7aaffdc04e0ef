//! What an expression of the language stands for: a scalar or a vector of the plane, with its dimension.

use super::homogeneity::Measured;
use super::{Dimension, Point};
use crate::dsl::Expression;
use crate::symbolic::Expr;

/// A scalar or a vector.
#[derive(Clone, Copy)]
pub(super) enum Shape {
    Scalar(Expr),
    Vector(Point),
}

/// A value with its dimension, where that is known. A bare 0 may have any.
#[derive(Clone)]
pub(super) struct Value {
    pub(super) shape: Shape,
    pub(super) dimension: Option<Dimension>,
}

impl Value {
    pub(super) fn scalar(value: Expr, dimension: Option<Dimension>) -> Value {
        Value { shape: Shape::Scalar(value), dimension }
    }

    /// The expression that it is the value of, with its dimension.
    pub(super) fn measured<'a>(&'a self, expression: &'a Expression) -> Measured<'a> {
        Measured { expression, dimension: &self.dimension }
    }

    /// The same operation on every component.
    pub(super) fn map(self, mut f: impl FnMut(Expr) -> Expr) -> Value {
        let shape = match self.shape {
            Shape::Scalar(value) => Shape::Scalar(f(value)),
            Shape::Vector(components) => Shape::Vector(components.map(f)),
        };
        Value { shape, ..self }
    }

    pub(super) fn components(&self) -> Vec<Expr> {
        match self.shape {
            Shape::Scalar(value) => vec![value],
            Shape::Vector(components) => components.to_vec(),
        }
    }

    /// "a scalar" or "a vector".
    pub(super) fn kind(&self) -> &'static str {
        match self.shape {
            Shape::Scalar(_) => "a scalar",
            Shape::Vector(_) => "a vector",
        }
    }
}
