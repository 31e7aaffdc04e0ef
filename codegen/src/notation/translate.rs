//! Expressions of the graph as formulas.

use super::formula::Formula;
use super::names::Names;
use crate::symbolic::{Expr, Graph, Node, Number};
use dashu_base::Gcd;

/// Decimals of more digits than this are better read as fractions.
const LONGEST_DECIMAL: u32 = 9;

/// Translates expressions of a graph to formulas, using given names.
pub(super) struct Translation<'a> {
    pub(super) graph: &'a Graph,
    pub(super) names: &'a Names,
}

impl Translation<'_> {
    /// The name of an expression if it has one, otherwise its formula.
    pub(super) fn formula(&self, expr: Expr) -> Formula {
        match self.names.of(expr) {
            Some(name) => Formula::Name(name.clone()),
            None => self.definition(expr),
        }
    }

    /// The formula of an expression, whether it has a name or not.
    pub(super) fn definition(&self, expr: Expr) -> Formula {
        match self.graph.node(expr) {
            Node::Number(value) => number(&value.abs()).signed(value.is_negative()),
            Node::Constant(constant) => Formula::Constant(*constant),
            Node::Symbol(symbol) => Formula::Name(self.names.symbol(self.graph, *symbol)),
            Node::Sum { constant, terms } => self.sum(constant, terms),
            Node::Product { coefficient, factors } => {
                self.product(&coefficient.abs(), factors).signed(coefficient.is_negative())
            }
            Node::Power { base, exponent } => self.power(*base, *exponent),
            Node::Call(function, argument) => Formula::Call(*function, self.formula(*argument).into()),
            Node::Choice(difference, above, otherwise) => {
                if let Some(product) = self.graph.vanishing_product(expr) {
                    return self.definition(product);
                }
                let [difference, above, otherwise] =
                    [difference, above, otherwise].map(|part| self.formula(*part).into());
                Formula::Choice(difference, above, otherwise)
            }
            Node::Table(table, order, argument) => {
                Formula::Table(self.names.table(self.graph, *table), *order, self.formula(*argument).into())
            }
            Node::Atan2(y, x) => Formula::Atan2(self.formula(*y).into(), self.formula(*x).into()),
        }
    }

    fn sum(&self, constant: &Number, terms: &[(Expr, Number)]) -> Formula {
        let mut formulas: Vec<(bool, Formula)> = terms
            .iter()
            .map(|(term, coefficient)| (coefficient.is_negative(), self.term(&coefficient.abs(), *term)))
            .collect();
        if !constant.is_zero() {
            formulas.push((constant.is_negative(), number(&constant.abs())));
        }
        Formula::sum(formulas)
    }

    /// `size * term`, with the number among the factors of the term.
    fn term(&self, size: &Number, term: Expr) -> Formula {
        match self.graph.node(term) {
            Node::Product { factors, .. } if self.names.of(term).is_none() => self.product(size, factors),
            _ => self.product(size, &[(term, 1)]),
        }
    }

    fn product(&self, size: &Number, factors: &[(Expr, i64)]) -> Formula {
        let powers = |wanted: fn(&i64) -> bool| {
            let chosen = factors.iter().filter(move |(_, exponent)| wanted(exponent));
            chosen.map(|(base, exponent)| self.integer_power(*base, exponent.unsigned_abs()))
        };
        let mut above: Vec<Formula> = powers(|e| *e > 0).collect();
        let mut below: Vec<Formula> = powers(|e| *e < 0).collect();
        let (numerator, denominator) = match number(size) {
            Formula::Quotient(p, q) => (*p, Some(*q)),
            size => (size, None),
        };
        if !matches!(&numerator, Formula::Number(one) if one == "1") {
            above.push(numerator);
        }
        below.extend(denominator);
        let above = Formula::product(above);
        match below.is_empty() {
            true => above,
            false => Formula::Quotient(above.into(), Formula::product(below).into()),
        }
    }

    /// `base^exponent` for an exponent of at least 1; powers of roots with a fraction as their exponent.
    fn integer_power(&self, base: Expr, exponent: u64) -> Formula {
        if exponent == 1 {
            return self.formula(base);
        }
        if let Node::Power { base: radicand, exponent: root } = self.graph.node(base)
            && self.names.of(base).is_none()
            && let Some((1, degree)) = self.graph.as_number(*root).and_then(Number::to_fraction)
            && exponent.gcd(degree.unsigned_abs()) == 1
        {
            let fraction = Formula::Quotient(
                Formula::Number(exponent.to_string()).into(),
                Formula::Number(degree.to_string()).into(),
            );
            return Formula::Power(self.formula(*radicand).into(), fraction.into());
        }
        Formula::Power(self.formula(base).into(), Formula::Number(exponent.to_string()).into())
    }

    fn power(&self, base: Expr, exponent: Expr) -> Formula {
        let radicand = self.formula(base).into();
        match self.graph.as_number(exponent).and_then(Number::to_fraction) {
            Some((1, degree)) => Formula::Root(radicand, degree.to_string()),
            _ => Formula::Power(radicand, self.formula(exponent).into()),
        }
    }
}

/// A number that is not negative: an integer, a decimal as it was probably written, or a fraction.
fn number(value: &Number) -> Formula {
    if let Some(digits) = decimal(value) {
        return Formula::Number(digits);
    }
    let digits = value.to_string();
    match digits.split_once('/') {
        None => Formula::Number(digits),
        Some((p, q)) => Formula::Quotient(Formula::Number(p.into()).into(), Formula::Number(q.into()).into()),
    }
}

/// The decimal form of a fraction, unless the fraction is simpler: 9.81, but 1/2.
fn decimal(value: &Number) -> Option<String> {
    let (p, q) = value.to_fraction()?;
    let digits = (1..=LONGEST_DECIMAL).find(|digits| 10i128.pow(*digits) % i128::from(q) == 0)?;
    if q % 5 != 0 {
        return None;
    }
    let scale = 10i128.pow(digits);
    let scaled = i128::from(p) * (scale / i128::from(q));
    Some(format!("{}.{:0width$}", scaled / scale, scaled % scale, width = digits as usize))
}
