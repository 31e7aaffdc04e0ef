//! Products of sums multiplied out.

use super::{Expr, Graph, Node, Number};

impl Graph {
    /// A sum with the products in it multiplied out as far as they have sums as factors, if like terms then merge or
    /// cancel, and no more than `limit` terms come of it.
    ///
    /// Multiplying out for its own sake costs operations and, where a difference is squared, digits.
    pub fn expand(&mut self, expr: Expr, limit: usize) -> Option<Expr> {
        let Node::Sum { constant, terms } = self.node(expr).clone() else { return None };
        let mut expanded = Vec::with_capacity(terms.len());
        for (term, coefficient) in &terms {
            self.multiply_out(*term, coefficient, limit, &mut expanded)?;
        }
        let before = expanded.len();
        if before == terms.len() {
            return None;
        }
        let one = self.one();
        expanded.push((one, constant));
        let sum = self.linear_combination(&expanded);
        let after = match self.node(sum) {
            Node::Sum { terms, .. } => terms.len(),
            _ => 1,
        };
        (after < before).then_some(sum)
    }

    /// Adds `coefficient * term` to `out` as terms without sums as factors; nothing if that would make too many.
    fn multiply_out(
        &mut self,
        term: Expr,
        coefficient: &Number,
        limit: usize,
        out: &mut Vec<(Expr, Number)>,
    ) -> Option<()> {
        let sum = match self.node(term) {
            Node::Product { factors, .. } => factors
                .iter()
                .position(|(base, exponent)| *exponent == 1 && matches!(self.node(*base), Node::Sum { .. })),
            _ => None,
        };
        let (Some(at), Node::Product { coefficient: inner, factors }) = (sum, self.node(term).clone()) else {
            out.push((term, coefficient.clone()));
            return (out.len() <= limit).then_some(());
        };
        let mut others = factors.to_vec();
        let (sum, _) = others.remove(at);
        let others = self.product_of_powers(&others);
        let coefficient = coefficient * &inner;
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
}
