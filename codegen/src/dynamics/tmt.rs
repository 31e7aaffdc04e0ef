//! The TMT method: mass matrix, convective forces and generalised forces.

use super::rows::LoadRow;
use super::variables::{Derivatives, Differentiated, Variables};
use crate::symbolic::{Expr, Graph, Symbol, substitute};
use std::collections::BTreeMap;

/// One row of x = T(q, t): a rotation or a coordinate of a point; in space a component of a velocity.
pub struct TmtRow {
    /// M_i, a mass or moment of inertia; 0 for a point that only carries a load.
    pub inertia: Expr,
    /// Entries of M in this row beside the diagonal: products of inertia.
    pub coupling: Vec<(usize, Expr)>,
    /// The component of w x J w along the row.
    pub gyroscopic: Expr,
    /// F_i, a force or torque along the row.
    pub force: Expr,
    /// F_i - M_i g_i, where it is known in a shorter form.
    pub net: Option<Expr>,
    /// T_i with its row of T_q, T_t, v = T_q q' + T_t and g = (T_q q' + T_t)_q q' + (..)_t.
    pub motion: Differentiated,
}

/// The moving system, reduced to the variables: n coordinates and intermediate quantities.
pub struct Tmt {
    /// The rows of T.
    pub rows: Vec<TmtRow>,
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
        graph: &mut Graph,
        variables: &Variables,
        derivatives: &mut Derivatives,
        load_rows: Vec<LoadRow>,
    ) -> Tmt {
        let zero = graph.zero();
        let at_rest: Vec<_> = variables.accelerations.iter().map(|symbol| (*symbol, zero)).collect();
        let rows = load_rows.into_iter().map(|row| {
            let motion = derivatives.of_row(graph, variables, row.along, &at_rest);
            TmtRow::of(graph, row, motion, &at_rest)
        });
        let rows = rows.collect();
        Tmt::of(graph, rows, variables.len())
    }

    /// The rows reduced to n variables.
    pub(super) fn of(graph: &mut Graph, rows: Vec<TmtRow>, n: usize) -> Tmt {
        let convective: Vec<Expr> = (0..rows.len()).map(|i| convective_force(graph, &rows, i)).collect();
        let convective_forces = reduce(graph, &rows, n, |i, _| convective[i]);
        let generalized_forces = reduce(graph, &rows, n, |_, row| row.force);
        let right_hand_side = match rows.iter().any(|row| row.net.is_some()) {
            true => {
                let net: Vec<Expr> = rows
                    .iter()
                    .zip(&convective)
                    .map(|(row, convective)| row.net.unwrap_or_else(|| graph.sub(row.force, *convective)))
                    .collect();
                reduce(graph, &rows, n, |i, _| net[i])
            }
            false => {
                let both = generalized_forces.iter().zip(&convective_forces);
                both.map(|(force, convective)| graph.sub(*force, *convective)).collect()
            }
        };
        let mass_matrix = mass_matrix(graph, &rows, n);
        Tmt { rows, mass_matrix, convective_forces, generalized_forces, right_hand_side }
    }
}

impl TmtRow {
    /// A row with its derivatives; `at_rest` gives the accelerations the value 0.
    pub(super) fn of(graph: &mut Graph, row: LoadRow, motion: Differentiated, at_rest: &[(Symbol, Expr)]) -> TmtRow {
        let applied = graph.sum(&row.forces);
        let force = match row.weight {
            Some(weight) => graph.add(applied, weight.force),
            None => applied,
        };
        let net = row.weight.map(|weight| {
            let proper = substitute(graph, &[weight.proper], at_rest)[0];
            let needed = graph.mul(row.inertia, proper);
            graph.sub(applied, needed)
        });
        TmtRow { inertia: row.inertia, coupling: row.coupling, gyroscopic: row.gyroscopic, force, net, motion }
    }
}

/// M_i g, with w x J w.
fn convective_force(graph: &mut Graph, rows: &[TmtRow], i: usize) -> Expr {
    let row = &rows[i];
    let own = graph.product(&[row.inertia, row.motion.convective]);
    if row.coupling.is_empty() && graph.is_zero(row.gyroscopic) {
        return own;
    }
    let mut terms = vec![own, row.gyroscopic];
    terms.extend(row.coupling.iter().map(|(k, product)| graph.mul(*product, rows[*k].motion.convective)));
    graph.sum(&terms)
}

/// T_q' M T_q, from the entries of T_q that are not zero.
fn mass_matrix(graph: &mut Graph, rows: &[TmtRow], n: usize) -> Vec<Vec<Expr>> {
    let mut terms: BTreeMap<(usize, usize), Vec<Expr>> = BTreeMap::new();
    for row in rows {
        let entries = nonzero(graph, row);
        for (at, (j, by_j)) in entries.iter().enumerate() {
            for (k, by_k) in &entries[..=at] {
                let term = graph.product(&[*by_j, row.inertia, *by_k]);
                terms.entry((*j, *k)).or_default().push(term);
            }
            for (other, product) in &row.coupling {
                for (k, by_k) in nonzero(graph, &rows[*other]).into_iter().filter(|(k, _)| k <= j) {
                    let term = graph.product(&[*by_j, *product, by_k]);
                    terms.entry((*j, k)).or_default().push(term);
                }
            }
        }
    }
    let zero = graph.zero();
    let mut matrix = vec![vec![zero; n]; n];
    for ((j, k), terms) in terms {
        let entry = graph.sum(&terms);
        matrix[j][k] = entry;
        matrix[k][j] = entry;
    }
    matrix
}

/// T_q' times a quantity of each row.
fn reduce(graph: &mut Graph, rows: &[TmtRow], n: usize, quantity: impl Fn(usize, &TmtRow) -> Expr) -> Vec<Expr> {
    let mut terms = vec![vec![]; n];
    for (i, row) in rows.iter().enumerate() {
        let value = quantity(i, row);
        for (j, by_j) in nonzero(graph, row) {
            terms[j].push(graph.mul(by_j, value));
        }
    }
    terms.into_iter().map(|terms| graph.sum(&terms)).collect()
}

fn nonzero(graph: &Graph, row: &TmtRow) -> Vec<(usize, Expr)> {
    let entries = row.motion.jacobian.iter().copied().enumerate();
    entries.filter(|(_, entry)| !graph.is_zero(*entry)).collect()
}
