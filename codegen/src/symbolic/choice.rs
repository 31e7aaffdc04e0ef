//! Choices by the sign of a difference.

use super::{Expr, Graph, Node};

impl Graph {
    /// `above` where `difference > 0`, `otherwise` where it is not, and NaN where it is NaN.
    ///
    /// Its derivative is that of the chosen expression; at the switch that of `otherwise`.
    pub fn choice(&mut self, difference: Expr, above: Expr, otherwise: Expr) -> Expr {
        if above == otherwise {
            return above;
        }
        if let Some(number) = self.as_number(difference) {
            let is_above = !number.is_zero() && !number.is_negative();
            return if is_above { above } else { otherwise };
        }
        let difference = self.without_size(difference);
        self.intern(Node::Choice(difference, above, otherwise))
    }

    /// The smaller of two; the first where they are equal.
    pub fn min(&mut self, a: Expr, b: Expr) -> Expr {
        let difference = self.sub(a, b);
        self.choice(difference, b, a)
    }

    /// The larger of two; the first where they are equal.
    pub fn max(&mut self, a: Expr, b: Expr) -> Expr {
        let difference = self.sub(b, a);
        self.choice(difference, b, a)
    }

    /// An expression of the same sign, without a positive numeric factor.
    fn without_size(&mut self, expr: Expr) -> Expr {
        let content = match self.node(expr) {
            Node::Sum { constant, terms } => terms.iter().fold(constant.abs(), |gcd, (_, c)| gcd.gcd(c)).abs(),
            Node::Product { coefficient, .. } => coefficient.abs(),
            _ => return expr,
        };
        match content.recip() {
            Some(inverse) if !content.is_one() => self.scale(&inverse, expr),
            _ => expr,
        }
    }
}
