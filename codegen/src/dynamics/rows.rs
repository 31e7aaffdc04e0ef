//! The rows of x = T(q, t) with their inertias and loads, before differentiation.

use crate::model::Model;
use crate::symbolic::Expr;

/// A row before differentiation.
pub(super) struct LoadRow {
    pub(super) position: Expr,
    pub(super) inertia: Expr,
    pub(super) forces: Vec<Expr>,
}

/// The rows of bodies and loads.
pub(super) fn load_rows(model: &mut Model) -> Vec<LoadRow> {
    let mut rows = body_rows(model);
    add_loads(model, &mut rows);
    rows
}

/// The rotation and position of each body, with the weight of its mass.
fn body_rows(model: &mut Model) -> Vec<LoadRow> {
    let mut rows = Vec::new();
    for body in &model.bodies {
        if let Some((inertia, angle)) = body.rotation {
            rows.push(LoadRow { position: angle, inertia, forces: vec![] });
        }
        if let Some((mass, at)) = body.mass {
            for (axis, position) in at.into_iter().enumerate() {
                let weight = model.gravity.map(|gravity| model.graph.mul(mass, gravity[axis]));
                rows.push(LoadRow { position, inertia: mass, forces: weight.into_iter().collect() });
            }
        }
    }
    rows
}

/// Enters loads at the rows they act along, or at rows of their own.
fn add_loads(model: &mut Model, rows: &mut Vec<LoadRow>) {
    let zero = model.graph.zero();
    let efforts = model.efforts.iter().map(|effort| (effort.along, effort.force));
    let forces = model.forces.iter().flat_map(|force| force.at.into_iter().zip(force.force));
    for (position, force) in efforts.chain(forces) {
        match rows.iter_mut().find(|row| row.position == position) {
            Some(row) => row.forces.push(force),
            None => rows.push(LoadRow { position, inertia: zero, forces: vec![force] }),
        }
    }
}
