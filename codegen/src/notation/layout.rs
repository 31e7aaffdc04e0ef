//! Formulas laid out in two dimensions, as both LaTeX and MathML set them.

use super::formula::{Binding, Formula};
use super::names::Name;
use crate::symbolic::{Constant, Function};

/// The arrangement of symbols beside, above and below each other.
pub(super) enum Layout {
    Row(Vec<Layout>),
    Number(String),
    /// A letter, the name of a Greek one, or a word; perhaps bold.
    Word(String, bool),
    /// The name of a function that stands before its argument.
    Function(&'static str),
    Operator(Operator),
    Fraction(Box<Layout>, Box<Layout>),
    Superscript(Box<Layout>, Box<Layout>),
    Subscript(Box<Layout>, Vec<Layout>),
    /// A root, with its degree if that is not 2.
    Root(Box<Layout>, Option<String>),
    /// Dots above: time derivatives.
    Dots(Box<Layout>, usize),
    Parentheses(Box<Layout>),
    Bars(Box<Layout>),
    Matrix(Vec<Vec<Layout>>),
    /// Values, each with the case in which it holds.
    Cases(Vec<(Layout, Layout)>),
    /// Plain words.
    Text(&'static str),
}

/// Signs between and before formulas.
#[derive(Clone, Copy)]
pub(super) enum Operator {
    Plus,
    Minus,
    /// A minus sign in front of all else.
    Negative,
    /// A product without a sign.
    Times,
    /// A product between numbers.
    Dot,
    Comma,
    Greater,
    /// Between a function and its argument.
    Apply,
    /// Above a matrix.
    Transpose,
    /// Above a function: a derivative.
    Prime,
}

/// Lays a formula out.
pub(super) fn layout(formula: &Formula) -> Layout {
    match formula {
        Formula::Number(digits) => Layout::Number(digits.clone()),
        Formula::Constant(Constant::Pi) => Layout::Word("pi".into(), false),
        Formula::Constant(Constant::E) => euler(),
        Formula::Name(name) => word(name),
        Formula::Sum(terms) => sum(terms, true),
        Formula::Product(factors) => product(factors),
        Formula::Quotient(above, below) => Layout::Fraction(layout(above).into(), layout(below).into()),
        Formula::Power(base, exponent) => power(base, exponent),
        Formula::Root(radicand, degree) => {
            Layout::Root(layout(radicand).into(), (degree != "2").then(|| degree.clone()))
        }
        Formula::Call(Function::Abs, argument) => Layout::Bars(layout(argument).into()),
        Formula::Call(Function::Exp, argument) => Layout::Superscript(euler().into(), layout(argument).into()),
        Formula::Call(function, argument) => call(Layout::Function(function_name(*function)), argument),
        Formula::Atan2(y, x) => {
            let pair = Layout::Row(vec![layout(y), Layout::Operator(Operator::Comma), layout(x)]);
            let name = Layout::Function("atan2");
            Layout::Row(vec![name, Layout::Operator(Operator::Apply), Layout::Parentheses(pair.into())])
        }
        Formula::Table(name, order, argument) => {
            Layout::Row(vec![primed(word(name), *order), Layout::Operator(Operator::Apply), parentheses(argument)])
        }
        Formula::Choice(difference, above, otherwise) => {
            let is_above = vec![layout(difference), Layout::Operator(Operator::Greater), Layout::Number("0".into())];
            let rows = [(above, Layout::Row(is_above)), (otherwise, Layout::Text("otherwise"))];
            Layout::Cases(rows.map(|(value, case)| (layout(value), case)).into())
        }
        Formula::Transpose(name) => {
            Layout::Superscript(word(name).into(), Layout::Operator(Operator::Transpose).into())
        }
    }
}

/// Terms with their signs. Where the sum does not start here, the first sign is one between terms.
pub(super) fn sum(terms: &[(bool, Formula)], starts: bool) -> Layout {
    let mut row = Vec::new();
    for (at, (negative, term)) in terms.iter().enumerate() {
        match (starts && at == 0, negative) {
            (true, true) => row.push(Layout::Operator(Operator::Negative)),
            (true, false) => {}
            (false, true) => row.push(Layout::Operator(Operator::Minus)),
            (false, false) => row.push(Layout::Operator(Operator::Plus)),
        }
        row.push(unless(term.binding() <= Binding::Sum, term));
    }
    Layout::Row(row)
}

fn product(factors: &[Formula]) -> Layout {
    let mut row = Vec::new();
    for (at, factor) in factors.iter().enumerate() {
        if at > 0 {
            row.push(Layout::Operator(if starts_with_digit(factor) { Operator::Dot } else { Operator::Times }));
        }
        row.push(unless(factor.binding() <= Binding::Sum, factor));
    }
    Layout::Row(row)
}

/// A function with a prime for each derivative.
fn primed(function: Layout, order: u8) -> Layout {
    match order {
        0 => function,
        _ => {
            let primes = (0..order).map(|_| Layout::Operator(Operator::Prime)).collect();
            Layout::Superscript(function.into(), Layout::Row(primes).into())
        }
    }
}

fn starts_with_digit(formula: &Formula) -> bool {
    match formula {
        Formula::Number(_) => true,
        Formula::Power(base, _) => starts_with_digit(base),
        _ => false,
    }
}

fn power(base: &Formula, exponent: &Formula) -> Layout {
    match (base, exponent) {
        // sin^2 x, as the books write it.
        (Formula::Call(function, argument), Formula::Number(_)) if is_wave(*function) => {
            let name = Layout::Function(function_name(*function));
            call(Layout::Superscript(name.into(), layout(exponent).into()), argument)
        }
        (Formula::Call(function, _), _) if *function != Function::Abs => {
            Layout::Superscript(parentheses(base).into(), layout(exponent).into())
        }
        (Formula::Table(..), _) => Layout::Superscript(parentheses(base).into(), layout(exponent).into()),
        _ => {
            let in_parentheses =
                base.binding() < Binding::Atom || matches!(base, Formula::Root(..) | Formula::Atan2(..));
            Layout::Superscript(unless(in_parentheses, base).into(), layout(exponent).into())
        }
    }
}

fn is_wave(function: Function) -> bool {
    use Function::*;
    matches!(function, Sin | Cos | Tan | Sinh | Cosh | Tanh)
}

/// A function before its argument, which needs no parentheses if it is one letter.
fn call(function: Layout, argument: &Formula) -> Layout {
    let argument = unless(!matches!(argument, Formula::Name(_)), argument);
    Layout::Row(vec![function, Layout::Operator(Operator::Apply), argument])
}

fn function_name(function: Function) -> &'static str {
    match function {
        Function::Asin => "arcsin",
        Function::Acos => "arccos",
        Function::Atan => "arctan",
        Function::Sign => "sgn",
        function => function.name(),
    }
}

fn euler() -> Layout {
    Layout::Word("e".into(), false)
}

/// The formula, in parentheses if it needs them.
fn unless(in_parentheses: bool, formula: &Formula) -> Layout {
    if in_parentheses { parentheses(formula) } else { layout(formula) }
}

fn parentheses(formula: &Formula) -> Layout {
    Layout::Parentheses(layout(formula).into())
}

fn word(name: &Name) -> Layout {
    let set = &name.set;
    let base = Layout::Word(set.base.clone(), set.bold);
    let dotted = match set.dots {
        0 => base,
        dots => Layout::Dots(base.into(), dots),
    };
    match set.indices.as_slice() {
        [] => dotted,
        indices => {
            let index = |text: &String| match text.starts_with(|c: char| c.is_ascii_digit()) {
                true => Layout::Number(text.clone()),
                false => Layout::Word(text.clone(), false),
            };
            Layout::Subscript(dotted.into(), indices.iter().map(index).collect())
        }
    }
}
