//! Inverse dynamics: the forces that a given motion takes.
//!
//! With f = M x'' - F of each row of T, the forces along the coordinates are T_q' f: the derivative of f.v with respect to the
//! speeds at fixed f. Taken backwards through the expressions of v it passes each force on to what its velocity was made
//! of, so that along a chain of bodies it is the second half of the recursive Newton-Euler equations (Luh, Walker and Paul
//! 1980; Featherstone, Rigid Body Dynamics Algorithms, 2008, section 5.3), and T_q is never formed.

use super::rows::{Along, LoadRow};
use super::shorthands::Shorthands;
use crate::model::Model;
use crate::symbolic::{Differential, Expr, Graph, Node, Number, Symbol, substitute};
use std::collections::BTreeMap;

/// The forces that a motion takes.
pub struct Inverse {
    /// q'' of that motion, n: variables distinct from those that the equations of motion are solved for.
    pub accelerations: Vec<Symbol>,
    /// M q'' + h - Q, n.
    pub forces: Vec<Expr>,
}

/// None if a velocity is not a polynomial of speeds.
pub(super) fn derive(graph: &mut Graph, model: &Model, rows: &[LoadRow]) -> Option<Inverse> {
    let mut motion = model.time_derivative(graph);
    let pairs = velocities_and_forces(graph, &mut motion, rows);
    let forces = along_coordinates(graph, model, &pairs, &mut Shorthands::default())?;
    let accelerations: Vec<Symbol> =
        model.coordinates.iter().map(|c| graph.symbol(&format!("{}_ddot", c.name))).collect();
    let given: Vec<(Symbol, Expr)> = model
        .coordinates
        .iter()
        .zip(&accelerations)
        .map(|(c, given)| (c.acceleration, graph.variable(*given)))
        .collect();
    let forces = substitute(graph, &forces, &given);
    Some(Inverse { accelerations, forces })
}

/// The velocity along each row with the force that its motion takes.
pub(super) fn velocities_and_forces(
    graph: &mut Graph,
    motion: &mut Differential,
    rows: &[LoadRow],
) -> Vec<(Expr, Expr)> {
    let moving: Vec<(Expr, Expr)> = rows.iter().map(|row| motion_of(graph, motion, row)).collect();
    let accelerations: Vec<Expr> = moving.iter().map(|(_, acceleration)| *acceleration).collect();
    let forces: Vec<Expr> = rows.iter().enumerate().map(|(i, row)| needed(graph, row, i, &accelerations)).collect();
    moving.into_iter().map(|(velocity, _)| velocity).zip(forces).collect()
}

/// Velocity and acceleration along a row.
fn motion_of(graph: &mut Graph, motion: &mut Differential, row: &LoadRow) -> (Expr, Expr) {
    match row.along {
        Along::Rate { velocity, acceleration, .. } => (velocity, acceleration),
        Along::Position(position) => {
            let velocity = motion.of(graph, position);
            (velocity, motion.of(graph, velocity))
        }
    }
}

/// M x'' - F.
fn needed(graph: &mut Graph, row: &LoadRow, i: usize, accelerations: &[Expr]) -> Expr {
    let applied = graph.sum(&row.forces);
    let acceleration = row.weight.map_or(accelerations[i], |weight| weight.proper);
    let mut terms = vec![graph.mul(row.inertia, acceleration), row.gyroscopic];
    terms.extend(row.coupling.iter().map(|(k, product)| graph.mul(*product, accelerations[*k])));
    let inertial = graph.sum(&terms);
    graph.sub(inertial, applied)
}

