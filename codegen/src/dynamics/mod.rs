//! Stage 3: model to equations of motion, by the TMT method with cut loops.
//!
//! x = T(q, t) stacks the rotation and position of each body; v = T_q q' + T_t; loops are closed by
//! constraints C(q, t) = 0:
//!
//! ```text
//! [ T_q' M T_q   C_q' ] [ q''    ]   [ T_q' (F - M g)              ]
//! [ C_q          0    ] [ lambda ] = [ -(C_q q' + C_t)_q q' - (..)_t ]
//! ```
//!
//! with g = (T_q q' + T_t)_q q' + (..)_t, all of the convective accelerations. The reaction does virtual work
//! -lambda delta C on the system. Source: the TMT method as taught in TU Delft's course Multibody Dynamics B, with the full
//! convective term in place of the sum over columns.
//!
//! [`lagrange`] derives the same motion from the kinetic energy alone, to check this one.

mod constraints;
mod energy;
mod lagrange;
mod outputs;
mod sensitivity;
mod tmt;

pub use constraints::Constraints;
pub use energy::Energy;
pub use lagrange::{Lagrange, lagrange};
pub use outputs::Outputs;
pub use sensitivity::Sensitivity;
pub use tmt::{Row, Tmt};

use crate::model::Model;
use crate::symbolic::{Differential, Expr};

/// The equations of motion of a model, with n coordinates and m constraints. All expressions live in
/// `model.graph`, in SI units.
pub struct EquationsOfMotion {
    /// What they were derived from.
    pub model: Model,
    /// Mass matrix, convective and generalised forces.
    pub tmt: Tmt,
    /// Constraints with their derivatives.
    pub constraints: Constraints,
    /// Kinetic energy and power.
    pub energy: Energy,
    /// Outputs and their rates.
    pub outputs: Outputs,
    /// Derivatives with respect to state and parameters.
    pub sensitivity: Sensitivity,
}

/// Derives the equations of motion.
pub fn derive(mut model: Model) -> EquationsOfMotion {
    let mut derivatives = Derivatives::of(&mut model);
    let tmt = Tmt::derive(&mut model, &mut derivatives);
    let constraints = Constraints::derive(&mut model, &mut derivatives);
    let energy = Energy::derive(&mut model, &tmt, &constraints);
    let outputs = Outputs::derive(&mut model);
    let sensitivity = Sensitivity::derive(&mut model, &mut derivatives, &tmt, &constraints);
    EquationsOfMotion { model, tmt, constraints, energy, outputs, sensitivity }
}

/// The derivatives that the equations are made of, each kept for all expressions.
pub struct Derivatives {
    /// One for each coordinate.
    by_coordinate: Vec<Differential>,
    /// With respect to explicit time.
    by_time: Differential,
    /// The total time derivative at constant speeds: q at q', t at 1.
    convective: Differential,
}

impl Derivatives {
    fn of(model: &mut Model) -> Derivatives {
        let graph = &mut model.graph;
        let by_coordinate = model.coordinates.iter().map(|c| Differential::partial(graph, c.position)).collect();
        let by_time = Differential::partial(graph, model.time);
        let mut rates = vec![(model.time, graph.one())];
        rates.extend(model.coordinates.iter().map(|c| (c.position, graph.variable(c.speed))));
        Derivatives { by_coordinate, by_time, convective: Differential::along(rates) }
    }

    /// The row of partial derivatives with respect to the coordinates.
    fn gradient(&mut self, model: &mut Model, expr: Expr) -> Vec<Expr> {
        self.by_coordinate.iter_mut().map(|d| d.of(&mut model.graph, expr)).collect()
    }

    fn by_time(&mut self, model: &mut Model, expr: Expr) -> Expr {
        self.by_time.of(&mut model.graph, expr)
    }

    /// `(x_q q' + x_t)_q q' + (x_q q' + x_t)_t`, mixed derivatives included, given `rate = x_q q' + x_t`.
    fn convective(&mut self, model: &mut Model, rate: Expr) -> Expr {
        self.convective.of(&mut model.graph, rate)
    }
}

/// `sum of a_i b_i`.
fn inner(model: &mut Model, a: &[Expr], b: &[Expr]) -> Expr {
    let products: Vec<Expr> = a.iter().zip(b).map(|(a, b)| model.graph.mul(*a, *b)).collect();
    model.graph.sum(&products)
}
