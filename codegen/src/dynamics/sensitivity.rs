//! How the equations of motion change with the state and with the parameters.
//!
//! With the equations as K z = r, z = (q'', lambda), any derivative of the solution solves K dz = dr - dK z: here are
//! the right-hand sides, the derivatives of r - K z at fixed z (the implicit function theorem).

use super::variables::{Derivatives, inner};
use super::{Constraints, Tmt};
use crate::model::Model;
use crate::symbolic::{Differential, Expr, Symbol};

/// The derivatives of r - K z at fixed accelerations and multipliers: a column of n + m for each variable.
pub struct Sensitivity {
    /// With respect to the coordinates, n columns.
    pub by_positions: Vec<Vec<Expr>>,
    /// With respect to the speeds, n columns.
    pub by_speeds: Vec<Vec<Expr>>,
    /// With respect to the parameters.
    pub by_parameters: Vec<Vec<Expr>>,
}

impl Sensitivity {
    pub(super) fn derive(
        model: &mut Model,
        derivatives: &mut Derivatives,
        tmt: &Tmt,
        constraints: &Constraints,
    ) -> Sensitivity {
        let residual = residual(model, tmt, constraints);
        let columns = |model: &mut Model, differentials: &mut [Differential]| -> Vec<Vec<Expr>> {
            let column = |d: &mut Differential| residual.iter().map(|row| d.of(&mut model.graph, *row)).collect();
            differentials.iter_mut().map(column).collect()
        };
        let partial = |model: &mut Model, symbols: Vec<Symbol>| -> Vec<Differential> {
            symbols.into_iter().map(|symbol| Differential::partial(&mut model.graph, symbol)).collect()
        };
        let speeds = model.coordinates.iter().map(|c| c.speed).collect();
        let parameters = model.parameters.iter().map(|p| p.symbol).collect();
        let (mut by_speed, mut by_parameter) = (partial(model, speeds), partial(model, parameters));
        Sensitivity {
            by_positions: columns(model, &mut derivatives.by_variable),
            by_speeds: columns(model, &mut by_speed),
            by_parameters: columns(model, &mut by_parameter),
        }
    }
}

/// T_q' (F - M (T_q q'' + g)) - C_q' lambda, then -(C_q q'' + (C_q q' + C_t)_q q' + (..)_t).
fn residual(model: &mut Model, tmt: &Tmt, constraints: &Constraints) -> Vec<Expr> {
    let (accelerations, multipliers) = (model.accelerations(), model.multipliers());
    let mut rows = Vec::new();
    for (j, rhs) in tmt.right_hand_side.iter().enumerate() {
        let inertial = inner(model, &tmt.mass_matrix[j], &accelerations);
        let column: Vec<Expr> = constraints.jacobian.iter().map(|row| row[j]).collect();
        let reaction = inner(model, &column, &multipliers);
        let known = model.graph.sub(*rhs, inertial);
        rows.push(model.graph.sub(known, reaction));
    }
    for (row, convective) in constraints.jacobian.iter().zip(&constraints.convective) {
        let moving = inner(model, row, &accelerations);
        let sum = model.graph.add(moving, *convective);
        rows.push(model.graph.neg(sum));
    }
    rows
}
