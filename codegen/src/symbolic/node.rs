//! Expressions and their nodes.

use super::{Function, Number, TableId};

/// An expression of a [`Graph`](super::Graph). Equal handles are equal expressions.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Debug)]
pub struct Expr(u32);

impl Expr {
    /// Position in the graph: operands stand before their results.
    pub fn index(self) -> usize {
        self.0 as usize
    }

    pub(super) fn at(index: usize) -> Expr {
        Expr(index as u32)
    }
}

/// A free variable of a graph.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Debug)]
pub struct Symbol(pub(super) u32);

/// A constant that is not rational.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Debug)]
pub enum Constant {
    /// The circle's ratio.
    Pi,
    /// Euler's number.
    E,
}

impl Constant {
    /// The nearest `f64`.
    pub fn to_f64(self) -> f64 {
        match self {
            Constant::Pi => std::f64::consts::PI,
            Constant::E => std::f64::consts::E,
        }
    }
}

/// The node of an expression. Canonical: only the constructors of [`Graph`](super::Graph) make nodes.
#[derive(Clone, PartialEq, Eq, Hash, Debug)]
pub enum Node {
    /// An exact rational.
    Number(Number),
    /// pi or e.
    Constant(Constant),
    /// A free variable.
    Symbol(Symbol),
    /// `constant + sum of coefficient * term`; terms are sorted, distinct, no sums, no numbers, and of
    /// coefficient one themselves; coefficients are not zero.
    Sum {
        /// The rational part.
        constant: Number,
        /// Terms with their coefficients.
        terms: Box<[(Expr, Number)]>,
    },
    /// `coefficient * product of base^exponent`; exponents are integers, not zero. A base stands twice
    /// only with exponents of opposite sign, when it may be zero or infinite.
    Product {
        /// The rational factor, not zero.
        coefficient: Number,
        /// Bases, sorted, with their exponents.
        factors: Box<[(Expr, i64)]>,
    },
    /// `base^exponent` for exponents that are not integers. A fraction p/q is kept as the p-th power (in
    /// a product) of `base^(1/q)`.
    Power {
        /// The base.
        base: Expr,
        /// A fraction 1/q, or an expression; or any number of which q is not below 2^32.
        exponent: Expr,
    },
    /// An elementary function.
    Call(Function, Expr),
    /// The angle of the point (x, y), given as (y, x).
    Atan2(Expr, Expr),
    /// The second where the first is above zero, otherwise the third; NaN where the first is.
    Choice(Expr, Expr, Expr),
    /// The derivative of this order of a table at an argument; its degree at most.
    Table(TableId, u8, Expr),
}
