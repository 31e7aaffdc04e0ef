//! `a R sin(u)^2 + b R cos(u)^2 = b R + (a - b) R sin(u)^2`, for numbers a and b and any product R.

use super::{Expr, Function, Graph, Node, Number};

impl Graph {
    /// Removes every squared cosine that stands beside its sine in merged terms. `None` if there is none.
    ///
    /// Sine and cosine are bounded, so no value changes, wherever R is defined.
    pub(super) fn fold_squares(&mut self, terms: &[(Expr, Number)]) -> Option<Vec<(Expr, Number)>> {
        let mut folded = None::<Vec<(Expr, Number)>>;
        for (term, _) in terms {
            let Some((argument, rest)) = self.split_square(Function::Sin, *term) else { continue };
            let with_cosine = |(other, _): &(Expr, Number)| {
                self.split_square(Function::Cos, *other).is_some_and(|(angle, _)| angle == argument)
            };
            if !terms.iter().any(with_cosine) {
                continue;
            }
            let cosine = self.call(Function::Cos, argument);
            let mut with_cosine = rest.clone();
            with_cosine.push((cosine, 2));
            let partner = self.product_of_powers(&with_cosine);
            let current = folded.as_deref().unwrap_or(terms);
            let find = |wanted: Expr| current.iter().position(|(term, _)| *term == wanted);
            let (Some(at_sine), Some(at_cosine)) = (find(*term), find(partner)) else { continue };
            let mut next = current.to_vec();
            let b = next[at_cosine].1.clone();
            next[at_sine].1 = &next[at_sine].1 - &b;
            next[at_cosine] = (self.product_of_powers(&rest), b);
            folded = Some(next);
        }
        folded
    }

    /// Reads a term as `function(argument)^2 * rest`.
    fn split_square(&self, function: Function, term: Expr) -> Option<(Expr, Vec<(Expr, i64)>)> {
        let Node::Product { factors, .. } = self.node(term) else { return None };
        let (at, argument) = factors.iter().enumerate().find_map(|(at, (base, exponent))| match self.node(*base) {
            Node::Call(f, argument) if *f == function && *exponent >= 2 => Some((at, *argument)),
            _ => None,
        })?;
        let mut rest = factors.to_vec();
        rest[at].1 -= 2;
        rest.retain(|(_, exponent)| *exponent != 0);
        Some((argument, rest))
    }
}
