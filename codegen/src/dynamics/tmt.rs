//! The TMT method: mass matrix, convective forces and generalised forces.

use super::{Derivatives, inner};
use crate::model::Model;
use crate::symbolic::Expr;

/// One row of x = T(q, t): a rotation or a coordinate of a point.
pub struct Row {
    /// T_i(q, t).
    pub position: Expr,
    /// M_i, a mass or moment of inertia; 0 for a point that only carries a load.
    pub inertia: Expr,
    /// F_i, a force or torque along the row.
    pub force: Expr,
    /// T_q of the row, n entries.
    pub jacobian: Vec<Expr>,
    /// T_t of the row.
    pub time_derivative: Expr,
    /// v = T_q q' + T_t.
    pub velocity: Expr,
    /// g = (T_q q' + T_t)_q q' + (..)_t.
    pub convective: Expr,
}

/// What moves, reduced to the generalised coordinates.
pub struct Tmt {
    /// The rows of T.
    pub rows: Vec<Row>,
    /// T_q' M T_q, n x n, symmetric.
    pub mass_matrix: Vec<Vec<Expr>>,
    /// T_q' M g, n.
    pub convective_forces: Vec<Expr>,
    /// T_q' F, n.
    pub generalized_forces: Vec<Expr>,
    /// T_q' (F - M g), n.
    pub right_hand_side: Vec<Expr>,
}

impl Tmt {
    pub(super) fn derive(model: &mut Model, derivatives: &mut Derivatives) -> Tmt {
        let mut load_rows = body_rows(model);
        add_loads(model, &mut load_rows);
        let rows: Vec<Row> = load_rows.into_iter().map(|row| differentiate(model, derivatives, row)).collect();
        let n = model.coordinates.len();
        let mut mass_matrix = vec![vec![]; n];
        for j in 0..n {
            for k in 0..=j {
                let entry = reduce(model, &rows, |row| vec![row.jacobian[j], row.inertia, row.jacobian[k]]);
                mass_matrix[j].push(entry);
            }
        }
        for j in 0..n {
            for k in j + 1..n {
                let entry = mass_matrix[k][j];
                mass_matrix[j].push(entry);
            }
        }
        let mut reduced = |factors: fn(&Row) -> Vec<Expr>| -> Vec<Expr> {
            let with_jacobian = |row: &Row, j: usize| [vec![row.jacobian[j]], factors(row)].concat();
            (0..n).map(|j| reduce(model, &rows, |row| with_jacobian(row, j))).collect()
        };
        let convective_forces = reduced(|row| vec![row.inertia, row.convective]);
        let generalized_forces = reduced(|row| vec![row.force]);
        let both = generalized_forces.iter().zip(&convective_forces);
        let right_hand_side = both.map(|(force, convective)| model.graph.sub(*force, *convective)).collect();
        Tmt { rows, mass_matrix, convective_forces, generalized_forces, right_hand_side }
    }
}

/// The sum over the rows of a product of their quantities.
fn reduce(model: &mut Model, rows: &[Row], factors: impl Fn(&Row) -> Vec<Expr>) -> Expr {
    let terms: Vec<Expr> = rows.iter().map(|row| model.graph.product(&factors(row))).collect();
    model.graph.sum(&terms)
}

/// A row before differentiation.
struct LoadRow {
    position: Expr,
    inertia: Expr,
    forces: Vec<Expr>,
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

/// Enters forces and torques at the rows they act along, or at rows of their own.
fn add_loads(model: &mut Model, rows: &mut Vec<LoadRow>) {
    let zero = model.graph.zero();
    let torques = model.torques.iter().map(|torque| (torque.angle, torque.moment));
    let forces = model.forces.iter().flat_map(|force| force.at.into_iter().zip(force.force));
    for (position, force) in torques.chain(forces) {
        match rows.iter_mut().find(|row| row.position == position) {
            Some(row) => row.forces.push(force),
            None => rows.push(LoadRow { position, inertia: zero, forces: vec![force] }),
        }
    }
}

fn differentiate(model: &mut Model, derivatives: &mut Derivatives, row: LoadRow) -> Row {
    let LoadRow { position, inertia, forces } = row;
    let jacobian = derivatives.gradient(model, position);
    let time_derivative = derivatives.by_time(model, position);
    let speeds = model.speeds();
    let moving = inner(model, &jacobian, &speeds);
    let velocity = model.graph.add(moving, time_derivative);
    let convective = derivatives.convective(model, velocity);
    let force = model.graph.sum(&forces);
    Row { position, inertia, force, jacobian, time_derivative, velocity, convective }
}
