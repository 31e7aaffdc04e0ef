//! The entries of the equations of motion, a symmetric system.

use super::lower::Lowering;
use super::values::Value;
use crate::symbolic::{Expr, Graph};

/// The entries (i, j), j <= i, of a mass matrix.
pub(super) fn mass_entries(
    lowering: &mut Lowering,
    graph: &Graph,
    mass_matrix: &[Vec<Expr>],
) -> Vec<(usize, usize, Value)> {
    let mut entries = Vec::new();
    for (i, row) in mass_matrix.iter().enumerate() {
        let row = row[..=i].iter().enumerate().filter(|(_, expr)| !graph.is_zero(**expr));
        entries.extend(row.map(|(j, expr)| (i, j, lowering.lower(*expr))));
    }
    entries
}

/// The entries of a constraint Jacobian below the mass matrix of so many variables, with what switching adds to its diagonal.
pub(super) fn constraint_entries(
    lowering: &mut Lowering,
    graph: &Graph,
    variables: usize,
    jacobian: &[Vec<Expr>],
    activities: impl Iterator<Item = Option<Expr>>,
) -> Vec<(usize, usize, Value)> {
    let mut entries = Vec::new();
    for (i, row) in jacobian.iter().enumerate() {
        let row = row.iter().enumerate().filter(|(_, expr)| !graph.is_zero(**expr));
        entries.extend(row.map(|(j, expr)| (variables + i, j, lowering.lower(*expr))));
    }
    for (i, activity) in activities.enumerate() {
        let inactivity = match activity {
            Some(activity) => {
                let (one, activity) = (lowering.values.constant(1.0), lowering.lower(activity));
                lowering.values.sum(vec![(false, one), (true, activity)])
            }
            None if jacobian[i].iter().all(|expr| graph.is_zero(*expr)) => lowering.values.constant(1.0),
            None => continue,
        };
        let place = variables + i;
        entries.push((place, place, lowering.values.negate(inactivity)));
    }
    entries
}
