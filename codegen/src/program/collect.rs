//! Sums with common factors taken out.
//!
//! Terms of equal variable part add their coefficients, which depend on parameters alone. Pairs of terms whose sum,
//! apart from common factors, exists already become one: beside `sin(a) cos(b) - cos(a) sin(b)` its multiples by
//! squares of speeds cost a multiplication each. Then the factor that most terms have in common is taken out, again and
//! again. Each step saves operations and costs nothing.

use super::values::{Operation, Value, Values};
use indexmap::IndexMap;
use rustc_hash::FxBuildHasher;
use std::cmp::Reverse;

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
fn factor(values: &mut Values, terms: Vec<Term>) -> Vec<(bool, Value)> {
    let mut terms = take_known_sums(values, terms);
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
    // In a fixed order, so that equal sums are one value.
    done.sort_by_key(|(_, value)| *value);
    done
}

/// Repeatedly merges two terms whose sum, apart from common factors, exists already.
fn take_known_sums(values: &Values, mut terms: Vec<Term>) -> Vec<Term> {
    // Pairs of terms up to here have no known sum, but for those of the term that was merged last.
    let (mut checked, mut merged) = (0, 0);
    while let Some((a, b, sum)) = first_known_sum(values, &terms, checked, merged) {
        terms.remove(b);
        terms[a] = sum;
        (checked, merged) = (b, a);
    }
    terms
}

/// The first pair of terms, by the second of them, whose sum exists. Among the first `checked` terms only pairs with the term
/// `merged` may be such.
fn first_known_sum(values: &Values, terms: &[Term], checked: usize, merged: usize) -> Option<(usize, usize, Term)> {
    for b in 1..terms.len() {
        for a in 0..b {
            let may_have_one = b >= checked || a == merged || b == merged;
            if may_have_one && let Some(sum) = known_sum(values, &terms[a], &terms[b]) {
                return Some((a, b, sum));
            }
        }
    }
    None
}

/// The sum of two terms with a factor in common, if the rest of both is added or subtracted somewhere.
fn known_sum(values: &Values, a: &Term, b: &Term) -> Option<Term> {
    if a.divisors != b.divisors || !a.factors.iter().any(|factor| b.factors.contains(factor)) {
        return None;
    }
    let (x, y) = (values.known_product(&a.factors, &b.factors)?, values.known_product(&b.factors, &a.factors)?);
    let is_difference = a.negative != b.negative;
    let sum = |x: Value, y: Value| values.find(&Operation::Sum(vec![(false, x), (is_difference, y)]));
    let (negative, sum) = sum(x, y).map(|sum| (a.negative, sum)).or_else(|| Some((b.negative, sum(y, x)?)))?;
    let common = a.factors.iter().filter(|factor| b.factors.contains(factor)).copied();
    Some(Term { negative, factors: common.chain([sum]).collect(), divisors: a.divisors.clone() })
}

/// Adds up those terms that are multiples of one value by parameters alone.
pub(super) fn add_multiples(values: &mut Values, terms: Vec<(bool, Value)>) -> Vec<(bool, Value)> {
    if terms.len() < 2 {
        return terms;
    }
    let mut multiples: Map<Value, Vec<(bool, Value)>> = Map::default();
    for (negative, term) in &terms {
        let (coefficient, value) = values.as_multiple(*term);
        multiples.entry(value).or_default().push((*negative, coefficient));
    }
    if multiples.len() == terms.len() {
        return terms;
    }
    let added = multiples.into_iter().map(|(value, coefficients)| {
        let coefficient = values.sum(coefficients);
        let product = values.product(vec![coefficient, value]);
        values.signed(product)
    });
    added.collect()
}

/// The common factor of several terms.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
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

