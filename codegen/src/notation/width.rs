//! The approximate width of a typeset formula in letters, never much too small.

use super::formula::Formula;
use super::names::Name;
use super::{greek, infix};

/// The width in two dimensions.
pub(super) fn set_width(formula: &Formula) -> usize {
    match formula {
        Formula::Number(digits) => digits.len(),
        Formula::Constant(_) => 1,
        Formula::Name(name) => name_width(name),
        Formula::Sum(terms) => terms.iter().map(|(_, term)| set_width(term) + 3).sum(),
        Formula::Product(factors) => factors.iter().map(|factor| set_width(factor) + 1).sum(),
        Formula::Quotient(above, below) => set_width(above).max(set_width(below)) + 1,
        Formula::Power(base, exponent) => set_width(base) + set_width(exponent),
        Formula::Root(radicand, _) => set_width(radicand) + 2,
        Formula::Call(_, argument) => set_width(argument) + 4,
        Formula::Atan2(y, x) => set_width(y) + set_width(x) + 8,
        Formula::Table(name, order, argument) => name_width(name) + usize::from(*order) + set_width(argument) + 2,
        Formula::Choice(difference, above, otherwise) => {
            set_width(above).max(set_width(otherwise)) + set_width(difference) + 10
        }
        Formula::Transpose(name) => name_width(name) + 1,
    }
}

/// The length as text.
pub(super) fn text_width(formula: &Formula) -> usize {
    infix::text(formula).chars().count()
}

fn name_width(name: &Name) -> usize {
    let word = |word: &String| if greek::letter(word).is_some() { 1 } else { word.chars().count() };
    word(&name.set.base) + name.set.indices.iter().map(word).sum::<usize>()
}
