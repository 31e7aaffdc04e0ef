//! What a machine has to do.

use crate::symbolic::Function;

/// An operation on registers `R`; `to` takes the result. Products within sums are rounded before they are added.
#[derive(Clone, Copy, PartialEq, Debug)]
#[allow(missing_docs)]
pub enum Instruction<R> {
    /// a
    Copy { to: R, a: R },
    /// -a
    Negate { to: R, a: R },
    /// a + b
    Add { to: R, a: R, b: R },
    /// a - b
    Subtract { to: R, a: R, b: R },
    /// a b
    Multiply { to: R, a: R, b: R },
    /// a / b
    Divide { to: R, a: R, b: R },
    /// a + b c
    AddProduct { to: R, a: R, b: R, c: R },
    /// a - b c
    SubtractProduct { to: R, a: R, b: R, c: R },
    /// The square root of a.
    SquareRoot { to: R, a: R },
    /// a function of a.
    Call { function: Function, to: R, a: R },
    /// a to the power b.
    Power { to: R, a: R, b: R },
    /// The angle of the point (b, a).
    Atan2 { to: R, a: R, b: R },
    /// b where a is above 0, NaN where it is that, otherwise c.
    Choose { to: R, a: R, b: R, c: R },
    /// What an input of the mechanism is set to, or else a.
    Held { input: u32, to: R, a: R },
    /// Sines and cosines of some angles together, by their place.
    Waves { place: u32 },
    /// A table at a, by its place.
    LookUp { place: u32, a: R },
}

/// Sines and cosines that are computed together.
pub type Waves<R> = Vec<Wave<R>>;

/// A table and its derivatives.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct LookUp<R> {
    /// Which table of the model's graph.
    pub table: usize,
    /// What takes the value and its derivatives, by order.
    pub to: [R; 4],
    /// How many of these are needed.
    pub count: usize,
}

/// The sine and cosine of one angle.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Wave<R> {
    /// The angle.
    pub angle: R,
    /// Takes the sine.
    pub sin: R,
    /// Takes the cosine.
    pub cos: R,
}

impl<R: Copy> Instruction<R> {
    /// The same on other registers. All that are read come before those that are written. Angles and results of tables stand
    /// elsewhere.
    pub fn map<T: Copy>(self, f: &mut impl FnMut(R, Access) -> T) -> Instruction<T> {
        use Access::{Read, Write};
        use Instruction as I;
        macro_rules! each {
            ($to:ident, $kind:ident { $($operand:ident),* } $($other:ident)?) => {{
                $(let $operand = f($operand, Read);)*
                I::$kind { $($other,)? $($operand,)* to: f($to, Write) }
            }};
        }
        match self {
            I::Copy { to, a } => each!(to, Copy { a }),
            I::Negate { to, a } => each!(to, Negate { a }),
            I::Add { to, a, b } => each!(to, Add { a, b }),
            I::Subtract { to, a, b } => each!(to, Subtract { a, b }),
            I::Multiply { to, a, b } => each!(to, Multiply { a, b }),
            I::Divide { to, a, b } => each!(to, Divide { a, b }),
            I::AddProduct { to, a, b, c } => each!(to, AddProduct { a, b, c }),
            I::SubtractProduct { to, a, b, c } => each!(to, SubtractProduct { a, b, c }),
            I::SquareRoot { to, a } => each!(to, SquareRoot { a }),
            I::Call { function, to, a } => each!(to, Call { a } function),
            I::Power { to, a, b } => each!(to, Power { a, b }),
            I::Atan2 { to, a, b } => each!(to, Atan2 { a, b }),
            I::Choose { to, a, b, c } => each!(to, Choose { a, b, c }),
            I::Held { input, to, a } => each!(to, Held { a } input),
            I::Waves { place } => I::Waves { place },
            I::LookUp { place, a } => I::LookUp { place, a: f(a, Read) },
        }
    }
}

/// How an instruction uses a register.
#[derive(Clone, Copy, PartialEq, Eq)]
#[allow(missing_docs)]
pub enum Access {
    Read,
    Write,
}
