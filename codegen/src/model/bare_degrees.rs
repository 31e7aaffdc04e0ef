//! Bare numbers for angles in degrees or revolutions: they are in radians, which is hardly meant.

use super::Unit;
use super::blame::bare_number;
use super::interpreter::Interpreter;
use super::origin::Origin;
use super::plain::is_plain;
use super::scope::plain;
use crate::dsl::{Expression, Kind, Operator};
use syn::Ident;

/// Functions of quantities that are in the unit of these.
const KEEPING: [&str; 3] = ["abs", "min", "max"];

/// Functions whose values are no angles.
const WITHOUT_UNIT: [&str; 9] = ["sin", "cos", "tan", "sinh", "cosh", "tanh", "exp", "ln", "sign"];

impl Interpreter {
    /// Refuses a bare number beside an angle in degrees or revolutions, in vectors component by component.
    pub(super) fn refuse_bare_beside(&mut self, angle: &Expression, number: &Expression) -> Option<()> {
        for component in 0..3 {
            if let Some(bare) = bare_term(number, component)
                && let Some((unit, claim)) = self.in_degrees(angle, component)
            {
                return self.refuse_bare(bare, &unit, &claim);
            }
        }
        Some(())
    }

    /// Refuses a bare number in a place for degrees or revolutions; `claim` says which: "table `f` is over [deg]".
    pub(super) fn refuse_bare_in(&mut self, number: &Expression, unit: &Unit, claim: &str) -> Option<()> {
        match bare_term(number, 0) {
            Some(bare) if is_in_degrees(unit.text()) => self.refuse_bare(bare, unit.text(), claim),
            _ => Some(()),
        }
    }

    fn refuse_bare(&mut self, number: &Expression, unit: &str, claim: &str) -> Option<()> {
        let text = number.excerpt();
        let with = |unit: &str| match number.kind {
            Kind::Number { .. } => format!("`{text} [{unit}]`"),
            _ => format!("`({text})*1 [{unit}]`"),
        };
        let message = format!("{claim}, and `{text}` is in radians; write {} or {}", with(unit), with("rad"));
        self.refuse(number.region, message)
    }

    /// The unit of what a quantity is made of, a name or a number in degrees or revolutions, and the words for it.
    fn in_degrees(&self, quantity: &Expression, component: usize) -> Option<(String, String)> {
        find_term(quantity, component, &|term| match &term.kind {
            Kind::Name(name) => match self.origins.get(&plain(name)) {
                Some(Origin::Declared(Some(unit))) if is_in_degrees(unit) => {
                    Some((unit.clone(), format!("`{name}` is declared in [{unit}]")))
                }
                _ => None,
            },
            Kind::Number { unit: Some(unit), .. } if is_in_degrees(&unit.text) => {
                Some((unit.text.clone(), format!("`{}` is in [{}]", term.excerpt(), unit.text)))
            }
            Kind::Binary(Operator::Multiply, factor, angle) if is_plain(factor) => self.in_degrees(angle, component),
            Kind::Binary(Operator::Multiply | Operator::Divide, angle, factor) if is_plain(factor) => {
                self.in_degrees(angle, component)
            }
            _ => None,
        })
    }
}

/// Whether a unit is one of angles, and another than the radian: `deg`, `rev`, `mrad`.
fn is_in_degrees(unit: &str) -> bool {
    let is_name = unit.chars().all(char::is_alphabetic);
    is_name && unit != "rad" && ["deg", "rev", "rad"].iter().any(|angle| unit.ends_with(angle))
}

fn is_any_of(function: &Ident, names: &[&str]) -> bool {
    names.iter().any(|name| function == name)
}

/// What is found first in a part of a quantity that is in its unit: in a term of a sum, in a value of a choice.
fn find_term<'e, T>(
    quantity: &'e Expression,
    component: usize,
    find: &dyn Fn(&'e Expression) -> Option<T>,
) -> Option<T> {
    let within = |part| find_term(part, component, find);
    match &quantity.kind {
        Kind::Vector(components) => components.get(component).and_then(within),
        Kind::Negate(operand) => within(operand),
        Kind::Binary(Operator::Add | Operator::Subtract, left, right) => within(left).or_else(|| within(right)),
        Kind::Call(function, arguments) if is_any_of(function, &KEEPING) => arguments.iter().find_map(within),
        Kind::If(choice) => within(&choice.yes).or_else(|| within(&choice.no)),
        _ => find(quantity),
    }
}

/// The number without a unit that is a term of a quantity, or determines the size of one.
fn bare_term(quantity: &Expression, component: usize) -> Option<&Expression> {
    find_term(quantity, component, &|term| if is_of_bare_numbers(term) { size(term) } else { None })
}

/// Whether an expression is made of bare numbers, and of functions whose values are no angles. `pi` and `e` are not
/// bare: `2*pi` is plainly in radians.
fn is_of_bare_numbers(expression: &Expression) -> bool {
    match &expression.kind {
        Kind::Number { unit, .. } => unit.is_none(),
        Kind::Call(function, _) if is_any_of(function, &WITHOUT_UNIT) => true,
        Kind::Call(function, arguments) if function == "sqrt" || is_any_of(function, &KEEPING) => {
            arguments.iter().all(is_of_bare_numbers)
        }
        Kind::Negate(operand) => is_of_bare_numbers(operand),
        Kind::Binary(_, left, right) => is_of_bare_numbers(left) && is_of_bare_numbers(right),
        Kind::If(choice) => is_of_bare_numbers(&choice.yes) && is_of_bare_numbers(&choice.no),
        _ => false,
    }
}

/// What determines the size of an expression of bare numbers: a factor other than 0, or all of it where a unit cannot
/// stand at one number.
fn size(expression: &Expression) -> Option<&Expression> {
    match &expression.kind {
        Kind::Number { .. } => bare_number(expression).map(|(number, _)| number),
        Kind::Negate(operand) => size(operand),
        Kind::Binary(Operator::Multiply, left, right) => size(left).or_else(|| size(right)),
        Kind::Binary(Operator::Divide, left, right) => size(left).or_else(|| size(right).map(|_| expression)),
        Kind::Binary(Operator::Power, base, _) => size(base).map(|_| expression),
        Kind::Call(function, _) if is_any_of(function, &WITHOUT_UNIT) => None,
        _ => expression.parts().into_iter().find_map(size).map(|_| expression),
    }
}
