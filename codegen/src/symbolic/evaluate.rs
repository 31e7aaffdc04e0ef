//! Numeric evaluation: the reference for every kernel.

use super::{Expr, Function, Graph, Node, Symbol};
use rustc_hash::FxHashMap;

/// The values of `roots` where `value` gives each symbol's value.
///
/// Plain `f64` arithmetic in canonical order; outside a function's domain the result is NaN or infinite.
pub fn evaluate(graph: &Graph, roots: &[Expr], value: impl Fn(Symbol) -> f64) -> Vec<f64> {
    let mut done: FxHashMap<Expr, f64> = FxHashMap::default();
    for expr in graph.reachable(roots) {
        let result = match graph.node(expr) {
            Node::Number(number) => number.to_f64(),
            Node::Constant(constant) => constant.to_f64(),
            Node::Symbol(symbol) => value(*symbol),
            Node::Sum { constant, terms } => {
                terms.iter().fold(constant.to_f64(), |sum, (term, c)| sum + c.to_f64() * done[term])
            }
            Node::Product { coefficient, factors } => {
                factors.iter().fold(coefficient.to_f64(), |product, (base, e)| product * integer_power(done[base], *e))
            }
            Node::Power { base, exponent } => done[base].powf(done[exponent]),
            Node::Call(function, argument) => apply_function(*function, done[argument]),
            Node::Table(table, order, argument) => graph.table(*table).derivative(*order, done[argument]),
            Node::Atan2(y, x) => done[y].atan2(done[x]),
            Node::Choice(difference, above, otherwise) => match done[difference] {
                nan if nan.is_nan() => nan,
                difference if difference > 0.0 => done[above],
                _ => done[otherwise],
            },
        };
        done.insert(expr, result);
    }
    roots.iter().map(|root| done[root]).collect()
}

pub(super) fn integer_power(base: f64, exponent: i64) -> f64 {
    match i32::try_from(exponent) {
        Ok(exponent) => base.powi(exponent),
        Err(_) => base.powf(exponent as f64),
    }
}

/// One function at one point.
pub fn apply_function(function: Function, x: f64) -> f64 {
    match function {
        Function::Sin => x.sin(),
        Function::Cos => x.cos(),
        Function::Tan => x.tan(),
        Function::Asin => x.asin(),
        Function::Acos => x.acos(),
        Function::Atan => x.atan(),
        Function::Sinh => x.sinh(),
        Function::Cosh => x.cosh(),
        Function::Tanh => x.tanh(),
        Function::Exp => x.exp(),
        Function::Ln => x.ln(),
        Function::Abs => x.abs(),
        Function::Sign if x == 0.0 => 0.0,
        Function::Sign => x.signum(),
    }
}
