//! Elementary functions and their symmetries.

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
    pub(super) fn at_zero(self) -> Option<i64> {
        use Function::*;
        match self {
            Cos | Cosh | Exp => Some(1),
            Acos | Ln => None,
            _ => Some(0),
        }
    }

    pub(super) fn parity(self) -> Parity {
        use Function::*;
        match self {
            Cos | Cosh | Abs => Parity::Even,
            Sin | Tan | Asin | Atan | Sinh | Tanh | Sign => Parity::Odd,
            Acos | Exp | Ln => Parity::None,
        }
    }
}

/// The symmetry of a function in the sign of its argument.
#[derive(PartialEq)]
pub(super) enum Parity {
    Even,
    Odd,
    None,
}
