//! Functions applied to expressions.

use super::function::Parity;
use super::{Expr, Function, Graph, Node, Number};

impl Graph {
    /// `function(argument)`. Odd and even functions take the sign out of their argument.
    pub fn call(&mut self, function: Function, argument: Expr) -> Expr {
        if let Some(value) = self.exact_call(function, argument) {
            return value;
        }
        match function.parity() {
            Parity::None => self.intern(Node::Call(function, argument)),
            parity => match self.without_sign(argument) {
                None => self.intern(Node::Call(function, argument)),
                Some(positive) => {
                    let value = self.intern(Node::Call(function, positive));
                    if parity == Parity::Odd { self.neg(value) } else { value }
                }
            },
        }
    }

    /// The angle of the point (x, y), in (-pi, pi].
    pub fn atan2(&mut self, y: Expr, x: Expr) -> Expr {
        self.intern(Node::Atan2(y, x))
    }

    fn exact_call(&mut self, function: Function, argument: Expr) -> Option<Expr> {
        let facts = self.facts(argument);
        let value = match (function, self.as_number(argument)?) {
            (_, value) if value.is_zero() => function.at_zero()?.into(),
            (Function::Ln, value) if value.is_one() => Number::ZERO,
            (Function::Abs, value) => value.abs(),
            (Function::Sign, _) => {
                if facts.nonnegative {
                    Number::ONE
                } else {
                    Number::MINUS_ONE
                }
            }
            _ => return None,
        };
        Some(self.number(value))
    }

    /// The negated argument, if it is written with a minus sign in front.
    fn without_sign(&mut self, argument: Expr) -> Option<Expr> {
        let negative = match self.node(argument) {
            Node::Number(value) => value.is_negative(),
            Node::Product { coefficient, .. } => coefficient.is_negative(),
            Node::Sum { terms, .. } => terms.first().is_some_and(|(_, c)| c.is_negative()),
            _ => false,
        };
        negative.then(|| self.neg(argument))
    }
}
