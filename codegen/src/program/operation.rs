//! The operations of a program.

use super::columns::ColumnsShape;
use crate::symbolic::{Function, TableId};
use std::sync::Arc;
use std::{array, slice};

/// A value of the program. Operands have smaller indices than their results.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Debug)]
pub(super) struct Value(pub(super) u32);

/// The operation of a value.
#[derive(Clone, PartialEq, Eq, Hash, Debug)]
pub(super) enum Operation {
    /// A number that is not negative, by its bits.
    Constant(u64),
    /// An input of the kernel.
    Input(Input),
    /// Terms, each with whether it is subtracted.
    Sum(Vec<(bool, Value)>),
    /// Factors.
    Product(Vec<Value>),
    /// A quotient.
    Quotient(Value, Value),
    /// The opposite.
    Negate(Value),
    /// A function of one argument.
    Call(Function, Value),
    /// A square root.
    Sqrt(Value),
    /// A real power.
    Power(Value, Value),
    /// The angle of the point (x, y), as (y, x).
    Atan2(Value, Value),
    /// The second where the first is above zero, otherwise the third.
    Choice(Value, Value, Value),
    /// The derivative of this order of a table.
    Table(TableId, u8, Value),
    /// An input: the value it is set to, or its declared course.
    Held(Value, Value),
    /// The solutions of a system for many right-hand sides.
    Columns(Box<ColumnsOperation>),
    /// The entry of such a matrix in a row and a column.
    Entry(Value, usize, usize),
}

/// A matrix of right-hand sides with what solves it.
#[derive(Clone, PartialEq, Eq, Hash, Debug)]
pub(super) struct ColumnsOperation {
    pub(super) shape: Arc<ColumnsShape>,
    /// The reciprocals of pivots and the entries of L, by steps; then the right-hand sides, by rows.
    pub(super) operands: Vec<Value>,
}

/// An input of a kernel; numbers count in the order of declaration.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Debug)]
pub(super) enum Input {
    /// A parameter of the mechanism.
    Parameter(usize),
    /// The activity of a constraint that events switch.
    Activity(usize),
    /// The value that an input of the mechanism is set to, if any.
    Held(usize),
    /// Time.
    Time,
    /// A coordinate.
    Position(usize),
    /// Its speed.
    Speed(usize),
    /// Its acceleration.
    Acceleration(usize),
    /// A multiplier.
    Multiplier(usize),
    /// A generalised speed.
    GeneralizedSpeed(usize),
}

impl Value {
    pub(super) fn index(self) -> usize {
        self.0 as usize
    }
}

impl Operation {
    /// The operands, in order.
    pub(super) fn operands(&self) -> Operands<'_> {
        match self {
            Operation::Constant(_) | Operation::Input(_) => Operands::Factors([].iter()),
            Operation::Sum(terms) => Operands::Terms(terms.iter()),
            Operation::Product(factors) => Operands::Factors(factors.iter()),
            Operation::Columns(columns) => Operands::Factors(columns.operands.iter()),
            Operation::Quotient(a, b) | Operation::Power(a, b) | Operation::Atan2(a, b) | Operation::Held(a, b) => {
                Operands::Few([Some(*a), Some(*b), None].into_iter())
            }
            Operation::Choice(a, b, c) => Operands::Few([Some(*a), Some(*b), Some(*c)].into_iter()),
            Operation::Negate(a)
            | Operation::Call(_, a)
            | Operation::Sqrt(a)
            | Operation::Table(_, _, a)
            | Operation::Entry(a, ..) => Operands::Few([Some(*a), None, None].into_iter()),
        }
    }

    /// The same on other operands.
    pub(super) fn map(&self, f: impl Fn(Value) -> Value) -> Operation {
        match self {
            Operation::Constant(_) | Operation::Input(_) => self.clone(),
            Operation::Sum(terms) => Operation::Sum(terms.iter().map(|(negative, x)| (*negative, f(*x))).collect()),
            Operation::Product(factors) => Operation::Product(factors.iter().map(|x| f(*x)).collect()),
            Operation::Quotient(above, below) => Operation::Quotient(f(*above), f(*below)),
            Operation::Negate(operand) => Operation::Negate(f(*operand)),
            Operation::Call(function, argument) => Operation::Call(*function, f(*argument)),
            Operation::Sqrt(argument) => Operation::Sqrt(f(*argument)),
            Operation::Power(base, exponent) => Operation::Power(f(*base), f(*exponent)),
            Operation::Atan2(y, x) => Operation::Atan2(f(*y), f(*x)),
            Operation::Choice(difference, above, other) => Operation::Choice(f(*difference), f(*above), f(*other)),
            Operation::Table(table, order, argument) => Operation::Table(*table, *order, f(*argument)),
            Operation::Held(held, course) => Operation::Held(f(*held), f(*course)),
            Operation::Columns(columns) => {
                let operands = columns.operands.iter().map(|x| f(*x)).collect();
                Operation::Columns(Box::new(ColumnsOperation { shape: columns.shape.clone(), operands }))
            }
            Operation::Entry(matrix, i, j) => Operation::Entry(f(*matrix), *i, *j),
        }
    }
}

/// The operands of a value.
#[derive(Clone)]
pub(super) enum Operands<'a> {
    Terms(slice::Iter<'a, (bool, Value)>),
    Factors(slice::Iter<'a, Value>),
    /// As many as there are before the first `None`.
    Few(array::IntoIter<Option<Value>, 3>),
}

impl Iterator for Operands<'_> {
    type Item = Value;

    fn next(&mut self) -> Option<Value> {
        match self {
            Operands::Terms(terms) => terms.next().map(|(_, term)| *term),
            Operands::Factors(factors) => factors.next().copied(),
            Operands::Few(few) => few.next().flatten(),
        }
    }
}
