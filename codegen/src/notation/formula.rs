//! Formulas: expressions for readers, independent of notation.

use super::names::Name;
use crate::symbolic::{Constant, Function};
use std::rc::Rc;

/// An expression in the order and shape in which it is read.
#[derive(Clone, Debug)]
pub(super) enum Formula {
    /// A number that is not negative: digits, perhaps with a decimal point.
    Number(String),
    Constant(Constant),
    Name(Rc<Name>),
    /// Terms, each with whether it is subtracted.
    Sum(Vec<(bool, Formula)>),
    /// Factors, without quotients.
    Product(Vec<Formula>),
    Quotient(Box<Formula>, Box<Formula>),
    Power(Box<Formula>, Box<Formula>),
    /// The root of this degree.
    Root(Box<Formula>, String),
    Call(Function, Box<Formula>),
    /// The angle of the point (x, y), given as (y, x).
    Atan2(Box<Formula>, Box<Formula>),
    /// The second where the first is above zero, otherwise the third.
    Choice(Box<Formula>, Box<Formula>, Box<Formula>),
    /// The derivative of this order of the table of that name.
    Table(Rc<Name>, u8, Box<Formula>),
    Transpose(Rc<Name>),
}

/// How tightly the outermost operation of a formula binds.
#[derive(Clone, Copy, PartialEq, PartialOrd)]
pub(super) enum Binding {
    Choice,
    Sum,
    Product,
    Power,
    Atom,
}

impl Formula {
    pub(super) fn number(value: usize) -> Formula {
        Formula::Number(value.to_string())
    }

    /// The formula with a minus sign in front, or without.
    pub(super) fn signed(self, negative: bool) -> Formula {
        if negative { Formula::Sum(vec![(true, self)]) } else { self }
    }

    /// The sum of terms; one that is added comes first.
    pub(super) fn sum(mut terms: Vec<(bool, Formula)>) -> Formula {
        if let Some(first) = terms.iter().position(|(negative, _)| !negative) {
            terms[..=first].rotate_right(1);
        }
        match terms.as_slice() {
            [] => Formula::number(0),
            [(false, _)] => terms.remove(0).1,
            _ => Formula::Sum(terms),
        }
    }

    /// The product of factors, each where a reader looks for it: numbers, names, rates, sums, functions.
    pub(super) fn product(mut factors: Vec<Formula>) -> Formula {
        factors.sort_by_key(Formula::rank);
        match factors.len() {
            0 => Formula::number(1),
            1 => factors.remove(0),
            _ => Formula::Product(factors),
        }
    }

    pub(super) fn binding(&self) -> Binding {
        match self {
            Formula::Choice(..) => Binding::Choice,
            Formula::Sum(_) => Binding::Sum,
            Formula::Product(_) | Formula::Quotient(..) => Binding::Product,
            Formula::Power(..) => Binding::Power,
            Formula::Root(_, degree) if degree != "2" => Binding::Power,
            _ => Binding::Atom,
        }
    }

    pub(super) fn is_zero(&self) -> bool {
        matches!(self, Formula::Number(digits) if digits == "0")
    }

    fn rank(&self) -> usize {
        match self {
            Formula::Number(_) => 0,
            Formula::Constant(_) => 1,
            Formula::Name(name) => 2 + name.dots(),
            Formula::Power(base, _) => base.rank(),
            Formula::Sum(_) | Formula::Product(_) | Formula::Quotient(..) | Formula::Root(..) => 5,
            Formula::Call(..)
            | Formula::Atan2(..)
            | Formula::Choice(..)
            | Formula::Table(..)
            | Formula::Transpose(_) => 6,
        }
    }
}
