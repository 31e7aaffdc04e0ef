//! Infix text, in the notation of the language.

use super::formula::{Binding, Formula};
use crate::symbolic::Constant;

/// The formula with the fewest parentheses.
pub(super) fn text(formula: &Formula) -> String {
    match formula {
        Formula::Number(digits) => digits.clone(),
        Formula::Constant(Constant::Pi) => "pi".into(),
        Formula::Constant(Constant::E) => "e".into(),
        Formula::Name(name) => name.text.clone(),
        Formula::Sum(terms) => sum(terms, true),
        Formula::Product(factors) => {
            factors.iter().map(|factor| bound(factor, Binding::Power)).collect::<Vec<_>>().join("*")
        }
        Formula::Quotient(above, below) => {
            format!("{}/{}", bound(above, Binding::Product), bound(below, Binding::Power))
        }
        Formula::Power(base, exponent) => format!("{}^{}", bound(base, Binding::Atom), bound(exponent, Binding::Atom)),
        Formula::Root(radicand, degree) if degree == "2" => format!("sqrt({})", text(radicand)),
        Formula::Root(radicand, degree) => format!("{}^(1/{degree})", bound(radicand, Binding::Atom)),
        Formula::Call(function, argument) => format!("{}({})", function.name(), text(argument)),
        Formula::Atan2(y, x) => format!("atan2({}, {})", text(y), text(x)),
        Formula::Table(name, order, argument) => {
            format!("{}{}({})", name.text, "'".repeat((*order).into()), text(argument))
        }
        Formula::Choice(difference, above, otherwise) => {
            let [difference, above, otherwise] = [difference, above, otherwise].map(|part| bound(part, Binding::Sum));
            format!("if {difference} > 0 then {above} else {otherwise}")
        }
        Formula::Transpose(name) => format!("transpose({})", name.text),
    }
}

/// Terms with their signs. Where the sum does not start here, the first sign is one between terms.
pub(super) fn sum(terms: &[(bool, Formula)], starts: bool) -> String {
    let mut out = String::new();
    for (at, (negative, term)) in terms.iter().enumerate() {
        out += match (starts && at == 0, at == 0, negative) {
            (true, _, true) => "-",
            (true, _, false) => "",
            (false, true, true) => "- ",
            (false, true, false) => "+ ",
            (false, false, true) => " - ",
            (false, false, false) => " + ",
        };
        out += &bound(term, Binding::Product);
    }
    out
}

fn bound(formula: &Formula, at_least: Binding) -> String {
    match formula.binding() >= at_least {
        true => text(formula),
        false => format!("({})", text(formula)),
    }
}
