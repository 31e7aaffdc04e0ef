//! Expressions as text, for messages: spaced as in the documents, with the fewest parentheses.

use super::{Comparison, Expression, Kind, Operator};
use std::fmt::{Display, Formatter, Result};

/// The precedence of an expression in the parser.
#[derive(Clone, Copy, PartialEq, PartialOrd)]
enum Binding {
    Choice,
    Sum,
    Product,
    Sign,
    Power,
    Atom,
}

impl Display for Expression {
    fn fmt(&self, f: &mut Formatter) -> Result {
        match &self.kind {
            Kind::Number { literal, unit: None } => write!(f, "{literal}"),
            Kind::Number { literal, unit: Some(unit) } => write!(f, "{literal} [{}]", unit.text),
            Kind::Name(name) => write!(f, "{name}"),
            Kind::Vector(components) => write!(f, "[{}]", list(components)),
            Kind::Call(function, arguments) => write!(f, "{function}({})", list(arguments)),
            Kind::Component(vector, name) => write!(f, "{}.{name}", within(vector, Binding::Atom)),
            Kind::Attitude(body, _) => write!(f, "attitude({body})"),
            Kind::If(choice) => {
                let sign = match choice.comparison {
                    Comparison::Greater => ">",
                    Comparison::Less => "<",
                    Comparison::AtLeast => ">=",
                    Comparison::AtMost => "<=",
                };
                write!(f, "if {} {sign} {} then {} else {}", choice.left, choice.right, choice.yes, choice.no)
            }
            Kind::Negate(operand) => write!(f, "-{}", within(operand, Binding::Sign)),
            Kind::Binary(operator, left, right) => {
                let (sign, at_left, at_right) = match operator {
                    Operator::Add => (" + ", Binding::Sum, Binding::Product),
                    Operator::Subtract => (" - ", Binding::Sum, Binding::Product),
                    Operator::Multiply => ("*", Binding::Product, Binding::Sign),
                    Operator::Divide => ("/", Binding::Product, Binding::Sign),
                    Operator::Power => ("^", Binding::Atom, Binding::Sign),
                };
                write!(f, "{}{sign}{}", within(left, at_left), within(right, at_right))
            }
        }
    }
}

fn list(expressions: &[Expression]) -> String {
    expressions.iter().map(Expression::to_string).collect::<Vec<_>>().join(", ")
}

fn within(expression: &Expression, least: Binding) -> String {
    if binding(expression) < least { format!("({expression})") } else { expression.to_string() }
}

fn binding(expression: &Expression) -> Binding {
    match &expression.kind {
        Kind::If(_) => Binding::Choice,
        Kind::Binary(Operator::Add | Operator::Subtract, ..) => Binding::Sum,
        Kind::Binary(Operator::Multiply | Operator::Divide, ..) => Binding::Product,
        Kind::Binary(Operator::Power, ..) => Binding::Power,
        Kind::Negate(_) => Binding::Sign,
        _ => Binding::Atom,
    }
}

impl Expression {
    /// Its text, with the middle left out if it is long.
    pub fn excerpt(&self) -> String {
        let text: Vec<char> = self.to_string().chars().collect();
        match text.len() {
            0..=48 => text.iter().collect(),
            len => text[..28].iter().chain(&[' ', '.', '.', ' ']).chain(&text[len - 16..]).collect(),
        }
    }

    /// The names in it, in order; `reaction(c)` counts as one.
    pub fn names(&self) -> Vec<&Expression> {
        match &self.kind {
            Kind::Name(_) => vec![self],
            Kind::Call(function, _) if function == "reaction" => vec![self],
            _ => self.parts().into_iter().flat_map(Expression::names).collect(),
        }
    }
}
