//! Sums with common factors taken out.
//!
//! Terms of equal variable part add their coefficients, which depend on parameters alone; then the factor that most
//! terms have in common is taken out, again and again. Each step saves multiplications and costs nothing.

use super::values::{Value, Values};
use indexmap::IndexMap;
use rustc_hash::FxBuildHasher;

/// A term of a sum: `factors / divisors`.
pub(super) struct Term {
    /// Whether it is subtracted.
    pub(super) negative: bool,
    /// Factors, of which those that depend on parameters alone make the coefficient.
    pub(super) factors: Vec<Value>,
    /// Divisors.
    pub(super) divisors: Vec<Value>,
}

type Map<K, V> = IndexMap<K, V, FxBuildHasher>;
/// The factors and divisors that vary.
type VariablePart = (Vec<Value>, Vec<Value>);

/// The sum of terms.
pub(super) fn collect(values: &mut Values, terms: Vec<Term>) -> Value {
    let terms = merge(values, terms);
    let terms = factor(values, terms);
    values.sum(terms)
}

/// Adds the coefficients of terms of equal variable part.
fn merge(values: &mut Values, terms: Vec<Term>) -> Vec<Term> {
    let mut coefficients: Map<VariablePart, Vec<(bool, Value)>> = Map::default();
    for term in terms {
        let (parametric, mut factors): (Vec<_>, Vec<_>) =
            term.factors.into_iter().partition(|factor| values.is_parametric(*factor));
        factors.sort();
        let coefficient = values.product(parametric);
        coefficients.entry((factors, term.divisors)).or_default().push((term.negative, coefficient));
    }
    let merged = coefficients.into_iter().map(|((mut factors, divisors), coefficients)| {
        let coefficient = values.sum(coefficients);
        let (negative, size) = values.signed(coefficient);
        if !values.is_constant(size, 1.0) {
            factors.insert(0, size);
        }
        Term { negative, factors, divisors }
    });
    merged.collect()
}

/// Takes out the factor or divisor that most terms have in common, for as long as there is one.
fn factor(values: &mut Values, mut terms: Vec<Term>) -> Vec<(bool, Value)> {
    let mut done = Vec::new();
    while let Some(common) = most_common(&terms) {
        let (mut inside, mut outside) = (vec![], vec![]);
        for term in terms {
            if common.is_in(&term) { inside.push(term) } else { outside.push(term) }
        }
        inside.iter_mut().for_each(|term| common.take_out_of(term));
        let inside = factor(values, inside);
        let inside = values.sum(inside);
        let together = match common {
            Common::Factor(factor) => values.product(vec![factor, inside]),
            Common::Divisor(divisor) => values.quotient(inside, divisor),
        };
        done.push(values.signed(together));
        terms = outside;
    }
    for term in terms {
        let (above, below) = (values.product(term.factors), values.product(term.divisors));
        done.push((term.negative, values.quotient(above, below)));
    }
    done
}

/// What several terms have in common.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
enum Common {
    Factor(Value),
    Divisor(Value),
}

impl Common {
    fn is_in(self, term: &Term) -> bool {
        match self {
            Common::Factor(factor) => term.factors.contains(&factor),
            Common::Divisor(divisor) => term.divisors.contains(&divisor),
        }
    }

    fn take_out_of(self, term: &mut Term) {
        let (list, value) = match self {
            Common::Factor(factor) => (&mut term.factors, factor),
            Common::Divisor(divisor) => (&mut term.divisors, divisor),
        };
        if let Some(at) = list.iter().position(|each| *each == value) {
            list.remove(at);
        }
    }
}

/// What most terms have in common; at least two.
fn most_common(terms: &[Term]) -> Option<Common> {
    if terms.len() < 2 {
        return None;
    }
    let mut counts: Map<Common, usize> = Map::default();
    for term in terms {
        // A term has a factor once: powers are values of their own.
        let factors = term.factors.iter().map(|factor| Common::Factor(*factor));
        let divisors = term.divisors.iter().map(|divisor| Common::Divisor(*divisor));
        factors.chain(divisors).for_each(|common| *counts.entry(common).or_default() += 1);
    }
    // The first of those with the largest count.
    let largest = counts.values().copied().max().filter(|count| *count > 1)?;
    counts.into_iter().find(|(_, count)| *count == largest).map(|(common, _)| common)
}
