//! Sums, products, quotients and powers of values.

use super::interpreter::Interpreter;
use super::space::triple;
use super::value::{Shape, Value};
use crate::dsl::{Expression, Operator};
use crate::symbolic::{Expr, Graph, Node};
use rustc_hash::FxHashMap;

impl Interpreter {
    /// Of two operands.
    pub(super) fn binary(&mut self, operator: Operator, left: &Expression, right: &Expression) -> Option<Value> {
        let (a, b) = (self.value(left), self.value(right));
        let (a, b) = (a?, b?);
        match operator {
            Operator::Add | Operator::Subtract => self.sum(operator, left, right, a, b),
            Operator::Multiply => match a.shape {
                Shape::Rotation(turn) => self.turned(right.region, (turn, a.bases), b),
                _ => self.multiply(left, right, a, b),
            },
            Operator::Divide => self.divide(right, a, b),
            Operator::Power => self.power(left, right, a, b),
        }
    }

    fn sum(&mut self, operator: Operator, left: &Expression, right: &Expression, a: Value, b: Value) -> Option<Value> {
        let (operation, rule): (fn(&mut Graph, Expr, Expr) -> Expr, _) = match operator {
            Operator::Subtract => (Graph::sub, "only quantities of one dimension can be subtracted"),
            _ => (Graph::add, "only quantities of one dimension can be added"),
        };
        let shape = match (&a.shape, &b.shape) {
            (Shape::Scalar(a), Shape::Scalar(b)) => Shape::Scalar(operation(&mut self.graph, *a, *b)),
            (Shape::Vector([ax, ay]), Shape::Vector([bx, by])) => {
                Shape::Vector([operation(&mut self.graph, *ax, *bx), operation(&mut self.graph, *ay, *by)])
            }
            (Shape::Spatial(a), Shape::Spatial(b)) => Shape::Spatial(a.combine(b, &mut self.graph, operation)),
            _ => {
                let (a, b) = (a.kind(), b.kind());
                let message = format!(
                    "{a} and {b} cannot be added or subtracted; take a component (`.x`, `.y`) or build a vector `[x, y]`"
                );
                return self.refuse(left.region.to(right.region), message);
            }
        };
        let bases = self.common_basis([(left.region, &a), (right.region, &b)])?;
        let (left, right) = (a.measured(left), b.measured(right));
        Some(Value { shape, dimension: self.common_dimension(left, right, rule)?, bases })
    }

    fn multiply(&mut self, left: &Expression, right: &Expression, a: Value, b: Value) -> Option<Value> {
        let dimension = a.dimension.as_ref().zip(b.dimension.as_ref()).map(|(a, b)| a.times(b));
        if let Shape::Rotation(_) = b.shape {
            let message = "a rotation is written to the left of what it turns: `R*v`, and `transpose(R)*v` for the other way round";
            return self.refuse(left.region.to(right.region), message);
        }
        let (scalar, other) = match (&a.shape, &b.shape) {
            (Shape::Scalar(scalar), _) => (*scalar, b),
            (_, Shape::Scalar(scalar)) => (*scalar, a),
            (Shape::Spatial(_), Shape::Spatial(_)) => {
                return self.refuse(
                    left.region.to(right.region),
                    "two vectors cannot be multiplied with `*`; the scalar product is `inner(a, b)`, the vector product \
                     `cross(a, b)`",
                );
            }
            _ => {
                return self.refuse(
                    left.region.to(right.region),
                    "two vectors cannot be multiplied with `*`; the scalar product is `inner(a, b)`",
                );
            }
        };
        let product = other.map(|x| {
            let product = self.graph.mul(scalar, x);
            vanishing(&mut self.graph, &self.lengths, product)
        });
        Some(Value { dimension, ..product })
    }

    /// The length of a vector.
    pub(super) fn norm(&mut self, a: &Value) -> Expr {
        let square = self.inner(a, a);
        let length = self.graph.sqrt(square);
        let components = match &a.shape {
            Shape::Spatial(vector) => self.in_common(vector, vector).1.to_vec(),
            _ => self.components(a),
        };
        self.lengths.insert(length, components);
        length
    }

    fn divide(&mut self, right: &Expression, a: Value, b: Value) -> Option<Value> {
        let dimension = a.dimension.as_ref().zip(b.dimension.as_ref()).map(|(a, b)| a.over(b));
        if let Shape::Rotation(_) = a.shape {
            return self.refuse(right.region, "a rotation cannot be divided; its inverse is `transpose(R)`");
        }
        let Shape::Scalar(divisor) = b.shape else {
            return self.refuse(right.region, "a vector cannot divide; divide by `norm(..)` or by a component");
        };
        if self.graph.is_zero(divisor) {
            return self.refuse(right.region, "division by zero");
        }
        let quotient = a.map(|x| self.graph.div(x, divisor));
        Some(Value { dimension, ..quotient })
    }

    fn power(&mut self, left: &Expression, right: &Expression, a: Value, b: Value) -> Option<Value> {
        let Shape::Scalar(base) = a.shape else {
            return self.refuse(
                left.region,
                "a vector cannot be raised to a power; the square of its length is `inner(a, a)`",
            );
        };
        let Shape::Scalar(exponent) = b.shape else {
            return self.refuse(right.region, "an exponent is a scalar");
        };
        let dimension = self.dimension_of_power(a.measured(left), exponent, b.measured(right))?;
        Some(Value::scalar(self.graph.power(base, exponent), dimension))
    }

    /// The scalar product of two vectors.
    pub(super) fn inner(&mut self, a: &Value, b: &Value) -> Expr {
        if let (Shape::Spatial(a), Shape::Spatial(b)) = (&a.shape, &b.shape) {
            let (_, a, b) = self.in_common(a, b);
            return triple::inner(&mut self.graph, &a, &b);
        }
        let (a, b) = (self.components(a), self.components(b));
        let products: Vec<Expr> = a.iter().zip(&b).map(|(x, y)| self.graph.mul(*x, *y)).collect();
        self.graph.sum(&products)
    }
}

/// A product with a derivative where a vector is 0 of which it contains the length and a component.
fn vanishing(graph: &mut Graph, lengths: &FxHashMap<Expr, Vec<Expr>>, product: Expr) -> Expr {
    let Node::Product { factors, .. } = graph.node(product) else { return product };
    let known = factors.iter().filter_map(|(length, _)| Some((*length, lengths.get(length)?)));
    let pairs: Vec<_> = known.flat_map(|(length, components)| components.iter().map(move |x| (length, *x))).collect();
    pairs.into_iter().find_map(|(length, x)| graph.vanishing(product, length, x)).unwrap_or(product)
}
