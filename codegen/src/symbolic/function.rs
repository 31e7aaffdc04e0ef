//! Elementary functions and their symmetries.

use super::{Expr, Graph, Node, Number};

/// An elementary function of one argument.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Debug)]
#[allow(missing_docs)]
pub enum Function {
    Sin,
    Cos,
    Tan,
    Asin,
    Acos,
    Atan,
    Sinh,
    Cosh,
    Tanh,
    Exp,
    Ln,
    Abs,
    /// -1, 0 or 1: the derivative of the absolute value.
    Sign,
}

impl Function {
    /// Every function, in the order of the language reference.
    pub const ALL: [Function; 13] = {
        use Function::*;
        [Sin, Cos, Tan, Asin, Acos, Atan, Sinh, Cosh, Tanh, Exp, Ln, Abs, Sign]
    };

    /// The name in the language.
    pub fn name(self) -> &'static str {
        use Function::*;
        match self {
            Sin => "sin",
            Cos => "cos",
            Tan => "tan",
            Asin => "asin",
            Acos => "acos",
            Atan => "atan",
            Sinh => "sinh",
            Cosh => "cosh",
            Tanh => "tanh",
            Exp => "exp",
            Ln => "ln",
            Abs => "abs",
            Sign => "sign",
        }
    }

    /// The exact value at 0, where it is a rational number.
    fn at_zero(self) -> Option<i64> {
        use Function::*;
        match self {
            Cos | Cosh | Exp => Some(1),
            Acos | Ln => None,
            _ => Some(0),
        }
    }

    fn parity(self) -> Parity {
        use Function::*;
        match self {
            Cos | Cosh | Abs => Parity::Even,
            Sin | Tan | Asin | Atan | Sinh | Tanh | Sign => Parity::Odd,
            Acos | Exp | Ln => Parity::None,
        }
    }
}

#[derive(PartialEq)]
enum Parity {
    Even,
    Odd,
    None,
}

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
