//! Linear equations between the rates of the coordinates, eliminated in symbols as far as their pivots are numbers.

use super::variables::inner;
use crate::symbolic::{Expr, Graph, Number};

/// The largest sum that multiplying out may make.
const LONGEST_EXPANSION: usize = 64;

/// A q' + b = 0.
pub(super) struct Equation {
    /// A, one for each rate q'.
    pub(super) coefficients: Vec<Expr>,
    /// b.
    pub(super) rest: Expr,
}

/// An equation solved for one of its rates, whose coefficient is 1.
pub(super) struct Solved {
    pub(super) unknown: usize,
    pub(super) equation: Equation,
}

/// Solves as many equations as have a number for a coefficient, each for a rate that stands in few others; gives them
/// in order, and the remaining equations.
pub(super) fn eliminate(graph: &mut Graph, mut equations: Vec<Equation>) -> (Vec<Solved>, Vec<Equation>) {
    let mut solved = Vec::new();
    while let Some((row, unknown)) = pivot(graph, &equations) {
        let mut equation = equations.remove(row);
        if let Some(inverse) = graph.as_number(equation.coefficients[unknown]).and_then(Number::recip) {
            equation.scale(graph, &inverse);
        }
        for other in &mut equations {
            other.take(graph, unknown, &equation);
        }
        let zero = graph.zero();
        equation.coefficients[unknown] = zero;
        solved.push(Solved { unknown, equation });
    }
    (solved, equations)
}

/// Where a number is a coefficient, by Markowitz's count of the entries that its elimination may make.
fn pivot(graph: &Graph, equations: &[Equation]) -> Option<(usize, usize)> {
    let occupied = |equation: &Equation, j: usize| !graph.is_zero(equation.coefficients[j]);
    let mut best = None;
    for (i, equation) in equations.iter().enumerate() {
        let entries = (0..equation.coefficients.len()).filter(|j| occupied(equation, *j)).count();
        for (j, coefficient) in equation.coefficients.iter().enumerate() {
            if graph.as_number(*coefficient).is_none_or(Number::is_zero) {
                continue;
            }
            let column = equations.iter().filter(|equation| occupied(equation, j)).count();
            let cost = (entries - 1) * (column - 1);
            if best.is_none_or(|(least, _)| cost < least) {
                best = Some((cost, (i, j)));
            }
        }
    }
    best.map(|(_, place)| place)
}

impl Equation {
    /// A q' + b.
    pub(super) fn left_hand_side(&self, graph: &mut Graph, rates: &[Expr]) -> Expr {
        let moving = inner(graph, &self.coefficients, rates);
        graph.add(moving, self.rest)
    }

    fn scale(&mut self, graph: &mut Graph, factor: &Number) {
        for entry in self.coefficients.iter_mut().chain([&mut self.rest]) {
            *entry = graph.scale(factor, *entry);
        }
    }

    /// Subtracts the multiple of an equation, whose coefficient there is 1, that makes a coefficient 0.
    fn take(&mut self, graph: &mut Graph, unknown: usize, equation: &Equation) {
        let factor = self.coefficients[unknown];
        if graph.is_zero(factor) {
            return;
        }
        let less = equation.coefficients.iter().chain([&equation.rest]);
        for (entry, less) in self.coefficients.iter_mut().chain([&mut self.rest]).zip(less) {
            let product = graph.mul(factor, *less);
            let difference = graph.sub(*entry, product);
            *entry = expanded(graph, difference);
        }
    }
}

/// Multiplied out if terms then cancel.
pub(super) fn expanded(graph: &mut Graph, expr: Expr) -> Expr {
    graph.expand(expr, LONGEST_EXPANSION).unwrap_or(expr)
}
