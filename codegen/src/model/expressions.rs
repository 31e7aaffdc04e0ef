//! Expressions of the language to symbolic values.

use super::interpreter::Interpreter;
use super::scope::{self, plain};
use super::space::Spatial;
use super::value::{Shape, Value};
use super::{Dimension, Point, Unit};
use crate::dsl::{Expression, Kind, Region};
use crate::symbolic::{Constant, Expr, Number};
use syn::Ident;

impl Interpreter {
    /// A scalar.
    pub(super) fn scalar(&mut self, expression: &Expression) -> Option<Expr> {
        self.scalar_value(expression).map(|(value, _)| value)
    }

    pub(super) fn scalar_value(&mut self, expression: &Expression) -> Option<(Expr, Option<Dimension>)> {
        let value = self.value(expression)?;
        match value.shape {
            Shape::Scalar(scalar) => Some((scalar, value.dimension)),
            Shape::Vector(_) | Shape::Spatial(_) => self.refuse(
                expression.region,
                "a vector stands where a scalar belongs; take a component (`.x`, `.y`) or `norm(..)`",
            ),
            Shape::Rotation(_) => self.refuse(expression.region, "a rotation stands where a scalar belongs"),
        }
    }

    /// A vector by its components in the world.
    pub(super) fn point_value(&mut self, expression: &Expression) -> Option<(Point, Option<Dimension>)> {
        let value = self.vector_value(expression)?;
        self.expect_world(expression.region, &value.bases)?;
        Some((self.components(&value), value.dimension))
    }

    /// A vector of the plane or of space.
    pub(super) fn vector_value(&mut self, expression: &Expression) -> Option<Value> {
        let value = self.value(expression)?;
        match value.shape {
            Shape::Vector(_) | Shape::Spatial(_) => Some(value),
            Shape::Scalar(_) => {
                let form = if self.is_spatial() { "[x, y, z]" } else { "[x, y]" };
                self.refuse(
                    expression.region,
                    format!("a scalar stands where a vector belongs; a vector is written `{form}`"),
                )
            }
            Shape::Rotation(_) => {
                self.refuse(expression.region, "a rotation stands where a vector belongs; `R*[x, y, z]` turns one")
            }
        }
    }

    /// A vector of space, and what else is known of it.
    pub(super) fn spatial_value(&mut self, expression: &Expression) -> Option<(Spatial, Value)> {
        let value = self.vector_value(expression)?;
        match &value.shape {
            Shape::Spatial(vector) => Some((vector.clone(), value)),
            _ => self.refuse(expression.region, "a vector of the plane stands where one of space belongs, `[x, y, z]`"),
        }
    }

    /// The components of a value: of a vector those in the world, of a rotation those of its matrix.
    pub(super) fn components(&mut self, value: &Value) -> Vec<Expr> {
        match &value.shape {
            Shape::Scalar(scalar) => vec![*scalar],
            Shape::Vector(components) => components.to_vec(),
            Shape::Spatial(vector) => self.resolved(vector).to_vec(),
            Shape::Rotation(turn) => self.frames.matrix(*turn).concat(),
        }
    }

    /// Any value.
    pub(super) fn value(&mut self, expression: &Expression) -> Option<Value> {
        let region = expression.region;
        let mut value = match &expression.kind {
            Kind::Number { literal, unit } => self.number(region, literal, unit.as_ref()),
            Kind::Name(name) => self.name(name),
            Kind::Vector(components) => self.vector(region, components),
            Kind::Negate(operand) => {
                let value = self.value(operand)?;
                Some(value.map(|x| self.graph.neg(x)))
            }
            Kind::Binary(operator, left, right) => self.binary(*operator, left, right),
            Kind::Call(function, arguments) => self.call(region, function, arguments),
            Kind::Component(vector, name) => self.component(vector, name),
            Kind::If(choice) => self.choice(choice),
            Kind::Attitude(body, rotation) => self.attitude(body, rotation),
        }?;
        let components = self.components(&value);
        self.check_constants(region, &components)?;
        value.dimension = value.dimension.filter(|_| self.with_units);
        Some(value)
    }

    fn number(&mut self, region: Region, literal: &str, unit: Option<&crate::dsl::Unit>) -> Option<Value> {
        let Some(number) = Number::parse_decimal(literal) else {
            return self.refuse(region, format!("`{literal}` is outside the range of numbers (about 1e-308 to 1e308)"));
        };
        let zero = number.is_zero();
        let value = self.graph.number(number);
        let Some(unit) = unit else {
            return Some(Value::scalar(value, (!zero).then(Dimension::none)));
        };
        let unit = self.mistakes.note(Unit::resolve(unit))?;
        let factor = unit.factor_expression(&mut self.graph);
        Some(Value::scalar(self.graph.mul(value, factor), Some(unit.dimension().clone())))
    }

    fn name(&mut self, name: &Ident) -> Option<Value> {
        let text = plain(name);
        if self.misnamed.contains(&text) {
            return None;
        }
        match text.as_str() {
            "pi" => return Some(Value::scalar(self.graph.constant(Constant::Pi), Some(Dimension::none()))),
            "e" => return Some(Value::scalar(self.graph.constant(Constant::E), Some(Dimension::none()))),
            "t" => return Some(Value::scalar(self.time, Some(Dimension::time()))),
            _ => {}
        }
        if let Some((_, value)) = self.local.iter().find(|(word, _)| *word == text) {
            return Some(value.clone());
        }
        let is_hidden = self.values.get_region(&text).is_some();
        if !is_hidden && scope::functions().any(|function| function == text) {
            return self.refuse(name.into(), format!("`{text}` is a function; call it: `{text}(..)`"));
        }
        if self.tables.get_region(&text).is_some() {
            return self.refuse(name.into(), format!("`{text}` is a table; it takes an argument: `{text}(x)`"));
        }
        if self.values.get_region(&text).is_none() {
            if let Some((rate, coordinate)) = self.rate_of_coordinate(&text) {
                return self
                    .refuse(name.into(), format!("the rate of `{coordinate}` is written `{rate}({coordinate})` here"));
            }
            if self.outputs.contains(&text) {
                let message =
                    format!("`{text}` is an output; to use it here too, name its expression: `let {text} = ..;`");
                return self.refuse(name.into(), message);
            }
        }
        self.values.find(name, &mut self.mistakes)
    }

    /// `dot` and `x` for `x_dot`.
    fn rate_of_coordinate<'t>(&self, text: &'t str) -> Option<(&'static str, &'t str)> {
        let (rate, base) = match (text.strip_suffix("_ddot"), text.strip_suffix("_dot")) {
            (Some(base), _) => ("ddot", base),
            (None, base) => ("dot", base?),
        };
        self.values.get_region(base).map(|_| (rate, base))
    }

    fn component(&mut self, vector: &Expression, name: &Ident) -> Option<Value> {
        let value = self.value(vector)?;
        if let Shape::Scalar(_) | Shape::Rotation(_) = value.shape {
            return self.refuse(name.into(), format!("{} has no component `.{name}`", value.kind()));
        }
        let components = self.components(&value);
        let place = ["x", "y", "z"].iter().position(|axis| plain(name) == *axis);
        match place.and_then(|place| components.get(place)) {
            Some(component) => Some(Value::scalar(*component, value.dimension)),
            None if components.len() == 2 => self
                .refuse(name.into(), format!("a vector of the plane has the components `.x` and `.y`, not `.{name}`")),
            None => self.refuse(
                name.into(),
                format!("a vector of space has the components `.x`, `.y` and `.z`, not `.{name}`"),
            ),
        }
    }
}
