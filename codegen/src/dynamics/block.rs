//! The rest of the kinematic equations of generalised speeds, in which no coefficient is a number: B h + c = 0 in the
//! form B'B h = -B'c, decoupled into blocks.

use super::linear::{Equation, expanded};
use super::variables::inner;
use crate::model::Model;
use crate::symbolic::{Differential, Expr, Graph, Number, Symbol};

/// Linear equations for s of the rates, h, which are solved at run time.
pub struct Block {
    /// Which coordinates they are the rates of.
    pub coordinates: Vec<usize>,
    /// B'B, s x s, symmetric.
    pub matrix: Vec<Vec<Expr>>,
    /// h.
    pub rates: Solution,
    /// The u that h depends on, each with the derivative of h by it.
    pub by_speed: Vec<(usize, Solution)>,
    /// h' where u' = 0. Rates stand in its right-hand side, those of other blocks too.
    pub convective: Solution,
}

/// A vector x, s, with B'B x = the right-hand side.
pub struct Solution {
    /// Symbols for x.
    pub symbols: Vec<Symbol>,
    /// The right-hand side.
    pub right_hand_side: Vec<Expr>,
}

impl Block {
    /// All that it is solved for.
    pub fn solutions(&self) -> impl Iterator<Item = &Solution> {
        [&self.rates].into_iter().chain(self.by_speed.iter().map(|(_, solution)| solution)).chain([&self.convective])
    }
}

/// A part of B'B h = -B'c that shares no unknowns with others.
pub(super) struct Subsystem {
    /// The coordinates whose rates are unknown.
    pub(super) coordinates: Vec<usize>,
    /// B by columns.
    columns: Vec<Vec<Expr>>,
    matrix: Vec<Vec<Expr>>,
    of_rates: Vec<Expr>,
}

impl Subsystem {
    /// All parts of equations for the rates of these coordinates.
    pub(super) fn all(graph: &mut Graph, equations: &[Equation], coordinates: &[usize]) -> Vec<Subsystem> {
        let column = |j: &usize| equations.iter().map(|equation| equation.coefficients[*j]).collect();
        let columns: Vec<Vec<Expr>> = coordinates.iter().map(column).collect();
        let mut entry = |a: &[Expr], b: &[Expr]| {
            let entry = inner(graph, a, b);
            expanded(graph, entry)
        };
        let matrix: Vec<Vec<Expr>> = columns.iter().map(|a| columns.iter().map(|b| entry(a, b)).collect()).collect();
        let rests: Vec<Expr> = equations.iter().map(|equation| equation.rest).collect();
        let linked = |i: usize, j: usize| !graph.is_zero(matrix[i][j]);
        let places = components(columns.len(), linked);
        let part = |places: Vec<usize>| {
            let columns: Vec<Vec<Expr>> = places.iter().map(|i| columns[*i].clone()).collect();
            Subsystem {
                coordinates: places.iter().map(|i| coordinates[*i]).collect(),
                matrix: places.iter().map(|i| places.iter().map(|j| matrix[*i][*j]).collect()).collect(),
                of_rates: reduced(graph, &columns, &rests),
                columns,
            }
        };
        places.into_iter().map(part).collect()
    }

    /// A rate with only a number as its coefficient.
    pub(super) fn known(&self, graph: &mut Graph) -> Option<(usize, Expr)> {
        let [coordinate] = self.coordinates.as_slice() else { return None };
        let inverse = graph.as_number(self.matrix[0][0]).and_then(Number::recip)?;
        Some((*coordinate, graph.scale(&inverse, self.of_rates[0])))
    }

    /// The part solved for `h`. Where u' = 0, `changing` is the rate of the left-hand sides without h'.
    pub(super) fn block(
        self,
        graph: &mut Graph,
        model: &Model,
        h: Vec<Symbol>,
        rests: &[Expr],
        changing: &[Expr],
    ) -> Block {
        let mut by_speed = Vec::new();
        for k in 0..model.generalized_speeds.len() {
            let mut by = Differential::partial(graph, model.generalized_speeds[k].symbol);
            let rests: Vec<Expr> = rests.iter().map(|rest| by.of(graph, *rest)).collect();
            let right_hand_side = reduced(graph, &self.columns, &rests);
            if right_hand_side.iter().any(|entry| !graph.is_zero(*entry)) {
                let symbols = self.symbols(graph, model, &format!("by_{}", model.generalized_speeds[k].name));
                by_speed.push((k, Solution { symbols, right_hand_side }));
            }
        }
        let symbols = self.symbols(graph, model, "convective");
        let convective = Solution { symbols, right_hand_side: reduced(graph, &self.columns, changing) };
        let rates = Solution { symbols: h, right_hand_side: self.of_rates };
        Block { coordinates: self.coordinates, matrix: self.matrix, rates, by_speed, convective }
    }

    /// New symbols, one for each unknown.
    pub(super) fn symbols(&self, graph: &mut Graph, model: &Model, suffix: &str) -> Vec<Symbol> {
        let name = |j: &usize| format!("{}_{suffix}", model.coordinates[*j].name);
        self.coordinates.iter().map(|j| graph.symbol(&name(j))).collect()
    }
}

/// The numbers below `n` in sets that links hold together.
fn components(n: usize, linked: impl Fn(usize, usize) -> bool) -> Vec<Vec<usize>> {
    let mut left: Vec<usize> = (0..n).collect();
    let mut components = Vec::new();
    while !left.is_empty() {
        let mut component = vec![left.remove(0)];
        let mut at = 0;
        while at < component.len() {
            let (found, others) = left.iter().partition(|j| linked(component[at], **j));
            component.extend::<Vec<usize>>(found);
            left = others;
            at += 1;
        }
        component.sort_unstable();
        components.push(component);
    }
    components
}

/// -B' times a vector.
fn reduced(graph: &mut Graph, columns: &[Vec<Expr>], vector: &[Expr]) -> Vec<Expr> {
    let entry = |column: &Vec<Expr>| {
        let sum = inner(graph, column, vector);
        graph.neg(sum)
    };
    columns.iter().map(entry).collect()
}
