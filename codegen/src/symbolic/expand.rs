//! Products of sums multiplied out.

use super::{Expr, Graph, Node, Number};

impl Graph {
    /// A sum with its products of sums multiplied out, if like terms then merge or cancel, and the result has at most
    /// `limit` terms.
    ///
    /// Multiplying out for its own sake costs operations and, where a difference is squared, digits.
    pub fn expand(&mut self, expr: Expr, limit: usize) -> Option<Expr> {
        let Node::Sum { constant, terms } = self.node(expr).clone() else { return None };
        let mut expanded = Vec::with_capacity(terms.len());
        for (term, coefficient) in &terms {
            self.multiply_out(*term, coefficient, limit, &mut expanded)?;
        }
        if expanded.len() == terms.len() {
            return None;
        }
        if !constant.is_zero() {
            expanded.push((self.one(), constant));
        }
        let before = expanded.len();
        let sum = self.linear_combination(&expanded);
        let after = match self.node(sum) {
            Node::Sum { constant, terms } => terms.len() + usize::from(!constant.is_zero()),
            _ => 1,
        };
        (after < before).then_some(sum)
    }

    /// Adds `coefficient * term` to `out` as terms without sums as factors; nothing if there would be too many.
    fn multiply_out(
        &mut self,
        term: Expr,
        coefficient: &Number,
        limit: usize,
        out: &mut Vec<(Expr, Number)>,
    ) -> Option<()> {
        let Some((sum, others, coefficient)) = self.split_at_sum(term, coefficient) else {
            out.push((term, coefficient.clone()));
            return (out.len() <= limit).then_some(());
        };
        let Node::Sum { constant, terms } = self.node(sum).clone() else { return None };
        if !constant.is_zero() {
            self.multiply_out(others, &(&coefficient * &constant), limit, out)?;
        }
        for (summand, weight) in &terms {
            let product = self.mul(others, *summand);
            self.multiply_out(product, &(&coefficient * weight), limit, out)?;
        }
        Some(())
    }

    /// `coefficient * term` as a sum, what else is multiplied, and a number; nothing if no sum is a factor.
    fn split_at_sum(&mut self, term: Expr, coefficient: &Number) -> Option<(Expr, Expr, Number)> {
        let (inner, mut factors) = match self.node(term).clone() {
            Node::Sum { .. } => return Some((term, self.one(), coefficient.clone())),
            Node::Product { coefficient, factors } => (coefficient, factors.into_vec()),
            _ => return None,
        };
        let is_sum = |base: Expr| matches!(self.node(base), Node::Sum { .. });
        let at = factors.iter().position(|(base, exponent)| *exponent == 1 && is_sum(*base))?;
        let (sum, _) = factors.remove(at);
        Some((sum, self.product_of_powers(&factors), coefficient * &inner))
    }
}
