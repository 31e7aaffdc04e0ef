//! What an expression evaluates to: a scalar or a vector of the plane.

use super::error::{OracleError, Result, refuse};
use super::jet::Jet;
use crate::dsl::Operator;

/// A scalar, or x and y of a vector.
#[derive(Clone, Debug)]
pub(super) enum Value {
    Scalar(Jet),
    Vector([Jet; 2]),
}

impl Value {
    pub(super) fn scalar(self) -> Result<Jet> {
        match self {
            Value::Scalar(jet) => Ok(jet),
            Value::Vector(_) => refuse("a scalar is needed, not a vector"),
        }
    }

    pub(super) fn vector(self) -> Result<[Jet; 2]> {
        match self {
            Value::Vector(components) => Ok(components),
            Value::Scalar(_) => refuse("a vector is needed, not a scalar"),
        }
    }

    /// The one component of a scalar, or x and y.
    pub(super) fn components(self) -> Vec<Jet> {
        match self {
            Value::Scalar(jet) => vec![jet],
            Value::Vector(components) => components.into(),
        }
    }

    pub(super) fn component(self, name: &str) -> Result<Value> {
        let [x, y] = self.vector()?;
        match name {
            "x" => Ok(Value::Scalar(x)),
            "y" => Ok(Value::Scalar(y)),
            _ => refuse(format!("a vector of the plane has no component `.{name}`")),
        }
    }

    /// A multiple.
    pub(super) fn multiplied(&self, factor: f64) -> Value {
        self.map(|jet| jet.compose([factor * jet.value().value, factor, 0.0, 0.0]))
    }

    pub(super) fn negate(&self) -> Value {
        self.map(|jet| -jet)
    }

    /// The total time derivative, by that of each component.
    pub(super) fn rate(&self, of: impl Fn(&Jet) -> Option<Jet>) -> Result<Value> {
        let missing = || OracleError::new("a time derivative that is not known here");
        match self {
            Value::Scalar(jet) => of(jet).map(Value::Scalar),
            Value::Vector([x, y]) => of(x).zip(of(y)).map(|(x, y)| Value::Vector([x, y])),
        }
        .ok_or_else(missing)
    }

    pub(super) fn combine(self, operator: Operator, other: Value) -> Result<Value> {
        match operator {
            Operator::Add => self.pairwise(other, |a, b| a + b),
            Operator::Subtract => self.pairwise(other, |a, b| a - b),
            Operator::Multiply => self.multiply(other),
            Operator::Divide => {
                let divisor = other.scalar()?;
                Ok(self.map(|jet| jet / &divisor))
            }
            Operator::Power => Ok(Value::Scalar(self.scalar()?.power(&other.scalar()?))),
        }
    }

    fn multiply(self, other: Value) -> Result<Value> {
        match (self, other) {
            (Value::Scalar(a), b) => Ok(b.map(|jet| &a * jet)),
            (a, Value::Scalar(b)) => Ok(a.map(|jet| jet * &b)),
            _ => refuse("a product of two vectors; the scalar product is `inner(a, b)`"),
        }
    }

    fn map(&self, change: impl Fn(&Jet) -> Jet) -> Value {
        match self {
            Value::Scalar(jet) => Value::Scalar(change(jet)),
            Value::Vector([x, y]) => Value::Vector([change(x), change(y)]),
        }
    }

    fn pairwise(self, other: Value, combine: impl Fn(&Jet, &Jet) -> Jet) -> Result<Value> {
        match (self, other) {
            (Value::Scalar(a), Value::Scalar(b)) => Ok(Value::Scalar(combine(&a, &b))),
            (Value::Vector([a, b]), Value::Vector([c, d])) => Ok(Value::Vector([combine(&a, &c), combine(&b, &d)])),
            _ => refuse("a sum of a scalar and a vector"),
        }
    }
}

/// ax bx + ay by.
pub(super) fn inner([ax, ay]: &[Jet; 2], [bx, by]: &[Jet; 2]) -> Jet {
    &(ax * bx) + &(ay * by)
}
