//! Forces conjugate to auxiliary displacements, by virtual work.
//!
//! A displacement s that is held at zero takes the force R with R delta s = sum of (M x'' - F).delta x + lambda.delta
//! C, that is R = sum of (dx/ds)' (M x'' - F) + (dC/ds)' lambda at s = 0: the force of a joint, cut by s, on the parts
//! that s moves. (Kane and Levinson, Dynamics: Theory and Applications, 1985, section 4.9, who give it as an auxiliary
//! generalised speed.)

use super::rows::{Along, LoadRow, load_rows};
use super::variables::inner;
use crate::model::{Auxiliary, Event, EventStep, Level, Model};
use crate::symbolic::{Differential, Expr, Symbol, substitute, transplant};
use rustc_hash::FxHashMap;

/// The force conjugate to each auxiliary displacement, in the graph of the model.
pub(super) fn conjugate_forces(model: &mut Model) -> Vec<(Symbol, Expr)> {
    let Some(mut displaced) = model.displaced.take() else { return vec![] };
    let rows = load_rows(&mut displaced);
    let auxiliaries = std::mem::take(&mut displaced.auxiliaries);
    let forces: Vec<Expr> =
        auxiliaries.iter().map(|auxiliary| virtual_work(&mut displaced, &rows, auxiliary)).collect();
    let zero = displaced.graph.zero();
    let undisplaced: Vec<(Symbol, Expr)> =
        auxiliaries.iter().flat_map(|a| [(a.displacement, zero), (a.rate, zero)]).collect();
    let forces = substitute(&mut displaced.graph, &forces, &undisplaced);
    let same = same_symbols(&displaced, model);
    let zero = model.graph.zero();
    let forces =
        transplant(&displaced.graph, &forces, &mut model.graph, |symbol| same.get(&symbol).copied().unwrap_or(zero));
    model.auxiliaries.iter().map(|auxiliary| auxiliary.reaction).zip(forces).collect()
}

fn virtual_work(displaced: &mut Model, rows: &[LoadRow], auxiliary: &Auxiliary) -> Expr {
    let mut by_displacement = Differential::partial(&mut displaced.graph, auxiliary.displacement);
    let mut by_rate = Differential::partial(&mut displaced.graph, auxiliary.rate);
    let mut motion = displaced.time_derivative();
    let mut terms = Vec::new();
    for row in rows {
        let displacement = match row.along {
            Along::Position(position) => by_displacement.of(&mut displaced.graph, position),
            Along::Rate { velocity, .. } => by_rate.of(&mut displaced.graph, velocity),
        };
        if displaced.graph.is_zero(displacement) {
            continue;
        }
        let mut acceleration = |row: &LoadRow| match row.along {
            Along::Position(position) => {
                let velocity = motion.of(&mut displaced.graph, position);
                motion.of(&mut displaced.graph, velocity)
            }
            Along::Rate { acceleration, .. } => acceleration,
        };
        let own = acceleration(row);
        let coupled: Vec<(Expr, Expr)> =
            row.coupling.iter().map(|(other, product)| (*product, acceleration(&rows[*other]))).collect();
        let mut inertial = displaced.graph.mul(row.inertia, own);
        for (product, other) in coupled {
            let coupled = displaced.graph.mul(product, other);
            inertial = displaced.graph.add(inertial, coupled);
        }
        inertial = displaced.graph.add(inertial, row.gyroscopic);
        let mut load = displaced.graph.sum(&row.forces);
        if let Some(weight) = row.weight {
            load = displaced.graph.add(load, weight.force);
        }
        let missing = displaced.graph.sub(inertial, load);
        terms.push(displaced.graph.mul(displacement, missing));
    }
    let constraints: Vec<(Level, Expr)> = displaced.constraints.iter().map(|c| (c.level, c.value)).collect();
    let opening: Vec<Expr> = constraints
        .into_iter()
        .map(|(level, value)| match level {
            Level::Positions => by_displacement.of(&mut displaced.graph, value),
            Level::Speeds => by_rate.of(&mut displaced.graph, value),
        })
        .collect();
    let multipliers = displaced.multipliers();
    terms.push(inner(displaced, &opening, &multipliers));
    displaced.graph.sum(&terms)
}

/// The corresponding symbols of two models of the same declaration.
fn same_symbols(from: &Model, to: &mut Model) -> FxHashMap<Symbol, Expr> {
    let mut pairs = vec![(from.time, to.time)];
    for (a, b) in from.coordinates.iter().zip(&to.coordinates) {
        pairs.extend([(a.position, b.position), (a.speed, b.speed), (a.acceleration, b.acceleration)]);
    }
    pairs.extend(from.parameters.iter().zip(&to.parameters).map(|(a, b)| (a.symbol, b.symbol)));
    pairs.extend(from.inputs.iter().zip(&to.inputs).map(|(a, b)| (a.symbol, b.symbol)));
    pairs.extend(from.constraints.iter().zip(&to.constraints).map(|(a, b)| (a.multiplier, b.multiplier)));
    pairs.into_iter().map(|(a, b)| (a, to.graph.variable(b))).collect()
}

/// Puts the conjugate forces in their places.
pub(super) fn enter(model: &mut Model, values: &mut [Expr]) {
    let forces = conjugate_forces(model);
    if forces.is_empty() {
        return;
    }
    let entered = substitute(&mut model.graph, values, &forces);
    values.copy_from_slice(&entered);
    for (output, value) in model.outputs.iter_mut().zip(entered) {
        output.value = value;
    }
    let values: Vec<Expr> = of_events(&mut model.events).into_iter().map(|value| *value).collect();
    let entered = substitute(&mut model.graph, &values, &forces);
    of_events(&mut model.events).into_iter().zip(entered).for_each(|(value, entered)| *value = entered);
}

/// Conditions of events, and what their actions need.
fn of_events(events: &mut [Event]) -> Vec<&mut Expr> {
    let mut values = Vec::new();
    for event in events {
        values.push(&mut event.value);
        for step in &mut event.steps {
            match step {
                EventStep::Set(settings) => values.extend(settings.iter_mut().map(|(_, value)| value)),
                EventStep::Impact(impacts) => values.extend(impacts.iter_mut().map(|(_, value)| value)),
                EventStep::Stop(_) | EventStep::Switch(_) => {}
            }
        }
    }
    values
}
