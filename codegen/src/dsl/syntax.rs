//! Expressions as the user wrote them, and where.

use super::Region;
use syn::Ident;

/// A scalar, vector or rotation.
#[derive(Clone)]
pub struct Expression {
    /// Its place in the text.
    pub region: Region,
    /// Its kind.
    pub kind: Kind,
}

impl Expression {
    /// The expressions that this one is made of, in order.
    pub fn parts(&self) -> Vec<&Expression> {
        match &self.kind {
            Kind::Number { .. } | Kind::Name(_) => vec![],
            Kind::Vector(parts) | Kind::Call(_, parts) => parts.iter().collect(),
            Kind::Negate(part) | Kind::Component(part, _) => vec![part],
            Kind::Binary(_, left, right) => vec![left, right],
            Kind::Attitude(_, rotation) => vec![rotation],
            Kind::If(choice) => vec![&choice.left, &choice.right, &choice.yes, &choice.no],
        }
    }

    /// Whether a name occurs.
    pub fn mentions(&self, word: &str) -> bool {
        matches!(&self.kind, Kind::Name(name) if name == word) || self.parts().iter().any(|part| part.mentions(word))
    }
}

/// The kind of an expression.
#[derive(Clone)]
pub enum Kind {
    /// `0.2` or `75 [rpm]`
    Number {
        /// The decimal literal, as written.
        literal: String,
        /// Its unit.
        unit: Option<Unit>,
    },
    /// `alpha`
    Name(Ident),
    /// `[x, y]`
    Vector(Vec<Expression>),
    /// `-x`
    Negate(Box<Expression>),
    /// `a + b` and its like
    Binary(Operator, Box<Expression>, Box<Expression>),
    /// `sin(x)`
    Call(Ident, Vec<Expression>),
    /// `C.y`
    Component(Box<Expression>, Ident),
    /// `if a > b then x else y`
    If(Box<Choice>),
    /// `attitude(body)`, with the rotation that it is.
    Attitude(Ident, Box<Expression>),
}

/// `if left > right then yes else no`
#[derive(Clone)]
pub struct Choice {
    /// The left side.
    pub left: Expression,
    /// How.
    pub comparison: Comparison,
    /// The right side.
    pub right: Expression,
    /// The value where it is so.
    pub yes: Expression,
    /// The value where it is not.
    pub no: Expression,
}

/// A comparison of two scalars.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[allow(missing_docs)]
pub enum Comparison {
    Less,
    AtMost,
    Greater,
    AtLeast,
}

/// An operation on two operands.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[allow(missing_docs)]
pub enum Operator {
    Add,
    Subtract,
    Multiply,
    Divide,
    Power,
}

/// `[kg*m^2]`
#[derive(Clone)]
pub struct Unit {
    /// Its place in the text.
    pub region: Region,
    /// Names with their exponents, in order.
    pub factors: Vec<(Ident, i32)>,
    /// As written, without spaces.
    pub text: String,
}
