//! The operands of a node.

use super::{Expr, Node, Number};
use std::{array, slice};

/// The operands of a node, in order.
#[derive(Clone)]
pub enum Operands<'a> {
    /// Those of a sum.
    Terms(slice::Iter<'a, (Expr, Number)>),
    /// Those of a product.
    Factors(slice::Iter<'a, (Expr, i64)>),
    /// As many as there are before the first `None`.
    Few(array::IntoIter<Option<Expr>, 3>),
}

impl Node {
    pub(super) fn operands(&self) -> Operands<'_> {
        match self {
            Node::Number(_) | Node::Constant(_) | Node::Symbol(_) => Operands::Factors([].iter()),
            Node::Sum { terms, .. } => Operands::Terms(terms.iter()),
            Node::Product { factors, .. } => Operands::Factors(factors.iter()),
            Node::Power { base: a, exponent: b } | Node::Atan2(a, b) => {
                Operands::Few([Some(*a), Some(*b), None].into_iter())
            }
            Node::Call(_, a) | Node::Table(_, _, a) => Operands::Few([Some(*a), None, None].into_iter()),
            Node::Choice(a, b, c) => Operands::Few([Some(*a), Some(*b), Some(*c)].into_iter()),
        }
    }
}

impl Iterator for Operands<'_> {
    type Item = Expr;

    fn next(&mut self) -> Option<Expr> {
        match self {
            Operands::Terms(terms) => terms.next().map(|(term, _)| *term),
            Operands::Factors(factors) => factors.next().map(|(base, _)| *base),
            Operands::Few(few) => few.next().flatten(),
        }
    }
}
