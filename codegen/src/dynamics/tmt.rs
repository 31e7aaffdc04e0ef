//! The TMT method: mass matrix, convective forces and generalised forces.

use super::rows::LoadRow;
use super::variables::{Derivatives, Differentiated, Variables};
use crate::model::Model;
use crate::symbolic::Expr;
use std::collections::BTreeMap;

/// One row of x = T(q, t): a rotation or a coordinate of a point.
pub struct Row {
    /// M_i, a mass or moment of inertia; 0 for a point that only carries a load.
    pub inertia: Expr,
    /// F_i, a force or torque along the row.
    pub force: Expr,
    /// T_i with its row of T_q, T_t, v = T_q q' + T_t and g = (T_q q' + T_t)_q q' + (..)_t.
    pub motion: Differentiated,
}

/// What moves, reduced to the variables: n coordinates and what stands for parts of long sums.
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
    pub(super) fn derive(
        model: &mut Model,
        variables: &Variables,
        derivatives: &mut Derivatives,
        load_rows: Vec<LoadRow>,
    ) -> Tmt {
        let rows: Vec<Row> = load_rows
            .into_iter()
            .map(|row| Row {
                inertia: row.inertia,
                force: model.graph.sum(&row.forces),
                motion: derivatives.of_quantity(model, variables, row.position),
            })
            .collect();
        let n = variables.len();
        let convective_forces = reduce(model, &rows, n, |row| vec![row.inertia, row.motion.convective]);
        let generalized_forces = reduce(model, &rows, n, |row| vec![row.force]);
        let both = generalized_forces.iter().zip(&convective_forces);
        let right_hand_side = both.map(|(force, convective)| model.graph.sub(*force, *convective)).collect();
        let mass_matrix = mass_matrix(model, &rows, n);
        Tmt { rows, mass_matrix, convective_forces, generalized_forces, right_hand_side }
    }
}

/// T_q' M T_q, from the entries of T_q that are not zero.
fn mass_matrix(model: &mut Model, rows: &[Row], n: usize) -> Vec<Vec<Expr>> {
    let mut terms: BTreeMap<(usize, usize), Vec<Expr>> = BTreeMap::new();
    for row in rows {
        let entries = nonzero(model, row);
        for (at, (j, by_j)) in entries.iter().enumerate() {
            for (k, by_k) in &entries[..=at] {
                let term = model.graph.product(&[*by_j, row.inertia, *by_k]);
                terms.entry((*j, *k)).or_default().push(term);
            }
        }
    }
    let zero = model.graph.zero();
    let mut matrix = vec![vec![zero; n]; n];
    for ((j, k), terms) in terms {
        let entry = model.graph.sum(&terms);
        matrix[j][k] = entry;
        matrix[k][j] = entry;
    }
    matrix
}

/// T_q' times the product of quantities of each row.
fn reduce(model: &mut Model, rows: &[Row], n: usize, factors: impl Fn(&Row) -> Vec<Expr>) -> Vec<Expr> {
    let mut terms = vec![vec![]; n];
    for row in rows {
        let value = model.graph.product(&factors(row));
        for (j, by_j) in nonzero(model, row) {
            terms[j].push(model.graph.mul(by_j, value));
        }
    }
    terms.into_iter().map(|terms| model.graph.sum(&terms)).collect()
}

fn nonzero(model: &Model, row: &Row) -> Vec<(usize, Expr)> {
    let entries = row.motion.jacobian.iter().copied().enumerate();
    entries.filter(|(_, entry)| !model.graph.is_zero(*entry)).collect()
}
