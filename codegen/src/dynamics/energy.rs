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
    /// F' v + lambda' C_t + T_t' (M x'' - F): the power of the loads, and of the drives that explicit time
    /// stands for. Depends on accelerations and multipliers only if time is explicit.
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
            power.push(graph.mul(row.force, row.motion.velocity));
            power.push(drive_power(graph, variables, drifts, &tmt.rows, row));
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

/// T_t (M x'' - F): the power of a drive that moves the row in time.
fn drive_power(graph: &mut Graph, variables: &Variables, drifts: &[Expr], rows: &[TmtRow], row: &TmtRow) -> Expr {
    let driven = total_time_derivative(graph, &row.motion, drifts);
    if graph.is_zero(driven) {
        return driven;
    }
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
    inertia_force = graph.add(inertia_force, row.gyroscopic);
    let drive = graph.sub(inertia_force, row.force);
    graph.mul(driven, drive)
}
