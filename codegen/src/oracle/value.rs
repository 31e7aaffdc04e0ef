//! The value of an expression: a scalar, a vector or a rotation.

use super::error::{OracleError, Result, refuse};
use super::jet::Jet;
use super::rotation::Rotation;
use crate::dsl::Operator;

/// A scalar, the components of a vector, two or three, or a rotation.
#[derive(Clone, Debug)]
pub(super) enum Value {
    Scalar(Jet),
    Vector(Vec<Jet>),
    Rotation(Rotation),
}

impl Value {
    pub(super) fn scalar(self) -> Result<Jet> {
        match self {
            Value::Scalar(jet) => Ok(jet),
            _ => refuse("a scalar is needed, not a vector or rotation"),
        }
    }

    pub(super) fn vector(self) -> Result<Vec<Jet>> {
        match self {
            Value::Vector(components) => Ok(components),
            _ => refuse("a vector is needed, not a scalar or rotation"),
        }
    }

    pub(super) fn rotation(self) -> Result<Rotation> {
        match self {
            Value::Rotation(rotation) => Ok(rotation),
            _ => refuse("a rotation is needed"),
        }
    }

    /// The one component of a scalar, those of a vector, or the entries of a rotation.
    pub(super) fn components(self) -> Vec<Jet> {
        match self {
            Value::Scalar(jet) => vec![jet],
            Value::Vector(components) => components,
            Value::Rotation(rotation) => rotation.entries,
        }
    }

    pub(super) fn component(self, name: &str) -> Result<Value> {
        let components = self.vector()?;
        let component = ["x", "y", "z"].iter().zip(components).find(|(axis, _)| **axis == name);
        component.map(|(_, jet)| Value::Scalar(jet)).ok_or_else(|| OracleError::new(format!("no component `.{name}`")))
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
            Value::Vector(components) => components.iter().map(of).collect::<Option<_>>().map(Value::Vector),
            Value::Rotation(_) => None,
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
            (Value::Rotation(a), Value::Rotation(b)) => Ok(Value::Rotation(a.then(&b))),
            (Value::Rotation(a), Value::Vector(b)) => a.turn(&b).map(Value::Vector),
            (Value::Scalar(a), b) => Ok(b.map(|jet| &a * jet)),
            (a, Value::Scalar(b)) => Ok(a.map(|jet| jet * &b)),
            _ => refuse("a product of two vectors; the scalar product is `inner(a, b)`"),
        }
    }

    fn map(&self, change: impl Fn(&Jet) -> Jet) -> Value {
        match self {
            Value::Scalar(jet) => Value::Scalar(change(jet)),
            Value::Vector(components) => Value::Vector(components.iter().map(change).collect()),
            Value::Rotation(_) => self.clone(),
        }
    }

    fn pairwise(self, other: Value, combine: impl Fn(&Jet, &Jet) -> Jet) -> Result<Value> {
        match (self, other) {
            (Value::Scalar(a), Value::Scalar(b)) => Ok(Value::Scalar(combine(&a, &b))),
            (Value::Vector(a), Value::Vector(b)) if a.len() == b.len() => {
                Ok(Value::Vector(a.iter().zip(&b).map(|(a, b)| combine(a, b)).collect()))
            }
            _ => refuse("a sum of a scalar and a vector"),
        }
    }
}

/// ax bx + ay by + ..
pub(super) fn inner(a: &[Jet], b: &[Jet]) -> Result<Jet> {
    let products = a.iter().zip(b).map(|(a, b)| a * b);
    products.reduce(|sum, product| &sum + &product).ok_or_else(|| OracleError::new("a vector without components"))
}

/// a x b.
pub(super) fn cross(a: &[Jet], b: &[Jet]) -> Result<Vec<Jet>> {
    if a.len() != 3 || b.len() != 3 {
        return refuse("a vector product is of vectors of three components");
    }
    let component = |i: usize| {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        &(&a[j] * &b[k]) - &(&a[k] * &b[j])
    };
    Ok((0..3).map(component).collect())
}
