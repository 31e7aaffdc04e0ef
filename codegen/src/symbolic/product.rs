//! Products in canonical form.
//!
//! `x^a x^b` become `x^(a+b)` only if both exponents are positive, or both negative, or x is never zero nor
//! infinite: `x^2/x` is not 0 at x = 0, and `x/x` is not 1 where x has a pole. Exponents in a product are
//! integers; fractional powers are atoms.

use super::{Expr, Graph, Node, Number};

/// The largest integer coefficient used to make the coefficients of a sum integers.
const LARGEST_INTEGER: f64 = 4e9;

/// The number that [`Graph::split_content`] takes out of a sum.
fn content(constant: &Number, terms: &[(Expr, Number)]) -> Number {
    let Some((_, first)) = terms.first() else { return constant.abs() };
    let (mut divisor, mut largest) = (constant.abs(), constant.to_f64().abs());
    for (_, coefficient) in terms {
        divisor = divisor.gcd(coefficient);
        largest = largest.max(coefficient.to_f64().abs());
        // The divisor of all is no greater, and the largest of all no smaller.
        if largest > LARGEST_INTEGER * divisor.to_f64() {
            return first.clone();
        }
    }
    if first.is_negative() { -&divisor } else { divisor }
}

impl Graph {
    /// The product of any number of factors; 1 for none.
    pub fn product(&mut self, factors: &[Expr]) -> Expr {
        let powers: Vec<_> = factors.iter().map(|factor| (*factor, 1)).collect();
        self.product_of_powers(&powers)
    }

    /// `a * b`.
    pub fn mul(&mut self, a: Expr, b: Expr) -> Expr {
        self.product(&[a, b])
    }

    /// `a / b`. Division by the number 0 stays in the expression, and evaluates as it does in `f64`.
    pub fn div(&mut self, a: Expr, b: Expr) -> Expr {
        self.product_of_powers(&[(a, 1), (b, -1)])
    }

    /// The product of integer powers.
    pub(super) fn product_of_powers(&mut self, powers: &[(Expr, i64)]) -> Expr {
        let mut coefficient = Number::ONE;
        let mut factors = self.split_and_merge(powers, &mut coefficient);
        // A power too large to write out may have met part of its inverse.
        if factors.iter().any(|(base, _)| matches!(self.node(*base), Node::Number(_) | Node::Product { .. })) {
            factors = self.split_and_merge(&factors, &mut coefficient);
        }
        match coefficient.is_zero() {
            true => self.zero(),
            false => self.canonical_product(coefficient, factors),
        }
    }

    /// Canonical factors; numbers go to the coefficient.
    fn split_and_merge(&mut self, powers: &[(Expr, i64)], coefficient: &mut Number) -> Vec<(Expr, i64)> {
        let mut factors = Vec::with_capacity(powers.len());
        for (base, exponent) in powers {
            self.collect_factors(*base, *exponent, coefficient, &mut factors);
        }
        self.merge_factors(factors)
    }

    /// Splits `base^exponent` into a number and powers of atoms.
    fn collect_factors(&mut self, base: Expr, exponent: i64, coefficient: &mut Number, factors: &mut Vec<(Expr, i64)>) {
        if exponent == 0 {
            return;
        }
        match self.node(base) {
            Node::Number(value) => match value.pow(exponent) {
                Some(value) => *coefficient = &*coefficient * &value,
                None => factors.push((base, exponent)),
            },
            Node::Product { coefficient: inner, factors: inner_factors } => {
                let is_small = inner_factors.iter().all(|(_, e)| e.checked_mul(exponent).is_some());
                let may_fold = is_small && self.may_distribute(inner_factors, exponent);
                match inner.pow(exponent).filter(|_| may_fold) {
                    Some(value) => {
                        *coefficient = &*coefficient * &value;
                        factors.extend(inner_factors.iter().map(|(b, e)| (*b, e * exponent)));
                    }
                    None => factors.push((base, exponent)),
                }
            }
            Node::Sum { .. } => {
                let (content, primitive) = self.split_content(base);
                match content.pow(exponent) {
                    Some(value) => {
                        *coefficient = &*coefficient * &value;
                        factors.push((primitive, exponent));
                    }
                    None => factors.push((base, exponent)),
                }
            }
            _ => factors.push((base, exponent)),
        }
    }

    /// Whether `(x^a y^b ..)^exponent` is `x^(a exponent) y^(b exponent) ..` everywhere: raising to a
    /// negative power turns a pole into a zero, which 0 * infinity would not.
    fn may_distribute(&self, factors: &[(Expr, i64)], exponent: i64) -> bool {
        exponent > 0 || factors.iter().all(|(base, e)| *e > 0 || self.facts(*base).nonzero)
    }

    /// A sum as a number times a sum with coprime integer coefficients, the first one positive; where these would be
    /// large, so that powers of the sum could leave the range of `f64`, times a sum whose first coefficient is 1.
    fn split_content(&mut self, sum: Expr) -> (Number, Expr) {
        if let Some(known) = self.contents.get(&sum) {
            return known.clone();
        }
        let split = self.find_content(sum);
        self.contents.insert(sum, split.clone());
        split
    }

    fn find_content(&mut self, sum: Expr) -> (Number, Expr) {
        let Node::Sum { constant, terms } = self.node(sum) else {
            return (Number::ONE, sum);
        };
        let content = content(constant, terms);
        match content.recip() {
            Some(inverse) if !content.is_one() => {
                let primitive = Node::Sum {
                    constant: constant * &inverse,
                    terms: terms.iter().map(|(term, c)| (*term, c * &inverse)).collect(),
                };
                (content, self.intern(primitive))
            }
            _ => (Number::ONE, sum),
        }
    }

    /// Merges powers of equal bases where that is sound, and sorts.
    fn merge_factors(&self, mut factors: Vec<(Expr, i64)>) -> Vec<(Expr, i64)> {
        // Positive before negative, so that neighbours of equal base and sign merge in one pass.
        factors.sort_by_key(|(base, exponent)| (*base, *exponent < 0));
        let mut merged: Vec<(Expr, i64)> = Vec::with_capacity(factors.len());
        for (base, exponent) in factors {
            if let Some((last, sum)) = merged.last_mut()
                && *last == base
                && ((*sum > 0) == (exponent > 0) || self.facts(base).invertible())
                && let Some(total) = sum.checked_add(exponent)
            {
                *sum = total;
                continue;
            }
            merged.push((base, exponent));
        }
        merged.retain(|(_, exponent)| *exponent != 0);
        merged
    }

    /// The node for a coefficient and factors already merged and sorted.
    pub(super) fn canonical_product(&mut self, coefficient: Number, factors: Vec<(Expr, i64)>) -> Expr {
        match factors.as_slice() {
            [] => self.number(coefficient),
            [(base, 1)] if coefficient.is_one() => *base,
            // A number distributes over a sum, so that a - (a + b) becomes -b.
            [(base, 1)] if matches!(self.node(*base), Node::Sum { .. }) => self.scale(&coefficient, *base),
            _ => self.intern(Node::Product { coefficient, factors: factors.into() }),
        }
    }
}
