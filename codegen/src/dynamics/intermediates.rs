//! Intermediate quantities: variables that stand for parts of long sums.
//!
//! Coordinates are eliminated from the tip inwards and intermediates substituted: the articulated-body method. Joint
//! forces as further unknowns would do the same, but would need multipliers for the cut joints; by substitution all
//! pivots stay positive. Equations for readers are always in coordinates alone.

use super::variables::{Differentiated, inner};
use crate::symbolic::{Expr, Graph, Symbol};

/// A variable y with its definition in terms of coordinates and of the intermediates before it.
pub struct Intermediate {
    /// The user's name for it, or one of ours.
    pub name: String,
    /// y, y', y'' and y_t.
    pub symbols: [Symbol; 4],
    /// phi with its derivatives.
    pub definition: Differentiated,
    /// y'' = phi_y y'' + phi_q q'' + ..
    pub acceleration: Expr,
    /// The partial derivative with respect to explicit time, at fixed coordinates: phi_y y_t + phi_t.
    pub time_derivative: Expr,
}

impl Intermediate {
    /// y_t as it occurs in what depends on y: 0 or its symbol.
    pub(super) fn drift(&self, graph: &mut Graph) -> Expr {
        if graph.is_zero(self.time_derivative) { self.time_derivative } else { graph.variable(self.symbols[3]) }
    }
}

/// x_t at fixed coordinates, of a quantity over variables that may have a `drifts` y_t of their own.
pub(super) fn total_time_derivative(graph: &mut Graph, quantity: &Differentiated, drifts: &[Expr]) -> Expr {
    let carried = inner(graph, drifts, &quantity.jacobian);
    graph.add(carried, quantity.time_derivative)
}
