//! How the equations of motion change with the state and with the parameters.
//!
//! With the equations as K z = r, z = (q'', lambda), any derivative of the solution solves K dz = dr - dK z: here are
//! the right-hand sides, the derivatives of r - K z at fixed z (the implicit function theorem).

use super::EquationsOfMotion;
use super::variables::{Derivatives, inner};
use crate::symbolic::{Differential, Expr, Graph, Symbol};

/// The derivatives of r - K z at fixed accelerations and multipliers: a column of n + m for each variable.
pub type Columns = Vec<Vec<Expr>>;

/// Above, the kernel of the derivatives with respect to the state is made only if it is asked for: it grows with the
/// square of the number of coordinates.
const MOST_COORDINATES: usize = 12;

/// Enters the derivatives that the model asks for.
pub(super) fn derive(equations: &mut EquationsOfMotion, derivatives: &mut Derivatives) {
    let model = &equations.model;
    let by_state = model.wants_jacobian.unwrap_or(model.coordinates.len() <= MOST_COORDINATES);
    // Whether an input follows its declared course is known at run time alone.
    let courses: Vec<Expr> = model.inputs.iter().map(|input| input.course).collect();
    let occurring = model.graph.symbols_of(&courses);
    let by_parameters = model.wants_sensitivity && !model.parameters.iter().any(|p| occurring.contains(&p.symbol));
    if !by_state && !by_parameters {
        return;
    }
    let residual = residual(equations);
    let model = &mut equations.model;
    if by_state {
        let speeds: Vec<Symbol> = model.coordinates.iter().map(|c| c.speed).collect();
        let by_positions = columns(&mut model.graph, &residual, &mut derivatives.by_variable);
        let mut by_speed = partials(&mut model.graph, &speeds);
        equations.by_state = Some([by_positions, columns(&mut model.graph, &residual, &mut by_speed)]);
    }
    if by_parameters {
        let parameters: Vec<Symbol> = model.parameters.iter().map(|p| p.symbol).collect();
        let mut by_parameter = partials(&mut model.graph, &parameters);
        equations.by_parameters = Some(columns(&mut model.graph, &residual, &mut by_parameter));
    }
}

fn partials(graph: &mut Graph, symbols: &[Symbol]) -> Vec<Differential> {
    symbols.iter().map(|symbol| Differential::partial(graph, *symbol)).collect()
}

fn columns(graph: &mut Graph, residual: &[Expr], differentials: &mut [Differential]) -> Columns {
    differentials.iter_mut().map(|d| residual.iter().map(|row| d.of(graph, *row)).collect()).collect()
}

/// T_q' (F - M (T_q q'' + g)) - C_q' lambda, then -(C_q q'' + (C_q q' + C_t)_q q' + (..)_t).
fn residual(equations: &mut EquationsOfMotion) -> Vec<Expr> {
    let EquationsOfMotion { model, tmt, constraints, .. } = equations;
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
