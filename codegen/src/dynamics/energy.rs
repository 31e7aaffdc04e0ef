//! Kinetic energy, and the power that changes it.

use super::intermediates::total_time_derivative;
use super::variables::{Variables, inner};
use super::{Constraints, Row, Tmt};
use crate::model::Model;
use crate::symbolic::{Expr, Number};

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
        model: &mut Model,
        variables: &Variables,
        drifts: &[Expr],
        tmt: &Tmt,
        constraints: &Constraints,
    ) -> Energy {
        let (mut twice_kinetic, mut power) = (Vec::new(), Vec::new());
        for row in &tmt.rows {
            let squared = model.graph.mul(row.motion.velocity, row.motion.velocity);
            twice_kinetic.push(model.graph.mul(row.inertia, squared));
            for (other, product) in &row.coupling {
                let velocities = [row.motion.velocity, *product, tmt.rows[*other].motion.velocity];
                twice_kinetic.push(model.graph.product(&velocities));
            }
            power.push(model.graph.mul(row.force, row.motion.velocity));
            power.push(drive_power(model, variables, drifts, &tmt.rows, row));
        }
        let is_driven = drifts.iter().chain(tmt.rows.iter().map(|row| &row.motion.time_derivative));
        let is_driven = is_driven.chain(&constraints.time_derivative).any(|by_time| !model.graph.is_zero(*by_time));
        let speeds: Vec<Expr> = variables.speeds.iter().map(|speed| model.graph.variable(*speed)).collect();
        let power_along_variables = (!is_driven).then(|| inner(model, &tmt.generalized_forces, &speeds));
        for (i, multiplier) in model.multipliers().into_iter().enumerate() {
            let carried = inner(model, drifts, &constraints.jacobian[i]);
            let driven = model.graph.add(carried, constraints.time_derivative[i]);
            power.push(model.graph.mul(multiplier, driven));
        }
        let twice = model.graph.sum(&twice_kinetic);
        Energy {
            kinetic: model.graph.scale(&Number::HALF, twice),
            power: model.graph.sum(&power),
            power_along_variables,
        }
    }
}

/// T_t (M x'' - F): the power of a drive that moves the row in time.
fn drive_power(model: &mut Model, variables: &Variables, drifts: &[Expr], rows: &[Row], row: &Row) -> Expr {
    let driven = total_time_derivative(model, &row.motion, drifts);
    if model.graph.is_zero(driven) {
        return driven;
    }
    let accelerations: Vec<Expr> = variables.accelerations.iter().map(|a| model.graph.variable(*a)).collect();
    let acceleration = |model: &mut Model, row: &Row| {
        let moving = inner(model, &row.motion.jacobian, &accelerations);
        model.graph.add(moving, row.motion.convective)
    };
    let own = acceleration(model, row);
    let mut inertia_force = model.graph.mul(row.inertia, own);
    for (other, product) in &row.coupling {
        let coupled = acceleration(model, &rows[*other]);
        let coupled = model.graph.mul(*product, coupled);
        inertia_force = model.graph.add(inertia_force, coupled);
    }
    inertia_force = model.graph.add(inertia_force, row.gyroscopic);
    let drive = model.graph.sub(inertia_force, row.force);
    model.graph.mul(driven, drive)
}
