//! Lagrange's equations, as a check of the TMT method.
//!
//! The left-hand sides come from the kinetic energy by the Euler-Lagrange operator, the forces from the power of the
//! loads, and the constraints from their second rate along the motion, whose coefficients of q'' are C_q. It uses
//! neither T_q' M T_q, nor convective accelerations, nor the derivatives with respect to coordinates that the TMT
//! method takes; and in space neither frames nor angular velocities: rotational energy and power follow from the
//! rotation matrix.
//!
//! It shares with the TMT method the resolved model (names, units, joints, `let`s, and in constraints between speeds
//! the velocities that the declaration writes) and the engine's derivatives and rewriting.

use crate::model::{Attitude, Body, Level, Model, Pushed};
use crate::symbolic::{Differential, Expr, Graph, Number, substitute};

/// `d/dt (dE/dq') - dE/dq = Q - C_q' lambda`, brought to the form `mass_matrix q'' + C_q' lambda = right_hand_side`, and
/// `C'' = C_q q'' + convective = 0`.
pub struct Lagrange {
    /// The coefficients of q'', n x n.
    pub mass_matrix: Vec<Vec<Expr>>,
    /// Q minus the rest of the Euler-Lagrange operator, n.
    pub right_hand_side: Vec<Expr>,
    /// C_q, m x n, as if every constraint were active; w_q' for a row w = 0 between speeds.
    pub constraint_jacobian: Vec<Vec<Expr>>,
    /// C'' without accelerations, m; w' for a row between speeds.
    pub constraint_convective: Vec<Expr>,
}

/// Lagrange's equations of a model.
pub fn lagrange(graph: &mut Graph, model: &Model) -> Lagrange {
    let mut rate = model.time_derivative(graph);
    let energy = kinetic_energy(graph, model, &mut rate);
    let forces = generalized_forces(graph, model, &mut rate);
    let mut result = Lagrange {
        mass_matrix: vec![],
        right_hand_side: vec![],
        constraint_jacobian: vec![],
        constraint_convective: vec![],
    };
    for (j, force) in forces.into_iter().enumerate() {
        let (position, speed) = (model.coordinates[j].position, model.coordinates[j].speed);
        let momentum = Differential::partial(graph, speed).of(graph, energy);
        let momentum_rate = rate.of(graph, momentum);
        let by_position = Differential::partial(graph, position).of(graph, energy);
        let operator = graph.sub(momentum_rate, by_position);
        let (coefficients, rest) = linear_in_accelerations(graph, model, operator);
        result.mass_matrix.push(coefficients);
        result.right_hand_side.push(graph.sub(force, rest));
    }
    for row in 0..model.constraints.len() {
        let (level, value) = (model.constraints[row].level, model.constraints[row].value);
        let speed = match level {
            Level::Positions => rate.of(graph, value),
            Level::Speeds => value,
        };
        let acceleration = rate.of(graph, speed);
        let (coefficients, rest) = linear_in_accelerations(graph, model, acceleration);
        result.constraint_jacobian.push(coefficients);
        result.constraint_convective.push(rest);
    }
    result
}

/// The coefficients of q'' in expressions linear in it (their derivatives), and the rest (their value at 0).
fn linear_in_accelerations(graph: &mut Graph, model: &Model, expr: Expr) -> (Vec<Expr>, Expr) {
    let accelerations: Vec<_> = model.coordinates.iter().map(|c| c.acceleration).collect();
    let coefficients = accelerations.iter().map(|a| Differential::partial(graph, *a).of(graph, expr)).collect();
    let zero = graph.zero();
    let at_rest: Vec<_> = accelerations.iter().map(|a| (*a, zero)).collect();
    (coefficients, substitute(graph, &[expr], &at_rest)[0])
}

