//! The terms of the equations of motion in coordinates alone, for any formulation.

use super::eliminate::{System, reduce};
use super::lower::Lowering;
use super::motion::{constraint_system, definition, system};
use super::results::Results;
use super::sparsity::Sparsity;
use super::values::{Input, Operation, Value};
use crate::dynamics::EquationsOfMotion;
use crate::symbolic::Expr;
use std::collections::BTreeSet;
use std::ops::Range;

/// A larger matrix is written by its nonzero entries, if fewer than one in so many are nonzero.
const LARGEST_DENSE: usize = 4096;
const SPARSE: usize = 4;

/// T_q' M T_q, n x n.
pub(super) fn mass_matrix(equations: &EquationsOfMotion, lowering: &mut Lowering) -> Results<Value> {
    let system = system(equations, &equations.declared, &equations.declared.rows, lowering);
    matrix(equations, lowering, &system, 0..equations.model.coordinates.len())
}

/// The same with all of its zeros.
pub(super) fn dense_mass_matrix(equations: &EquationsOfMotion, lowering: &mut Lowering) -> Vec<Vec<Value>> {
    let n = equations.model.coordinates.len();
    let system = system(equations, &equations.declared, &equations.declared.rows, lowering);
    let mut reduced = reduce(&mut lowering.values, &system);
    let mut row = |i: usize| (0..n).map(|j| reduced.entry(&mut lowering.values, i, j)).collect();
    (0..n).map(&mut row).collect()
}

/// C_q, m x n.
pub(super) fn constraint_jacobian(equations: &EquationsOfMotion, lowering: &mut Lowering) -> Results<Value> {
    let first = equations.variables.len();
    let system = constraint_system(equations, lowering);
    matrix(equations, lowering, &system, first..first + equations.model.constraints.len())
}

/// For each row of C_q the columns of its entries that need not be 0.
pub(super) fn columns_of_constraints(equations: &EquationsOfMotion, lowering: &mut Lowering) -> Vec<BTreeSet<usize>> {
    let (n, first) = (equations.model.coordinates.len(), equations.variables.len());
    let system = constraint_system(equations, lowering);
    let reduced = reduce(&mut lowering.values, &system);
    let columns = |row: usize| (0..n).filter(|j| reduced.holds(first + row, *j)).collect();
    (0..equations.model.constraints.len()).map(columns).collect()
}

/// The entries of C_q, row after row in the order of elimination.
pub(super) fn entries_of_constraints(
    equations: &EquationsOfMotion,
    lowering: &mut Lowering,
    sparsity: &Sparsity,
) -> Results<Value> {
    let first = equations.variables.len();
    let system = constraint_system(equations, lowering);
    let mut reduced = reduce(&mut lowering.values, &system);
    let places =
        sparsity.rows.iter().flat_map(|row| row.columns.iter().map(|column| (first + row.constraint, *column)));
    Results::Vector(places.map(|(i, j)| reduced.entry(&mut lowering.values, i, j)).collect())
}

/// T_q' F, n.
pub(super) fn generalized_forces(equations: &EquationsOfMotion, lowering: &mut Lowering) -> Results<Value> {
    let forces = lowering.lower_all(&equations.tmt.generalized_forces);
    Results::Vector(pulled_back(equations, lowering, forces))
}

/// T_q' M g, n: the forces h of the variables, plus M u for their own convective accelerations.
pub(super) fn convective_forces(equations: &EquationsOfMotion, lowering: &mut Lowering) -> Results<Value> {
    let mut forces = lowering.lower_all(&equations.tmt.convective_forces);
    if !equations.intermediates.is_empty() {
        let accelerations = convective_accelerations(equations, lowering);
        for (i, row) in equations.tmt.mass_matrix.iter().enumerate() {
            forces[i] = plus_inner(equations, lowering, forces[i], row, &accelerations);
        }
    }
    Results::Vector(pulled_back(equations, lowering, forces))
}

/// M q'' + h - Q, n, for given accelerations: M u + h - Q of the variables, with their own accelerations.
pub(super) fn inverse_dynamics(equations: &EquationsOfMotion, lowering: &mut Lowering) -> Vec<Value> {
    let given = |i: usize| lowering.values.add(Operation::Input(Input::Acceleration(i)));
    let given = (0..equations.model.coordinates.len()).map(given).collect();
    let accelerations = with_intermediates(equations, lowering, given);
    let tmt = &equations.tmt;
    let mut forces = lowering.lower_all(&tmt.right_hand_side);
    for (force, row) in forces.iter_mut().zip(&tmt.mass_matrix) {
        let least = lowering.values.negate(*force);
        *force = plus_inner(equations, lowering, least, row, &accelerations);
    }
    pulled_back(equations, lowering, forces)
}

