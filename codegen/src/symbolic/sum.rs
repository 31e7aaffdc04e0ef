//! Sums in canonical form.

use super::{Expr, Graph, Node, Number};

impl Graph {
    /// The sum of any number of terms; 0 for none.
    pub fn sum(&mut self, terms: &[Expr]) -> Expr {
        let weighted: Vec<_> = terms.iter().map(|term| (*term, Number::ONE)).collect();
        self.linear_combination(&weighted)
    }

    /// `a + b`.
    pub fn add(&mut self, a: Expr, b: Expr) -> Expr {
        self.sum(&[a, b])
    }

    /// `a - b`.
    pub fn sub(&mut self, a: Expr, b: Expr) -> Expr {
        self.linear_combination(&[(a, Number::ONE), (b, Number::MINUS_ONE)])
    }

    /// `-a`.
    pub fn neg(&mut self, a: Expr) -> Expr {
        self.linear_combination(&[(a, Number::MINUS_ONE)])
    }

    /// `coefficient * a`.
    pub fn scale(&mut self, coefficient: &Number, a: Expr) -> Expr {
        self.linear_combination(&[(a, coefficient.clone())])
    }

    /// The sum of `coefficient * expression`.
    pub fn linear_combination(&mut self, weighted: &[(Expr, Number)]) -> Expr {
        let mut constant = Number::ZERO;
        let mut terms = Vec::with_capacity(weighted.len());
        for (expr, weight) in weighted {
            if !weight.is_zero() {
                self.collect_terms(*expr, weight, &mut constant, &mut terms);
            }
        }
        let terms = merge(terms);
        let terms = match self.fold_squares(&terms) {
            Some(folded) => return self.linear_combination_with(constant, &folded),
            None => terms,
        };
        self.canonical_sum(constant, terms)
    }

    fn linear_combination_with(&mut self, constant: Number, weighted: &[(Expr, Number)]) -> Expr {
        let one = self.one();
        let mut all = weighted.to_vec();
        all.push((one, constant));
        self.linear_combination(&all)
    }

    /// Splits `weight * expr` into a number and terms of coefficient one.
    fn collect_terms(&mut self, expr: Expr, weight: &Number, constant: &mut Number, terms: &mut Vec<(Expr, Number)>) {
        match self.node(expr) {
            Node::Number(value) => *constant = &*constant + &(value * weight),
            Node::Sum { constant: inner, terms: inner_terms } => {
                *constant = &*constant + &(inner * weight);
                terms.extend(inner_terms.iter().map(|(term, c)| (*term, c * weight)));
            }
            Node::Product { coefficient, factors } if !coefficient.is_one() => {
                let (weight, factors) = (coefficient * weight, factors.to_vec());
                terms.push((self.canonical_product(Number::ONE, factors), weight));
            }
            _ => terms.push((expr, weight.clone())),
        }
    }

    /// The node for terms already merged and sorted.
    fn canonical_sum(&mut self, constant: Number, terms: Vec<(Expr, Number)>) -> Expr {
        match terms.as_slice() {
            [] => self.number(constant),
            [(term, weight)] if constant.is_zero() => self.weighted_term(*term, weight.clone()),
            _ => self.intern(Node::Sum { constant, terms: terms.into() }),
        }
    }

    /// `weight * term` for a term of coefficient one that is no sum.
    fn weighted_term(&mut self, term: Expr, weight: Number) -> Expr {
        if weight.is_one() {
            return term;
        }
        let factors = match self.node(term) {
            Node::Product { factors, .. } => factors.to_vec(),
            _ => vec![(term, 1)],
        };
        self.canonical_product(weight, factors)
    }
}

/// Adds the weights of equal terms, drops what cancels, and sorts.
fn merge(mut terms: Vec<(Expr, Number)>) -> Vec<(Expr, Number)> {
    terms.sort_by_key(|(term, _)| *term);
    terms.dedup_by(|(term, weight), (last, sum)| {
        let is_equal = term == last;
        if is_equal {
            *sum = &*sum + &*weight;
        }
        is_equal
    });
    terms.retain(|(_, weight)| !weight.is_zero());
    terms
}
