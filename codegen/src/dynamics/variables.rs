//! The variables of the derivatives of T: the coordinates, and the intermediate quantities that stand for parts of long
//! sums.

use super::rows::Along;
use crate::model::Model;
use crate::symbolic::{Differential, Expr, Graph, Symbol, substitute};

/// The coordinates, then the intermediate quantities, each with its rates.
pub struct Variables {
    /// q, then y.
    pub positions: Vec<Symbol>,
    /// q', then y'.
    pub speeds: Vec<Symbol>,
    /// q'', then y''.
    pub accelerations: Vec<Symbol>,
}

impl Variables {
    /// The coordinates alone.
    pub(super) fn coordinates(model: &Model) -> Variables {
        Variables {
            positions: model.coordinates.iter().map(|c| c.position).collect(),
            speeds: model.coordinates.iter().map(|c| c.speed).collect(),
            accelerations: model.coordinates.iter().map(|c| c.acceleration).collect(),
        }
    }

    /// Their number.
    pub fn len(&self) -> usize {
        self.positions.len()
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.positions.is_empty()
    }
}

/// A quantity with the derivatives that the derivation needs, up to those that accelerations do not enter.
pub struct Differentiated {
    /// x(q, t).
    pub position: Expr,
    /// x_q, an entry for each variable.
    pub jacobian: Vec<Expr>,
    /// x_t.
    pub time_derivative: Expr,
    /// x' = x_q q' + x_t.
    pub velocity: Expr,
    /// (x_q q' + x_t)_q q' + (..)_t: the part of x'' without accelerations.
    pub convective: Expr,
}

/// The derivatives in the equations, each shared by all expressions.
pub(super) struct Derivatives {
    /// One for each variable.
    pub(super) by_variable: Vec<Differential>,
    /// One for the rate of each variable.
    by_rate: Vec<Differential>,
    /// With respect to explicit time.
    by_time: Differential,
    /// The total time derivative at constant speeds: q at q', t at 1.
    convective: Differential,
    speeds: Vec<Expr>,
}

impl Derivatives {
    pub(super) fn of(graph: &mut Graph, model: &Model, variables: &Variables) -> Derivatives {
        let by_variable = variables.positions.iter().map(|x| Differential::partial(graph, *x)).collect();
        let by_rate = variables.speeds.iter().map(|rate| Differential::partial(graph, *rate)).collect();
        let by_time = Differential::partial(graph, model.time);
        let speeds: Vec<Expr> = variables.speeds.iter().map(|speed| graph.variable(*speed)).collect();
        let mut rates = vec![(model.time, graph.one())];
        rates.extend(variables.positions.iter().copied().zip(speeds.iter().copied()));
        Derivatives { by_variable, by_rate, by_time, convective: Differential::along(rates), speeds }
    }

    pub(super) fn of_quantity(&mut self, graph: &mut Graph, variables: &Variables, position: Expr) -> Differentiated {
        let occurring = graph.symbols_of(&[position]);
        let zero = graph.zero();
        let mut jacobian = vec![zero; variables.len()];
        for (i, symbol) in variables.positions.iter().enumerate() {
            if occurring.binary_search(symbol).is_ok() {
                jacobian[i] = self.by_variable[i].of(graph, position);
            }
        }
        let time_derivative = self.by_time.of(graph, position);
        let moving = inner(graph, &jacobian, &self.speeds);
        let velocity = graph.add(moving, time_derivative);
        let convective = self.convective.of(graph, velocity);
        Differentiated { position, jacobian, time_derivative, velocity, convective }
    }

    /// A row of T: `at_rest` gives the accelerations the value 0.
    pub(super) fn of_row(
        &mut self,
        graph: &mut Graph,
        variables: &Variables,
        along: Along,
        at_rest: &[(Symbol, Expr)],
    ) -> Differentiated {
        match along {
            Along::Position(position) => self.of_quantity(graph, variables, position),
            Along::Rate { velocity, acceleration, .. } => {
                let convective = substitute(graph, &[acceleration], at_rest)[0];
                Differentiated { convective, ..self.of_rate(graph, variables, velocity) }
            }
        }
    }

    /// A quantity w(q, q', t) linear in the speeds, as if it were the velocity of some position: with w_q' for its
    /// Jacobian, and the part without speeds for its time derivative.
    pub(super) fn of_rate(&mut self, graph: &mut Graph, variables: &Variables, rate: Expr) -> Differentiated {
        let jacobian = self.by_rate.iter_mut().map(|by_rate| by_rate.of(graph, rate)).collect();
        let zero = graph.zero();
        let at_rest: Vec<(Symbol, Expr)> = variables.speeds.iter().map(|speed| (*speed, zero)).collect();
        let time_derivative = substitute(graph, &[rate], &at_rest)[0];
        let convective = self.convective.of(graph, rate);
        Differentiated { position: zero, jacobian, time_derivative, velocity: rate, convective }
    }
}

/// `sum of a_i b_i`.
pub(super) fn inner(graph: &mut Graph, a: &[Expr], b: &[Expr]) -> Expr {
    let pairs = a.iter().zip(b).filter(|(a, _)| !graph.is_zero(**a));
    let pairs: Vec<(Expr, Expr)> = pairs.map(|(a, b)| (*a, *b)).collect();
    let products: Vec<Expr> = pairs.into_iter().map(|(a, b)| graph.mul(a, b)).collect();
    graph.sum(&products)
}
