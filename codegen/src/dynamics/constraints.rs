//! Constraints with the derivatives that the equations of motion and the projection need.
//!
//! A row w(q, q', t) = 0 between speeds is linear in them, w = A q' + b, and enters where the rate of a row between
//! positions does, C' = C_q q' + C_t: A stands for C_q, b for C_t, and w_q q' + w_t for the convective terms. It does no
//! work on motions that it admits for b = 0, as its reaction is A' lambda. (Neimark and Fufaev, Dynamics of Nonholonomic
//! Systems, 1972, chapter III.)
//!
//! The rows of a constraint that events switch are scaled by its activity, or chosen by it where they may have no value, so that a
//! released one is 0 = 0 everywhere.
//!
//! A constraint that events switch is one kernel, not two. Its multiplier has the diagonal entry activity - 1, so that
//! it is 0 while the constraint is released, and every other number is as without the constraint. Activities change
//! only at events, so `prepare` may use them.

use super::variables::{Derivatives, Variables};
use crate::model::{Level, Model};
use crate::symbolic::{Expr, Function, Graph, Node, Number};

/// m constraint rows C(q, t) = 0.
pub struct Constraints {
    /// C, m; zero for rows between speeds.
    pub values: Vec<Expr>,
    /// The sum of the magnitudes of the terms of C, m: what rounding in C is relative to.
    pub magnitudes: Vec<Expr>,
    /// C_q, m x n; w_q' for rows w = 0 between speeds.
    pub jacobian: Vec<Vec<Expr>>,
    /// C_t, m; w without speeds for rows between speeds.
    pub time_derivative: Vec<Expr>,
    /// (C_q q' + C_t)_q q' + (..)_t, m: the part of C'' without accelerations.
    pub convective: Vec<Expr>,
}

impl Constraints {
    /// `values` are left - right of the constraints over `variables`, n of them.
    pub(super) fn derive(
        graph: &mut Graph,
        model: &Model,
        variables: &Variables,
        derivatives: &mut Derivatives,
        values: Vec<Expr>,
    ) -> Constraints {
        let declared: Vec<(Level, Expr)> = model.constraints.iter().map(|c| (c.level, c.value)).collect();
        let zero = graph.zero();
        let mut constraints = Constraints {
            values: vec![],
            magnitudes: vec![],
            jacobian: vec![],
            time_derivative: vec![],
            convective: vec![],
        };
        for (i, (value, (level, declared))) in values.into_iter().zip(declared).enumerate() {
            let size = if level == Level::Positions { magnitude(graph, declared) } else { zero };
            let (own, row) = match level {
                Level::Positions => (value, derivatives.of_quantity(graph, variables, value)),
                Level::Speeds => (zero, derivatives.of_rate(graph, variables, value)),
            };
            let activity = model.constraints[i].activity;
            constraints.magnitudes.push(match activity {
                Some(activity) if !graph.has_value_everywhere(size) => graph.choice(activity, size, zero),
                _ => size,
            });
            let mut switched = |expr: Expr| activity.map_or(expr, |activity| switched(graph, activity, expr));
            constraints.values.push(switched(own));
            constraints.jacobian.push(row.jacobian.into_iter().map(&mut switched).collect());
            constraints.time_derivative.push(switched(row.time_derivative));
            constraints.convective.push(switched(row.convective));
        }
        constraints
    }
}

/// The value of a row while it is active, and 0 while it is released: by a factor, unless the row may have no value.
pub(super) fn switched(graph: &mut Graph, activity: Expr, expr: Expr) -> Expr {
    let zero = graph.zero();
    match graph.has_value_everywhere(expr) {
        true => graph.mul(activity, expr),
        false => graph.choice(activity, expr, zero),
    }
}

/// The sum of the absolute values of an expression's terms.
fn magnitude(graph: &mut Graph, value: Expr) -> Expr {
    let (constant, terms) = match graph.node(value).clone() {
        Node::Sum { constant, terms } => (constant, terms.into_vec()),
        _ => (Number::ZERO, vec![(value, Number::ONE)]),
    };
    let mut sizes: Vec<Expr> = terms
        .into_iter()
        .map(|(term, coefficient)| {
            let size = graph.call(Function::Abs, term);
            graph.scale(&coefficient.abs(), size)
        })
        .collect();
    sizes.push(graph.number(constant.abs()));
    graph.sum(&sizes)
}
