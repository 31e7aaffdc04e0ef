//! Products that vanish with a length, as |v| v of a drag does at rest.
//!
//! There the derivative is 0, but by the product rule it would be 0 times the slope of the length, which has none: NaN. So such a
//! product is written as a choice, which is 0 there.

use super::{Expr, Graph, Node};

impl Graph {
    /// A product in which a length and a component of the same vector are factors, with a derivative where the vector is 0;
    /// `None` if they are not.
    pub fn vanishing(&mut self, product: Expr, length: Expr, component: Expr) -> Option<Expr> {
        let Node::Power { base: square, .. } = *self.node(length) else { return None };
        let Node::Product { coefficient, mut factors } = self.node(product).clone() else { return None };
        let pair = self.mul(length, component);
        let Node::Product { factors: needed, .. } = self.node(pair).clone() else { return None };
        for (base, exponent) in &needed {
            let (_, rest) = factors.iter_mut().find(|(factor, e)| factor == base && 0 < *exponent && exponent <= e)?;
            *rest -= exponent;
        }
        let (pair, zero) = (self.product_of_powers(&needed), self.zero());
        let smooth = self.choice(square, pair, zero);
        let others = factors.iter().filter(|(_, exponent)| *exponent != 0).copied();
        let rest = self.product_of_powers(&others.chain([(smooth, 1)]).collect::<Vec<_>>());
        Some(self.scale(&coefficient, rest))
    }

    /// The product that such a choice stands for.
    pub fn vanishing_product(&self, expr: Expr) -> Option<Expr> {
        let Node::Choice(difference, product, otherwise) = self.node(expr) else { return None };
        let Node::Product { factors, .. } = self.node(*product) else { return None };
        let is_length = |base: &Expr| matches!(self.node(*base), Node::Power { base, .. } if base == difference);
        let vanishes = factors.iter().all(|(_, exponent)| *exponent > 0)
            && factors.iter().any(|(base, _)| is_length(base))
            && self.facts(*difference).nonnegative;
        (vanishes && self.is_zero(*otherwise)).then_some(*product)
    }
}