/// The factor that most terms, at least two, have in common.
fn most_common(terms: &[Term]) -> Option<Common> {
    if terms.len() < 2 {
        return None;
    }
    // A term has a factor once: powers are values of their own.
    let common = |term: &Term| {
        let factors = term.factors.iter().map(|factor| Common::Factor(*factor));
        factors.chain(term.divisors.iter().map(|divisor| Common::Divisor(*divisor))).collect::<Vec<_>>()
    };
    let mut places: Vec<(Common, usize)> = terms.iter().flat_map(common).zip(0..).collect();
    places.sort_unstable();
    let several = places.chunk_by(|a, b| a.0 == b.0).filter(|equal| equal.len() > 1);
    // The first of those with the largest count.
    several.max_by_key(|equal| (equal.len(), Reverse(equal[0].1))).map(|equal| equal[0].0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::program::values::Input;

    fn inputs<const N: usize>(values: &mut Values) -> [Value; N] {
        std::array::from_fn(|i| values.add(Operation::Input(Input::Position(i))))
    }

    fn term(negative: bool, factors: &[Value]) -> Term {
        Term { negative, factors: factors.to_vec(), divisors: vec![] }
    }

    /// A value where the inputs are 2, 3, 5, ..
    fn evaluate(values: &Values, value: Value) -> f64 {
        let of = |value: &Value| evaluate(values, *value);
        match values.operation(value) {
            Operation::Constant(bits) => f64::from_bits(*bits),
            Operation::Input(Input::Position(i)) => [2.0, 3.0, 5.0, 7.0, 11.0, 13.0][*i],
            Operation::Input(Input::Parameter(i)) => [17.0, 19.0, 23.0][*i],
            Operation::Sum(terms) => terms.iter().map(|(minus, x)| if *minus { -of(x) } else { of(x) }).sum(),
            Operation::Product(factors) => factors.iter().map(of).product(),
            Operation::Negate(inner) => -of(inner),
            other => panic!("{other:?}"),
        }
    }

    #[test]
    fn a_difference_that_is_there_is_found_in_others_either_way_round() {
        for negative in [false, true] {
            let mut values = Values::default();
            let [a, b, c, d, u, v] = inputs(&mut values);
            let (first, second) = (values.product(vec![a, b]), values.product(vec![c, d]));
            let difference = values.sum(vec![(false, first), (true, second)]);
            // Otherwise u would be taken out of three terms, and a out of two of these.
            let terms = vec![term(negative, &[a, b, u]), term(!negative, &[c, d, u]), term(false, &[a, u, v])];
            let sum = collect(&mut values, terms);
            assert!(values.reachable(&[sum], &Default::default()).contains(&difference));
            let sign = if negative { -1.0 } else { 1.0 };
            assert_eq!(evaluate(&values, sum), sign * (2.0 * 3.0 - 5.0 * 7.0) * 11.0 + 2.0 * 11.0 * 13.0);
        }
    }

    #[test]
    fn equal_sums_are_one_value_whatever_the_order_of_their_terms() {
        let mut values = Values::default();
        let [a, b, c] = inputs(&mut values);
        let one = collect(&mut values, vec![term(false, &[a]), term(true, &[b]), term(false, &[c])]);
        let other = collect(&mut values, vec![term(false, &[c]), term(false, &[a]), term(true, &[b])]);
        assert_eq!(one, other);
    }

    #[test]
    fn multiples_by_parameters_are_added_up() {
        let mut values = Values::default();
        let [x, y] = inputs(&mut values);
        let [p, q, r] = std::array::from_fn(|i| values.add(Operation::Input(Input::Parameter(i))));
        let (by_p, by_q) = (values.product(vec![p, x]), values.product(vec![q, x]));
        let by_r = values.product(vec![r, by_q]);
        let added = add_multiples(&mut values, vec![(false, by_p), (false, y), (true, by_r)]);
        assert_eq!(added.len(), 2);
        let sum = values.sum(added);
        assert_eq!(evaluate(&values, sum), (17.0 - 19.0 * 23.0) * 2.0 + 3.0);
    }
}