/// `sum of m (x'^2 + y'^2)/2 + J phi'^2/2`, each rate by the chain rule.
fn kinetic_energy(graph: &mut Graph, model: &Model, rate: &mut Differential) -> Expr {
    let moving: Vec<(Expr, Expr)> = model
        .bodies
        .iter()
        .flat_map(|body| {
            let mass = body.mass.iter().flat_map(|(mass, at)| at.iter().map(|x| (*mass, *x)));
            mass.chain(body.rotation).collect::<Vec<_>>()
        })
        .chain(model.norms.iter().map(|norm| (norm.inertia, norm.square)))
        .collect();
    let mut terms = Vec::new();
    for (inertia, position) in moving {
        let speed = rate.of(graph, position);
        let squared = graph.integer_power(speed, 2);
        terms.push((graph.mul(inertia, squared), Number::HALF));
    }
    for attitude in model.bodies.iter().filter_map(|body| body.attitude.as_ref()) {
        let energy = turning_energy(graph, attitude, rate);
        terms.push((energy, Number::HALF));
    }
    graph.linear_combination(&terms)
}

/// tr(R' S R'^T), twice the rotational energy, with S = tr(J)/2 - J of the distribution of mass; no angular velocity is
/// used.
fn turning_energy(graph: &mut Graph, attitude: &Attitude, rate: &mut Differential) -> Expr {
    let inertia = &attitude.inertia;
    let trace = graph.sum(&inertia.moments);
    let half = graph.scale(&Number::HALF, trace);
    let mut terms = Vec::new();
    for row in &attitude.matrix {
        let rates = row.map(|entry| rate.of(graph, entry));
        for i in 0..3 {
            for k in 0..3 {
                let moment = inertia.entry(i, k);
                let mass = if i == k { graph.sub(half, moment) } else { graph.neg(moment) };
                terms.push(graph.product(&[rates[i], mass, rates[k]]));
            }
        }
    }
    graph.sum(&terms)
}

/// Q_j: the derivative of the power of the loads with respect to q'_j, at fixed loads.
fn generalized_forces(graph: &mut Graph, model: &Model, rate: &mut Differential) -> Vec<Expr> {
    let mut works: Vec<(Expr, Expr)> = Vec::new();
    works.extend(model.forces.iter().flat_map(|force| force.force.iter().copied().zip(force.at.iter().copied())));
    works.extend(model.efforts.iter().map(|effort| (effort.force, effort.along)));
    if let Some(gravity) = &model.gravity {
        for (mass, at) in model.bodies.iter().filter_map(|body| body.mass.as_ref()) {
            works.extend(at.iter().zip(gravity).map(|(x, g)| (graph.mul(*mass, *g), *x)));
        }
    }
    for push in &model.pushes {
        works.extend(pushed(graph, &model.bodies, &push.in_world));
    }
    let speeds: Vec<_> = model.coordinates.iter().map(|c| c.speed).collect();
    speeds
        .into_iter()
        .map(|speed| {
            let mut by_speed = Differential::partial(graph, speed);
            let terms: Vec<Expr> = works
                .iter()
                .map(|(force, position)| {
                    let velocity = rate.of(graph, *position);
                    let partial = by_speed.of(graph, velocity);
                    graph.mul(*force, partial)
                })
                .collect();
            graph.sum(&terms)
        })
        .collect()
}

/// Forces with what they work along. A torque M acts on a body with rotation R as half of M x r on each column r of R,
/// since the body turns by half the sum of r x dr.
fn pushed(graph: &mut Graph, bodies: &[Body], push: &Pushed) -> Vec<(Expr, Expr)> {
    match push {
        Pushed::Force { force, at } => force.iter().copied().zip(at.iter().copied()).collect(),
        Pushed::Torque { moment, body } => {
            let Some(Attitude { matrix, .. }) = &bodies[*body].attitude else { return vec![] };
            let mut works = Vec::new();
            for (column, i) in (0..3).flat_map(|column| (0..3).map(move |i| (column, i))) {
                let (j, k) = ((i + 1) % 3, (i + 2) % 3);
                let ahead = graph.mul(moment[j], matrix[k][column]);
                let back = graph.mul(moment[k], matrix[j][column]);
                let arm = graph.sub(ahead, back);
                works.push((graph.scale(&Number::HALF, arm), matrix[i][column]));
            }
            works
        }
    }
}
