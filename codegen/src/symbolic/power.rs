//! Powers with integer, rational and symbolic exponents.
//!
//! x^(p/q) is the p-th power of the atom x^(1/q): exponents in products stay integers, and sqrt(x)^2 keeps its meaning
//! for negative x.

use super::{Constant, Expr, Function, Graph, Node, Number};

impl Graph {
    /// `base^exponent`.
    ///
    /// A power with an exponent that is no integer is real only for bases that are not negative: a negative
    /// base gives NaN, as `f64::powf` does, also for odd roots.
    pub fn power(&mut self, base: Expr, exponent: Expr) -> Expr {
        match self.as_number(exponent).cloned() {
            Some(value) => self.rational_power(base, &value),
            None if matches!(self.node(base), Node::Constant(Constant::E)) => self.call(Function::Exp, exponent),
            None => self.intern(Node::Power { base, exponent }),
        }
    }

    /// `base^exponent` for an integer.
    pub fn integer_power(&mut self, base: Expr, exponent: i64) -> Expr {
        self.product_of_powers(&[(base, exponent)])
    }

    /// The square root.
    pub fn sqrt(&mut self, base: Expr) -> Expr {
        self.root(base, 2)
    }

    fn rational_power(&mut self, base: Expr, exponent: &Number) -> Expr {
        if let Some(integer) = exponent.to_integer() {
            return self.integer_power(base, integer);
        }
        let degree = exponent.to_fraction().and_then(|(p, q)| Some((p, u32::try_from(q).ok()?)));
        match degree {
            Some((p, q)) => {
                let root = self.root(base, q);
                self.integer_power(root, p)
            }
            None => {
                let exponent = self.number(exponent.clone());
                self.intern(Node::Power { base, exponent })
            }
        }
    }

    /// `base^(1/degree)`, kept as an atom unless it is rational.
    fn root(&mut self, base: Expr, degree: u32) -> Expr {
        if let Some(root) = self.as_number(base).and_then(|value| value.exact_root(degree)) {
            return self.number(root);
        }
        let Some(exponent) = Number::fraction(1, degree.into()) else { return base };
        let exponent = self.number(exponent);
        self.intern(Node::Power { base, exponent })
    }
}
