//! Derivatives on the shared graph.

use super::symbols::Symbols;
use super::{Expr, Function, Graph, Node, Number, Symbol};
use rustc_hash::FxHashMap;

/// The directional derivative along given rates of the symbols: `sum of d(expr)/d(symbol) * rate`.
///
/// With one symbol at rate 1 it is a partial derivative; with every coordinate at its speed, every speed at its
/// acceleration and time at 1 it is the total time derivative. Each node is differentiated once during the life of this
/// value, so one `Differential` should serve all expressions of a kind.
#[derive(Clone)]
pub struct Differential {
    rates: FxHashMap<Symbol, Expr>,
    changing: Symbols,
    done: FxHashMap<Expr, Expr>,
}

impl Differential {
    /// The derivative in which each listed symbol changes at the given rate, and no other changes.
    pub fn along(rates: impl IntoIterator<Item = (Symbol, Expr)>) -> Differential {
        let rates: FxHashMap<Symbol, Expr> = rates.into_iter().collect();
        Differential { changing: Symbols::of(rates.keys()), rates, done: FxHashMap::default() }
    }

    /// The partial derivative with respect to one symbol.
    pub fn partial(graph: &mut Graph, symbol: Symbol) -> Differential {
        let one = graph.one();
        Differential::along([(symbol, one)])
    }

    /// Lets another symbol change, which stands in no expression that has been differentiated.
    pub fn extend(&mut self, symbol: Symbol, rate: Expr) {
        self.changing = self.changing.or(Symbols::of([&symbol]));
        self.rates.insert(symbol, rate);
    }

    /// The derivative of an expression.
    pub fn of(&mut self, graph: &mut Graph, expr: Expr) -> Expr {
        if !graph.may_occur(expr).meet(self.changing) {
            return graph.zero();
        }
        if let Some(done) = self.done.get(&expr) {
            return *done;
        }
        let derivative = self.compute(graph, expr);
        self.done.insert(expr, derivative);
        derivative
    }

    fn compute(&mut self, graph: &mut Graph, expr: Expr) -> Expr {
        match graph.node(expr).clone() {
            Node::Number(_) | Node::Constant(_) => graph.zero(),
            Node::Symbol(symbol) => match self.rates.get(&symbol) {
                Some(rate) => *rate,
                None => graph.zero(),
            },
            Node::Sum { terms, .. } => {
                let rates: Vec<_> = terms.iter().map(|(term, c)| (self.of(graph, *term), c.clone())).collect();
                graph.linear_combination(&rates)
            }
            Node::Product { coefficient, factors } => self.of_product(graph, &coefficient, &factors),
            Node::Power { base, exponent } => self.of_power(graph, expr, base, exponent),
            Node::Call(function, argument) => {
                let rate = self.of(graph, argument);
                if graph.is_zero(rate) {
                    return rate;
                }
                let slope = slope(graph, function, expr, argument);
                graph.mul(slope, rate)
            }
            Node::Table(table, order, argument) => {
                let rate = self.of(graph, argument);
                if graph.is_zero(rate) {
                    return rate;
                }
                let slope = graph.look_up(table, order + 1, argument);
                graph.mul(slope, rate)
            }
            Node::Choice(difference, above, otherwise) => {
                let (above, otherwise) = (self.of(graph, above), self.of(graph, otherwise));
                graph.choice(difference, above, otherwise)
            }
            Node::Atan2(y, x) => {
                let (dy, dx) = (self.of(graph, y), self.of(graph, x));
                let (x_dy, y_dx) = (graph.mul(x, dy), graph.mul(y, dx));
                let numerator = graph.sub(x_dy, y_dx);
                let (xx, yy) = (graph.integer_power(x, 2), graph.integer_power(y, 2));
                let denominator = graph.add(xx, yy);
                graph.div(numerator, denominator)
            }
        }
    }

