//! Kinetic energy, and the power that changes it.

use super::intermediates::total_time_derivative;
use super::variables::{Variables, inner};
use super::{Constraints, Tmt, TmtRow};
use crate::model::Model;
use crate::symbolic::{Expr, Graph, Number};

/// Kinetic energy minus the time integral of the power is constant, whatever the loads.
pub struct Energy {
    /// v' M v / 2.
    pub kinetic: Expr,
    /// F' (v - T_t) + lambda' C_t + T_t' M x'': the power of the loads, F' v, and of the drives that explicit time
    /// stands for, T_t' (M x'' - F). Depends on accelerations and multipliers only if time is explicit.
    pub power: Expr,
    /// The same by the forces along the coordinates, (T_q' F)' q', where time is not explicit.
    pub power_along_variables: Option<Expr>,
}

impl Energy {
    /// `drifts` are the partial time derivatives of the variables.
    pub(super) fn derive(
        graph: &mut Graph,
        model: &Model,
        variables: &Variables,
        drifts: &[Expr],
        tmt: &Tmt,
        constraints: &Constraints,
    ) -> Energy {
        let (mut twice_kinetic, mut power) = (Vec::new(), Vec::new());
        for row in &tmt.rows {
            let squared = graph.mul(row.motion.velocity, row.motion.velocity);
            twice_kinetic.push(graph.mul(row.inertia, squared));
            for (other, product) in &row.coupling {
                let velocities = [row.motion.velocity, *product, tmt.rows[*other].motion.velocity];
                twice_kinetic.push(graph.product(&velocities));
            }
            let driven = total_time_derivative(graph, &row.motion, drifts);
            // F v - F T_t, whose terms in T_t cancel here: as numbers they may be much larger than what they leave.
            let by_speeds = graph.sub(row.motion.velocity, driven);
            power.push(graph.mul(row.force, by_speeds));
            if !graph.is_zero(driven) {
                let inertia_force = inertia_force(graph, variables, &tmt.rows, row);
                power.push(graph.mul(driven, inertia_force));
            }
        }
        let is_driven = drifts.iter().chain(tmt.rows.iter().map(|row| &row.motion.time_derivative));
        let is_driven = is_driven.chain(&constraints.time_derivative).any(|by_time| !graph.is_zero(*by_time));
        let speeds: Vec<Expr> = variables.speeds.iter().map(|speed| graph.variable(*speed)).collect();
        let power_along_variables = (!is_driven).then(|| inner(graph, &tmt.generalized_forces, &speeds));
        for (i, multiplier) in model.multipliers(graph).into_iter().enumerate() {
            let carried = inner(graph, drifts, &constraints.jacobian[i]);
            let driven = graph.add(carried, constraints.time_derivative[i]);
            power.push(graph.mul(multiplier, driven));
        }
        let twice = graph.sum(&twice_kinetic);
        Energy { kinetic: graph.scale(&Number::HALF, twice), power: graph.sum(&power), power_along_variables }
    }
}

/// M x'' of a row.
fn inertia_force(graph: &mut Graph, variables: &Variables, rows: &[TmtRow], row: &TmtRow) -> Expr {
    let accelerations: Vec<Expr> = variables.accelerations.iter().map(|a| graph.variable(*a)).collect();
    let acceleration = |graph: &mut Graph, row: &TmtRow| {
        let moving = inner(graph, &row.motion.jacobian, &accelerations);
        graph.add(moving, row.motion.convective)
    };
    let own = acceleration(graph, row);
    let mut inertia_force = graph.mul(row.inertia, own);
    for (other, product) in &row.coupling {
        let coupled = acceleration(graph, &rows[*other]);
        let coupled = graph.mul(*product, coupled);
        inertia_force = graph.add(inertia_force, coupled);
    }
    graph.add(inertia_force, row.gyroscopic)
}
