//! Lagrange's equations, as a check of the TMT method.
//!
//! Everything here comes from two scalars, the kinetic energy `sum of m v.v / 2` and the power of the loads, by
//! the Euler-Lagrange operator; neither T_q' M T_q nor the convective accelerations are used.

use crate::model::{Attitude, Model};
use crate::symbolic::{Differential, Expr, Graph, Number, substitute};

/// `d/dt (dE/dq') - dE/dq = Q`, brought to the form `mass_matrix q'' = right_hand_side`.
pub struct Lagrange {
    /// The coefficients of q'', n x n.
    pub mass_matrix: Vec<Vec<Expr>>,
    /// Q minus the rest of the Euler-Lagrange operator, n.
    pub right_hand_side: Vec<Expr>,
}

/// Lagrange's equations of a model without its constraints.
pub fn lagrange(model: &mut Model) -> Lagrange {
    let mut rate = model.time_derivative();
    let energy = kinetic_energy(model, &mut rate);
    let forces = generalized_forces(model, &mut rate);
    let accelerations: Vec<_> = model.coordinates.iter().map(|c| c.acceleration).collect();
    let mut result = Lagrange { mass_matrix: vec![], right_hand_side: vec![] };
    for (j, force) in forces.into_iter().enumerate() {
        let graph = &mut model.graph;
        let (position, speed) = (model.coordinates[j].position, model.coordinates[j].speed);
        let momentum = Differential::partial(graph, speed).of(graph, energy);
        let momentum_rate = rate.of(graph, momentum);
        let by_position = Differential::partial(graph, position).of(graph, energy);
        let operator = graph.sub(momentum_rate, by_position);
        // The operator is linear in q'': its coefficients are its derivatives, the rest is its value at 0.
        let coefficients = accelerations.iter().map(|a| Differential::partial(graph, *a).of(graph, operator));
        result.mass_matrix.push(coefficients.collect());
        let zero = graph.zero();
        let at_rest: Vec<_> = accelerations.iter().map(|a| (*a, zero)).collect();
        let rest = substitute(graph, &[operator], &at_rest)[0];
        result.right_hand_side.push(graph.sub(force, rest));
    }
    result
}

/// `sum of m (x'^2 + y'^2)/2 + J phi'^2/2`, each rate by the chain rule.
fn kinetic_energy(model: &mut Model, rate: &mut Differential) -> Expr {
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
        let speed = rate.of(&mut model.graph, position);
        let squared = model.graph.integer_power(speed, 2);
        terms.push((model.graph.mul(inertia, squared), Number::HALF));
    }
    for attitude in model.bodies.iter().filter_map(|body| body.attitude.as_ref()) {
        let energy = turning_energy(&mut model.graph, attitude, rate);
        terms.push((energy, Number::HALF));
    }
    model.graph.linear_combination(&terms)
}

/// tr(R' S R'^T), twice the energy of turning, with S = tr(J)/2 - J of the distribution of mass; no angular velocity is
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

/// Q_j: how fast the work of the loads grows with q'_j. The loads themselves do not count as changing.
fn generalized_forces(model: &mut Model, rate: &mut Differential) -> Vec<Expr> {
    let mut works: Vec<(Expr, Expr)> = Vec::new();
    works.extend(model.forces.iter().flat_map(|force| force.force.iter().copied().zip(force.at.iter().copied())));
    works.extend(model.efforts.iter().map(|effort| (effort.force, effort.along)));
    if let Some(gravity) = &model.gravity {
        for (mass, at) in model.bodies.iter().filter_map(|body| body.mass.as_ref()) {
            works.extend(at.iter().zip(gravity).map(|(x, g)| (model.graph.mul(*mass, *g), *x)));
        }
    }
    let pushes: Vec<(Expr, Expr)> =
        model.pushes.iter().flat_map(|push| push.effort.into_iter().zip(push.along.velocity)).collect();
    let speeds: Vec<_> = model.coordinates.iter().map(|c| c.speed).collect();
    speeds
        .into_iter()
        .map(|speed| {
            let mut by_speed = Differential::partial(&mut model.graph, speed);
            let terms: Vec<Expr> = works
                .iter()
                .map(|(force, position)| {
                    let velocity = rate.of(&mut model.graph, *position);
                    let partial = by_speed.of(&mut model.graph, velocity);
                    model.graph.mul(*force, partial)
                })
                .collect();
            let pushed = pushes.iter().map(|(effort, velocity)| {
                let partial = by_speed.of(&mut model.graph, *velocity);
                model.graph.mul(*effort, partial)
            });
            let terms: Vec<Expr> = terms.into_iter().chain(pushed.collect::<Vec<_>>()).collect();
            model.graph.sum(&terms)
        })
        .collect()
}
