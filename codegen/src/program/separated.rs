//! The equations of motion with common coordinates of parts separated.

use super::eliminate::{System, Unknown};
use super::lower::Lowering;
use super::values::Value;
use crate::dynamics::Separation;

/// A coordinate of its own for each part but the first, after all unknowns, and then the multiplier that holds it to the one
/// before it. `names` and the right-hand side grow with them.
pub(super) fn separated(
    lowering: &mut Lowering,
    separations: &[Separation],
    system: System,
    names: &mut Vec<String>,
    right_hand_side: &mut Vec<Value>,
) -> System {
    let System { mut unknowns, entries, multipliers } = system;
    let constraints = constraints_by_part(separations, &entries, unknowns.len());
    let (none, one) = (lowering.values.constant(0.0), lowering.values.constant(1.0));
    let (mut copies, mut held) = (Vec::new(), Vec::new());
    for Separation { coordinate, inertias, .. } in separations {
        let mut own = vec![*coordinate];
        for (part, inertia) in inertias.iter().enumerate() {
            if part > 0 {
                let (copy, hold) = (unknowns.len(), unknowns.len() + 1);
                unknowns.extend([Unknown::Coordinate, Unknown::Multiplier]);
                let name = &names[*coordinate];
                names.extend([format!("{name}_{}", part + 1), format!("hold_{name}_{}", part + 1)]);
                right_hand_side.extend([none; 2]);
                let before = own[part - 1];
                held.extend([(hold, before, one), (hold, copy, lowering.values.negate(one))]);
                own.push(copy);
            }
            held.push((own[part], own[part], lowering.lower(*inertia)));
        }
        copies.push(own);
    }
    // The unknown that stands for one in the entries of another.
    let stands = |unknown: usize, other: usize| {
        let at = separations.iter().position(|separation| separation.coordinate == unknown)?;
        let part = separations[at].part.get(other).copied().unwrap_or_else(|| constraints[at][other]);
        Some(copies[at][part.unwrap_or(0)])
    };
    let is_separated = |unknown: usize| separations.iter().any(|separation| separation.coordinate == unknown);
    let kept = entries.into_iter().filter(|(i, j, _)| i != j || !is_separated(*i));
    let kept = kept.map(|(i, j, value)| (stands(i, j).unwrap_or(i), stands(j, i).unwrap_or(j), value));
    let mut entries: Vec<(usize, usize, Value)> = kept.collect();
    entries.extend(held);
    entries.iter_mut().for_each(|(i, j, _)| (*i, *j) = (*(&*i).max(j), *(&*i).min(j)));
    System { unknowns, entries, multipliers }
}

/// For each separation the part of every constraint.
fn constraints_by_part(
    separations: &[Separation],
    entries: &[(usize, usize, Value)],
    unknowns: usize,
) -> Vec<Vec<Option<usize>>> {
    let by_part = |separation: &Separation| {
        let mut parts = vec![None; unknowns];
        for (row, coordinate, _) in entries {
            if let Some(Some(part)) = separation.part.get(*coordinate) {
                parts[*row] = Some(*part);
            }
        }
        parts
    };
    separations.iter().map(by_part).collect()
}
