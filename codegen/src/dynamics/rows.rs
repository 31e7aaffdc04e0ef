//! The rows of x = T(q, t) with their inertias and loads, before differentiation.
//!
//! Points that loads act at have rows too, with zero inertia. So forces, torques and weights all act along rows, and
//! the reduced equations need no other case; a row that exists is reused. A load along a scalar is a row of T as well:
//! a spring acts along its length, a potential V is a force of -1 along V, and a dissipation function gives a force
//! along each coordinate. Work and power need no special case for them.
//!
//! The angular velocity of a spatial body is linear in the speeds but is no derivative of a position. Such a row is a
//! velocity with its acceleration, in components of the body's frame, where the inertia is constant. The terms w x J w
//! and the products of inertia are all that this adds to the equations. The mass of a body moves in its frame too, or
//! in the world's where the centre of mass is declared there.

use crate::model::{Attitude, Model, Rates};
use crate::symbolic::{Expr, Graph};

/// A row before differentiation.
#[derive(Clone)]
pub(super) struct LoadRow {
    pub(super) along: Along,
    pub(super) inertia: Expr,
    /// Inertias that it shares with other rows, by index: products of inertia.
    pub(super) coupling: Vec<(usize, Expr)>,
    /// The force of its inertia without acceleration: its component of w x J w.
    pub(super) gyroscopic: Expr,
    /// Weight, apart from other forces.
    pub(super) weight: Option<Weight>,
    pub(super) forces: Vec<Expr>,
}

/// The kind of a row.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Along {
    /// A quantity x(q, t).
    Position(Expr),
    /// A speed A q' + b that need not be a rate, with its acceleration.
    Rate {
        velocity: Expr,
        acceleration: Expr,
        /// Angular velocities of the frame with velocities in it: the acceleration is the rate of the velocity plus the
        /// component of w x v, the product of the first pair less that of the second.
        transport: [(Expr, Expr); 2],
    },
}

impl Along {
    /// A component of a moving quantity in a frame.
    fn component(rates: &Rates, i: usize) -> Along {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        let Rates { velocity, acceleration, turning } = rates;
        let transport = [(turning[j], velocity[k]), (turning[k], velocity[j])];
        Along::Rate { velocity: velocity[i], acceleration: acceleration[i], transport }
    }
}

/// Weight along a row.
#[derive(Clone, Copy)]
pub(super) struct Weight {
    /// The force.
    pub(super) force: Expr,
    /// The row's acceleration less that of free fall, which is shorter than both.
    pub(super) proper: Expr,
}

impl LoadRow {
    fn new(along: Along, inertia: Expr, zero: Expr) -> LoadRow {
        LoadRow { along, inertia, coupling: vec![], gyroscopic: zero, weight: None, forces: vec![] }
    }

    /// The expressions of the row.
    pub(super) fn quantity(&self) -> Expr {
        match self.along {
            Along::Position(x) | Along::Rate { velocity: x, .. } => x,
        }
    }
}

/// The rows of bodies and loads.
pub(super) fn load_rows(graph: &mut Graph, model: &Model) -> Vec<LoadRow> {
    load_rows_besides(graph, model, &[])
}

/// The same without those of some bodies.
pub(super) fn load_rows_besides(graph: &mut Graph, model: &Model, bodies: &[usize]) -> Vec<LoadRow> {
    let mut rows = body_rows(graph, model, bodies);
    let zero = graph.zero();
    rows.extend(model.norms.iter().map(|norm| LoadRow::new(Along::Position(norm.square), norm.inertia, zero)));
    add_loads(graph, model, &mut rows);
    rows
}

/// The rotation and position of each body, with the weight of its mass.
fn body_rows(graph: &mut Graph, model: &Model, left_out: &[usize]) -> Vec<LoadRow> {
    let mut rows = Vec::new();
    let zero = graph.zero();
    for (_, body) in model.bodies.iter().enumerate().filter(|(at, _)| !left_out.contains(at)) {
        if let Some((inertia, angle)) = body.rotation {
            rows.push(LoadRow::new(Along::Position(angle), inertia, zero));
        }
        if let Some(attitude) = &body.attitude {
            add_spatial(graph, &mut rows, attitude, body.mass.as_ref().map(|(mass, _)| *mass));
            continue;
        }
        if let Some((mass, at)) = &body.mass {
            for (axis, position) in at.iter().enumerate() {
                let weight = model.gravity.as_ref().map(|gravity| graph.mul(*mass, gravity[axis]));
                let mut row = LoadRow::new(Along::Position(*position), *mass, zero);
                row.forces.extend(weight);
                rows.push(row);
            }
        }
    }
    rows
}

/// Three components of the angular velocity and three of the velocity of the centre of mass, all in the body's frame.
fn add_spatial(graph: &mut Graph, rows: &mut Vec<LoadRow>, attitude: &Attitude, mass: Option<Expr>) {
    let (first, zero, spin) = (rows.len(), graph.zero(), attitude.spin);
    let momentum: [Expr; 3] = std::array::from_fn(|i| {
        let terms: Vec<Expr> = (0..3).map(|k| graph.mul(attitude.inertia.entry(i, k), spin.velocity[k])).collect();
        graph.sum(&terms)
    });
    for i in 0..3 {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        let (ahead, back) = (graph.mul(spin.velocity[j], momentum[k]), graph.mul(spin.velocity[k], momentum[j]));
        let mut row = LoadRow::new(Along::component(&spin, i), attitude.inertia.moments[i], zero);
        row.gyroscopic = graph.sub(ahead, back);
        let products = [j, k].map(|other| (first + other, attitude.inertia.entry(i, other)));
        row.coupling.extend(products.into_iter().filter(|(_, product)| !graph.is_zero(*product)));
        rows.push(row);
    }
    let (Some(mass), Some(centre)) = (mass, attitude.centre) else { return };
    for i in 0..3 {
        let mut row = LoadRow::new(Along::component(&centre, i), mass, zero);
        row.weight =
            attitude.fall.map(|fall| Weight { force: graph.mul(mass, fall.gravity[i]), proper: fall.proper[i] });
        rows.push(row);
    }
}

/// Enters loads at the rows they act along, or at rows of their own.
fn add_loads(graph: &mut Graph, model: &Model, rows: &mut Vec<LoadRow>) {
    let zero = graph.zero();
    let efforts = model.efforts.iter().map(|effort| (Along::Position(effort.along), effort.force));
    let forces = model.forces.iter().flat_map(|force| force.at.iter().zip(&force.force));
    let forces = forces.map(|(position, force)| (Along::Position(*position), *force));
    let pushes =
        model.pushes.iter().flat_map(|push| (0..3).map(|i| (Along::component(&push.along, i), push.effort[i])));
    for (along, force) in efforts.chain(forces).chain(pushes) {
        match rows.iter_mut().find(|row| row.along == along) {
            Some(row) => row.forces.push(force),
            None => {
                let mut row = LoadRow::new(along, zero, zero);
                row.forces.push(force);
                rows.push(row);
            }
        }
    }
}
