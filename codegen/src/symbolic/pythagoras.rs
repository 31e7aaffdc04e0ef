//! `a R sin(u)^2 + b R cos(u)^2 = b R + (a - b) R sin(u)^2`, for numbers a and b and any product R.
//!
//! The cosine is always the one that goes, so the form is unique.

use super::{Expr, Function, Graph, Node, Number};

impl Graph {
    /// Removes every squared cosine that stands beside its sine in merged terms. `None` if there is none.
    ///
    /// Sine and cosine are bounded, so no value changes, wherever u and R are defined. Elsewhere the
    /// difference is that of `x - x`.
    pub(super) fn fold_squares(&mut self, terms: &[(Expr, Number)]) -> Option<Vec<(Expr, Number)>> {
        let mut folded = None::<Vec<(Expr, Number)>>;
        for (term, _) in terms {
            for (argument, rest) in self.split_squares(Function::Sin, *term) {
                if !terms.iter().any(|(other, _)| self.has_square(Function::Cos, argument, *other)) {
                    continue;
                }
                let cosine = self.call(Function::Cos, argument);
                let mut with_cosine = rest.clone();
                with_cosine.push((cosine, 2));
                let partner = self.product_of_powers(&with_cosine);
                let current = folded.as_deref().unwrap_or(terms);
                let find = |wanted: Expr| current.iter().position(|(term, c)| *term == wanted && !c.is_zero());
                let (Some(at_sine), Some(at_cosine)) = (find(*term), find(partner)) else { continue };
                let mut next = current.to_vec();
                let b = next[at_cosine].1.clone();
                next[at_sine].1 = &next[at_sine].1 - &b;
                next[at_cosine] = (self.product_of_powers(&rest), b);
                folded = Some(next);
            }
        }
        folded
    }

    /// All readings of a term as `function(argument)^2 * rest`.
    fn split_squares(&self, function: Function, term: Expr) -> Vec<(Expr, Vec<(Expr, i64)>)> {
        let without = |factors: &[(Expr, i64)], at: usize| {
            let mut rest = factors.to_vec();
            rest[at].1 -= 2;
            rest.retain(|(_, exponent)| *exponent != 0);
            rest
        };
        let Node::Product { factors, .. } = self.node(term) else { return vec![] };
        let squares = factors.iter().enumerate().filter_map(|(at, factor)| Some((at, self.square(function, factor)?)));
        squares.map(|(at, argument)| (argument, without(factors, at))).collect()
    }

    fn has_square(&self, function: Function, argument: Expr, term: Expr) -> bool {
        let Node::Product { factors, .. } = self.node(term) else { return false };
        factors.iter().any(|factor| self.square(function, factor) == Some(argument))
    }

    /// The argument, if the factor is at least the square of the function.
    fn square(&self, function: Function, (base, exponent): &(Expr, i64)) -> Option<Expr> {
        match self.node(*base) {
            Node::Call(f, argument) if *f == function && *exponent >= 2 => Some(*argument),
            _ => None,
        }
    }
}