/// C_t, m.
pub(super) fn constraint_time_derivative(equations: &EquationsOfMotion, lowering: &mut Lowering) -> Results<Value> {
    let mut drifts = vec![lowering.values.constant(0.0); equations.model.coordinates.len()];
    drifts.extend(equations.intermediates.iter().map(|y| lowering.lower(y.time_derivative)));
    constraint_rows(equations, lowering, &equations.constraints.time_derivative, &drifts)
}

/// (C_q q' + C_t)_q q' + (..)_t, m.
pub(super) fn constraint_convective(equations: &EquationsOfMotion, lowering: &mut Lowering) -> Results<Value> {
    let accelerations = convective_accelerations(equations, lowering);
    constraint_rows(equations, lowering, &equations.constraints.convective, &accelerations)
}

fn matrix(
    equations: &EquationsOfMotion,
    lowering: &mut Lowering,
    system: &System,
    rows: Range<usize>,
) -> Results<Value> {
    let n = equations.model.coordinates.len();
    let mut reduced = reduce(&mut lowering.values, system);
    let size = [rows.len(), n];
    let held = rows.clone().map(|i| (0..n).filter(|j| reduced.holds(i, *j)).count()).sum::<usize>();
    if n * rows.len() > LARGEST_DENSE && held * SPARSE < n * rows.len() {
        let mut entries = Vec::with_capacity(held);
        for (row, i) in rows.enumerate() {
            for j in 0..n {
                entries.extend(reduced.value(&mut lowering.values, i, j).map(|value| ([row, j], value)));
            }
        }
        return Results::Sparse(size, entries);
    }
    let mut row = |i: usize| (0..n).map(|j| reduced.entry(&mut lowering.values, i, j)).collect();
    Results::Matrix(n, rows.map(&mut row).collect())
}

/// The accelerations of the variables where those of the coordinates are 0.
fn convective_accelerations(equations: &EquationsOfMotion, lowering: &mut Lowering) -> Vec<Value> {
    let at_rest = vec![lowering.values.constant(0.0); equations.model.coordinates.len()];
    with_intermediates(equations, lowering, at_rest)
}

/// The accelerations of the variables, from those of the coordinates.
fn with_intermediates(equations: &EquationsOfMotion, lowering: &mut Lowering, given: Vec<Value>) -> Vec<Value> {
    let mut accelerations = given;
    for y in &equations.intermediates {
        let constant = lowering.lower(y.definition.convective);
        accelerations.push(plus_inner(equations, lowering, constant, &y.definition.jacobian, &accelerations));
    }
    accelerations
}

/// Forces along the variables as forces along the coordinates: each intermediate passes its force on to the variables
/// in its definition.
fn pulled_back(equations: &EquationsOfMotion, lowering: &mut Lowering, forces: Vec<Value>) -> Vec<Value> {
    let n = equations.model.coordinates.len();
    let mut sums: Vec<Vec<(bool, Value)>> = forces.into_iter().map(|force| vec![(false, force)]).collect();
    for (k, y) in equations.intermediates.iter().enumerate().rev() {
        let force = lowering.values.sum(std::mem::take(&mut sums[n + k]));
        for (j, a) in definition(equations, lowering, y) {
            let passed_on = lowering.values.product(vec![a, force]);
            sums[j].push((false, passed_on));
        }
    }
    sums.truncate(n);
    sums.into_iter().map(|sum| lowering.values.sum(sum)).collect()
}

fn constraint_rows(
    equations: &EquationsOfMotion,
    lowering: &mut Lowering,
    rows: &[Expr],
    rates: &[Value],
) -> Results<Value> {
    let own = lowering.lower_all(rows);
    let jacobian = &equations.constraints.jacobian;
    let rows = own.into_iter().zip(jacobian).map(|(own, row)| plus_inner(equations, lowering, own, row, rates));
    Results::Vector(rows.collect())
}

/// `value + sum of row_j rates_j`, over those of `row` that have rates.
fn plus_inner(
    equations: &EquationsOfMotion,
    lowering: &mut Lowering,
    value: Value,
    row: &[Expr],
    rates: &[Value],
) -> Value {
    let mut terms = vec![(false, value)];
    for (entry, rate) in row.iter().zip(rates) {
        if !equations.graph.is_zero(*entry) && !lowering.values.is_zero(*rate) {
            let entry = lowering.lower(*entry);
            terms.push((false, lowering.values.product(vec![entry, *rate])));
        }
    }
    lowering.values.sum(terms)
}
