//! Coordinates that parts of a mechanism have in common and nothing else: the crank of an engine with many cylinders.
//!
//! Multipliers are eliminated after the coordinates that they constrain. A common coordinate would bring those of all parts
//! together, and the cost would grow with the square of their number and more. So each part gets a coordinate of its own for it,
//! with the inertia that its own rows of T have along it and an equal share of what is left, and multipliers in a chain hold
//! these coordinates together: substructuring with Lagrange multipliers (Farhat and Roux, Int. J. Numer. Methods Eng. 32, 1991),
//! along a coordinate. Each part is definite by itself, as it keeps all of its rows and some inertia along the coordinate.

use super::constraints::Constraints;
use super::tmt::{Tmt, TmtRow};
use crate::symbolic::{Expr, Graph};

/// A coordinate that parts have in common.
pub struct Separation {
    /// Which coordinate.
    pub coordinate: usize,
    /// The part that each other coordinate belongs to.
    pub part: Vec<Option<usize>>,
    /// The inertia along it of each part.
    pub inertias: Vec<Expr>,
}

/// All of them, where rows of T share no products of inertia.
pub(super) fn separations(graph: &mut Graph, tmt: &Tmt, constraints: &Constraints) -> Vec<Separation> {
    if constraints.jacobian.is_empty() || tmt.rows.iter().any(|row| !row.coupling.is_empty()) {
        return vec![];
    }
    let n = tmt.mass_matrix.len();
    let met: Vec<Vec<usize>> = tmt.mass_matrix.iter().map(|row| occurring(graph, row)).collect();
    let constrained: Vec<Vec<usize>> = constraints.jacobian.iter().map(|row| occurring(graph, row)).collect();
    let separations = (0..n).filter_map(|coordinate| {
        let (part, held) = parts(n, coordinate, &met, &constrained);
        (1 < held).then(|| shared_out(graph, &tmt.rows, coordinate, part)).flatten()
    });
    separations.collect()
}

fn occurring(graph: &Graph, row: &[Expr]) -> Vec<usize> {
    (0..row.len()).filter(|j| !graph.is_zero(row[*j])).collect()
}

/// The parts that stay connected without a coordinate, and how many of them constraints hold to it.
fn parts(n: usize, without: usize, met: &[Vec<usize>], constrained: &[Vec<usize>]) -> (Vec<Option<usize>>, usize) {
    let mut part: Vec<Option<usize>> = vec![None; n];
    let mut count = 0;
    for first in (0..n).filter(|j| *j != without) {
        if part[first].is_some() {
            continue;
        }
        let mut left = vec![first];
        while let Some(j) = left.pop() {
            if j == without || part[j].is_some() {
                continue;
            }
            part[j] = Some(count);
            left.extend(&met[j]);
            left.extend(constrained.iter().filter(|row| row.contains(&j)).flatten());
        }
        count += 1;
    }
    let is_held = |of: &usize| {
        let mut rows = constrained.iter().filter(|row| row.contains(&without));
        rows.any(|row| row.iter().any(|j| part[*j] == Some(*of)))
    };
    let held = (0..count).filter(is_held).count();
    (part, held)
}

/// The inertia of each part; nothing where the coordinate has none of its own to share.
fn shared_out(graph: &mut Graph, rows: &[TmtRow], coordinate: usize, part: Vec<Option<usize>>) -> Option<Separation> {
    let count = part.iter().flatten().max()? + 1;
    let (mut own, mut of_parts) = (vec![], vec![vec![]; count]);
    for row in rows {
        let by = row.motion.jacobian[coordinate];
        let inertia = graph.product(&[by, row.inertia, by]);
        if graph.is_zero(inertia) {
            continue;
        }
        match occurring(graph, &row.motion.jacobian).into_iter().find_map(|j| part[j]) {
            Some(part) => of_parts[part].push(inertia),
            None => own.push(inertia),
        }
    }
    let own = graph.sum(&own);
    if graph.is_zero(own) {
        return None;
    }
    let parts = graph.integer(count as i64);
    let share = graph.div(own, parts);
    let inertias = of_parts.into_iter().map(|mut terms| {
        terms.push(share);
        graph.sum(&terms)
    });
    Some(Separation { coordinate, inertias: inertias.collect(), part })
}
