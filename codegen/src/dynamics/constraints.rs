//! Constraints with the derivatives that the equations of motion and the projection need.
//!
//! The rows of a constraint that events switch are scaled by its activity, so that a released one is 0 = 0 everywhere.

use super::variables::{Derivatives, Variables};
use crate::model::Model;
use crate::symbolic::{Expr, Function, Node, Number};

/// m constraint rows C(q, t) = 0.
pub struct Constraints {
    /// C, m.
    pub values: Vec<Expr>,
    /// The sum of the magnitudes of the terms of C, m: what rounding in C is relative to.
    pub magnitudes: Vec<Expr>,
    /// C_q, m x n.
    pub jacobian: Vec<Vec<Expr>>,
    /// C_t, m.
    pub time_derivative: Vec<Expr>,
    /// (C_q q' + C_t)_q q' + (..)_t, m: the part of C'' without accelerations.
    pub convective: Vec<Expr>,
}

impl Constraints {
    /// `values` are the constraints over `variables`, n of them.
    pub(super) fn derive(
        model: &mut Model,
        variables: &Variables,
        derivatives: &mut Derivatives,
        values: Vec<Expr>,
    ) -> Constraints {
        let declared: Vec<Expr> = model.constraints.iter().map(|constraint| constraint.value).collect();
        let magnitudes = declared.into_iter().map(|value| magnitude(model, value)).collect();
        let mut constraints =
            Constraints { values, magnitudes, jacobian: vec![], time_derivative: vec![], convective: vec![] };
        for (i, value) in constraints.values.clone().into_iter().enumerate() {
            let row = derivatives.of_quantity(model, variables, value);
            let activity = model.constraints[i].activity;
            let mut scaled = |expr: Expr| activity.map_or(expr, |activity| model.graph.mul(activity, expr));
            constraints.values[i] = scaled(value);
            constraints.jacobian.push(row.jacobian.into_iter().map(&mut scaled).collect());
            constraints.time_derivative.push(scaled(row.time_derivative));
            constraints.convective.push(scaled(row.convective));
        }
        constraints
    }
}

/// The sum of the absolute values of an expression's terms.
fn magnitude(model: &mut Model, value: Expr) -> Expr {
    let graph = &mut model.graph;
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
