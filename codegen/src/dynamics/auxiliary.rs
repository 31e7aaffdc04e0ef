//! Forces conjugate to auxiliary displacements, by virtual work.
//!
//! A displacement s that is held at zero takes the force R with R delta s = sum of (M x'' - F).delta x + lambda.delta
//! C, that is R = sum of (dx/ds)' (M x'' - F) + (dC/ds)' lambda at s = 0: the force of a joint, cut by s, on the parts
//! that s moves. (Kane and Levinson, Dynamics: Theory and Applications, 1985, section 4.9, who give it as an auxiliary
//! generalised speed.)

use super::events::Events;
use super::outputs::Outputs;
use super::rows::{Along, LoadRow, load_rows};
use super::variables::inner;
use crate::model::{Auxiliary, Displaced, Level, Model};
use crate::symbolic::{Differential, Expr, Graph, Symbol, substitute, transplant};
use rustc_hash::FxHashMap;

/// The force conjugate to each auxiliary displacement, in the graph of the model. `displaced` is the same model with auxiliary
/// displacements as variables.
fn conjugate_forces(graph: &mut Graph, model: &Model, displaced: Displaced) -> Vec<(Symbol, Expr)> {
    let Displaced { model: displaced, graph: mut other } = displaced;
    let rows = load_rows(&mut other, &displaced);
    let auxiliaries = &displaced.auxiliaries;
    let forces: Vec<Expr> =
        auxiliaries.iter().map(|auxiliary| virtual_work(&mut other, &displaced, &rows, auxiliary)).collect();
    let zero = other.zero();
    let undisplaced: Vec<(Symbol, Expr)> =
        auxiliaries.iter().flat_map(|a| [(a.displacement, zero), (a.rate, zero)]).collect();
    let forces = substitute(&mut other, &forces, &undisplaced);
    let same = same_symbols(&displaced, model, graph);
    let zero = graph.zero();
    let forces = transplant(&other, &forces, graph, |symbol| same.get(&symbol).copied().unwrap_or(zero));
    model.auxiliaries.iter().map(|auxiliary| auxiliary.reaction).zip(forces).collect()
}

fn virtual_work(graph: &mut Graph, displaced: &Model, rows: &[LoadRow], auxiliary: &Auxiliary) -> Expr {
    let mut by_displacement = Differential::partial(graph, auxiliary.displacement);
    let mut by_rate = Differential::partial(graph, auxiliary.rate);
    let mut motion = displaced.time_derivative(graph);
    let mut terms = Vec::new();
    for row in rows {
        let displacement = match row.along {
            Along::Position(position) => by_displacement.of(graph, position),
            Along::Rate { velocity, .. } => by_rate.of(graph, velocity),
        };
        if graph.is_zero(displacement) {
            continue;
        }
        let mut acceleration = |row: &LoadRow| match row.along {
            Along::Position(position) => {
                let velocity = motion.of(graph, position);
                motion.of(graph, velocity)
            }
            Along::Rate { acceleration, .. } => acceleration,
        };
        let own = acceleration(row);
        let coupled: Vec<(Expr, Expr)> =
            row.coupling.iter().map(|(other, product)| (*product, acceleration(&rows[*other]))).collect();
        let mut inertial = graph.mul(row.inertia, own);
        for (product, other) in coupled {
            let coupled = graph.mul(product, other);
            inertial = graph.add(inertial, coupled);
        }
        inertial = graph.add(inertial, row.gyroscopic);
        let mut load = graph.sum(&row.forces);
        if let Some(weight) = row.weight {
            load = graph.add(load, weight.force);
        }
        let missing = graph.sub(inertial, load);
        terms.push(graph.mul(displacement, missing));
    }
    let constraints: Vec<(Level, Expr)> = displaced.constraints.iter().map(|c| (c.level, c.value)).collect();
    let opening: Vec<Expr> = constraints
        .into_iter()
        .map(|(level, value)| match level {
            Level::Positions => by_displacement.of(graph, value),
            Level::Speeds => by_rate.of(graph, value),
        })
        .collect();
    let multipliers = displaced.multipliers(graph);
    terms.push(inner(graph, &opening, &multipliers));
    graph.sum(&terms)
}

/// The corresponding symbols of two models of the same declaration.
fn same_symbols(from: &Model, to: &Model, graph: &mut Graph) -> FxHashMap<Symbol, Expr> {
    let mut pairs = vec![(from.time, to.time)];
    for (a, b) in from.coordinates.iter().zip(&to.coordinates) {
        pairs.extend([(a.position, b.position), (a.speed, b.speed), (a.acceleration, b.acceleration)]);
    }
    pairs.extend(from.parameters.iter().zip(&to.parameters).map(|(a, b)| (a.symbol, b.symbol)));
    pairs.extend(from.inputs.iter().zip(&to.inputs).map(|(a, b)| (a.symbol, b.symbol)));
    pairs.extend(from.constraints.iter().zip(&to.constraints).map(|(a, b)| (a.multiplier, b.multiplier)));
    pairs.into_iter().map(|(a, b)| (a, graph.variable(b))).collect()
}

/// Puts the conjugate forces in their places.
pub(super) fn enter(
    graph: &mut Graph,
    model: &Model,
    displaced: Option<Displaced>,
    outputs: &mut Outputs,
    events: &mut Events,
) {
    let Some(displaced) = displaced else { return };
    let forces = conjugate_forces(graph, model, displaced);
    outputs.values = substitute(graph, &outputs.values, &forces);
    let entered = substitute(graph, &[events.conditions.as_slice(), &events.settings].concat(), &forces);
    let (conditions, settings) = entered.split_at(events.conditions.len());
    (events.conditions, events.settings) = (conditions.to_vec(), settings.to_vec());
}