/// The derivatives of the sum of `force*velocity` with respect to the speeds, at fixed forces; none if a velocity is not a
/// polynomial of speeds. Shorthands pass their forces on, under names, to what they stand for.
pub(super) fn along_coordinates(
    graph: &mut Graph,
    model: &Model,
    pairs: &[(Expr, Expr)],
    shorthands: &mut Shorthands,
) -> Option<Vec<Expr>> {
    let speeds: Vec<Symbol> = model.coordinates.iter().map(|c| c.speed).collect();
    let depends = depending(graph, &speeds, pairs, shorthands);
    let mut passed: BTreeMap<Expr, Vec<Expr>> = BTreeMap::new();
    for (velocity, force) in pairs {
        passed.entry(*velocity).or_default().push(*force);
    }
    let zero = graph.zero();
    let mut found = vec![zero; speeds.len()];
    // Expressions stand after their operands.
    while let Some((expr, forces)) = passed.pop_last() {
        if !depends[&expr] {
            continue;
        }
        let force = graph.sum(&forces);
        if let Some(definition) = definition(graph, shorthands, expr) {
            passed.entry(definition).or_default().push(shorthands.named(graph, force));
            continue;
        }
        for (operand, factor) in parts(graph, expr, &depends)? {
            let share = graph.mul(factor, force);
            passed.entry(operand).or_default().push(share);
        }
        if let Node::Symbol(symbol) = graph.node(expr)
            && let Some(at) = speeds.iter().position(|speed| speed == symbol)
        {
            found[at] = force;
        }
    }
    Some(found)
}

/// What a variable stands for, if it is a shorthand.
fn definition(graph: &Graph, shorthands: &Shorthands, expr: Expr) -> Option<Expr> {
    match graph.node(expr) {
        Node::Symbol(symbol) => shorthands.definition(*symbol),
        _ => None,
    }
}

/// Whether speeds occur in an expression, for all that velocities are made of.
fn depending(
    graph: &Graph,
    speeds: &[Symbol],
    pairs: &[(Expr, Expr)],
    shorthands: &Shorthands,
) -> BTreeMap<Expr, bool> {
    let definitions = shorthands.definitions().iter().map(|(_, definition)| *definition);
    let roots: Vec<Expr> = pairs.iter().map(|(velocity, _)| *velocity).chain(definitions).collect();
    let mut depends: BTreeMap<Expr, bool> = BTreeMap::new();
    // Variables of shorthands stand after what these stand for.
    for expr in graph.reachable(&roots) {
        let own = matches!(graph.node(expr), Node::Symbol(symbol) if speeds.contains(symbol));
        let mut operands = graph.operands(expr).chain(definition(graph, shorthands, expr));
        let found = own || operands.any(|operand| depends[&operand]);
        depends.insert(expr, found);
    }
    depends
}

/// The operands that speeds occur in, each with the derivative with respect to it.
fn parts(graph: &mut Graph, expr: Expr, depends: &BTreeMap<Expr, bool>) -> Option<Vec<(Expr, Expr)>> {
    match graph.node(expr).clone() {
        Node::Symbol(_) => Some(vec![]),
        Node::Sum { terms, .. } => {
            let moving = terms.iter().filter(|(term, _)| depends[term]);
            Some(moving.map(|(term, coefficient)| (*term, graph.number(coefficient.clone()))).collect())
        }
        Node::Product { coefficient, factors } => {
            let moving: Vec<usize> = (0..factors.len()).filter(|at| depends[&factors[*at].0]).collect();
            // Velocities are linear in the speeds: in each product one factor is.
            let [at] = moving[..] else { return None };
            if factors[at].1 != 1 {
                return None;
            }
            let others: Vec<(Expr, i64)> =
                factors.iter().enumerate().filter(|(other, _)| *other != at).map(|(_, factor)| *factor).collect();
            let others: Vec<Expr> = others.into_iter().map(|(base, e)| graph.integer_power(base, e)).collect();
            let rest = graph.product(&others);
            Some(vec![(factors[at].0, graph.scale(&coefficient, rest))])
        }
        Node::Choice(difference, above, otherwise) if !depends[&difference] => {
            let (one, zero) = (graph.number(Number::ONE), graph.zero());
            let chosen =
                [(above, graph.choice(difference, one, zero)), (otherwise, graph.choice(difference, zero, one))];
            Some(chosen.into_iter().filter(|(operand, _)| depends[operand]).collect())
        }
        _ => None,
    }
}