    /// The product rule, one term for each factor that changes.
    fn of_product(&mut self, graph: &mut Graph, coefficient: &Number, factors: &[(Expr, i64)]) -> Expr {
        let mut terms = Vec::new();
        for (at, (base, exponent)) in factors.iter().enumerate() {
            if let Some((radicand, degree)) = root_in(graph, *base).filter(|(_, degree)| degree <= exponent)
                && let Some(share) = Number::fraction(*exponent, degree)
            {
                // Of u^(p/q) with p >= q it is p/q u^(p/q - 1), which has a value where u = 0.
                let rate = self.of(graph, radicand);
                let mut powers = factors.to_vec();
                powers[at].1 -= degree;
                powers.push((rate, 1));
                terms.push((graph.product_of_powers(&powers), coefficient * &share));
                continue;
            }
            let rate = self.of(graph, *base);
            if graph.is_zero(rate) {
                continue;
            }
            let mut powers = factors.to_vec();
            match exponent {
                1.. => powers[at].1 -= 1,
                _ => powers.push((*base, -1)),
            }
            powers.push((rate, 1));
            let term = graph.product_of_powers(&powers);
            terms.push((term, coefficient * &Number::from(*exponent)));
        }
        graph.linear_combination(&terms)
    }

    /// `d(u^v) = v u^(v-1) du + u^v ln(u) dv`, without the second term where v is constant.
    fn of_power(&mut self, graph: &mut Graph, power: Expr, base: Expr, exponent: Expr) -> Expr {
        let (base_rate, exponent_rate) = (self.of(graph, base), self.of(graph, exponent));
        let mut terms = Vec::new();
        if !graph.is_zero(base_rate) {
            let lower = match graph.as_number(exponent).cloned() {
                // u^(1/q - 1) = u^(1/q) / u keeps the root shared.
                Some(_) => graph.div(power, base),
                None => {
                    let one = graph.one();
                    let reduced = graph.sub(exponent, one);
                    graph.power(base, reduced)
                }
            };
            terms.push(graph.product(&[exponent, lower, base_rate]));
        }
        if !graph.is_zero(exponent_rate) {
            let log = graph.call(Function::Ln, base);
            terms.push(graph.product(&[power, log, exponent_rate]));
        }
        graph.sum(&terms)
    }
}

/// u and q of a root u^(1/q).
fn root_in(graph: &Graph, expr: Expr) -> Option<(Expr, i64)> {
    let Node::Power { base, exponent } = graph.node(expr) else { return None };
    let (one, degree) = graph.as_number(*exponent)?.to_fraction()?;
    (one == 1).then_some((*base, degree))
}

/// The derivative of a function at its argument; `value` is the function there.
fn slope(graph: &mut Graph, function: Function, value: Expr, argument: Expr) -> Expr {
    use Function::*;
    match function {
        Sin => graph.call(Cos, argument),
        Cos => {
            let sine = graph.call(Sin, argument);
            graph.neg(sine)
        }
        Tan => one_plus_square(graph, Number::ONE, value),
        Tanh => one_plus_square(graph, Number::MINUS_ONE, value),
        Asin | Acos => {
            let inside = one_plus_square(graph, Number::MINUS_ONE, argument);
            let root = graph.sqrt(inside);
            let slope = graph.integer_power(root, -1);
            if function == Acos { graph.neg(slope) } else { slope }
        }
        Atan => {
            let denominator = one_plus_square(graph, Number::ONE, argument);
            graph.integer_power(denominator, -1)
        }
        Sinh => graph.call(Cosh, argument),
        Cosh => graph.call(Sinh, argument),
        Exp => value,
        Ln => graph.integer_power(argument, -1),
        Abs => graph.call(Sign, argument),
        Sign => graph.zero(),
    }
}

/// `1 + c x^2`.
fn one_plus_square(graph: &mut Graph, c: Number, x: Expr) -> Expr {
    let square = graph.integer_power(x, 2);
    let one = graph.one();
    graph.linear_combination(&[(one, Number::ONE), (square, c)])
}
