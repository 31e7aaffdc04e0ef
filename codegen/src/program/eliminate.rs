//! The planned solution of the equations of motion: a straight-line L D L' factorisation whose order is chosen
//! from the structure of the system when the mechanism is built.
//!
//! Coordinates come first, those with the fewest neighbours first; a constraint follows when all of its
//! coordinates are gone. Then the pivots of the constraints are those of -C_q M^-1 C_q', which is definite as
//! long as M is and the constraints are independent: a constraint taken earlier could meet a pivot that is zero
//! at some position. Each pivot comes with the terms that it is the sum of, to be checked at run time.

use super::values::{Value, Values};

/// A symmetric linear system, lower triangle; absent entries are zero wherever the mechanism is.
pub(super) struct System {
    /// Entry (i, j), j <= i.
    pub(super) matrix: Vec<Vec<Option<Value>>>,
    /// Right-hand side.
    pub(super) rhs: Vec<Value>,
    /// The first so many unknowns are coordinates; the others are multipliers.
    pub(super) coordinates: usize,
}

/// Names for the intermediate results, for whoever reads the kernel.
pub(super) type Labels = Vec<(Value, String)>;

/// The solution with the pivots it divides by.
pub(super) struct Solution {
    /// The unknowns.
    pub(super) unknowns: Vec<Value>,
    /// Each pivot with the magnitudes of its terms added up.
    pub(super) pivots: Vec<(Value, Value)>,
}

/// An entry under elimination: a sum that still grows.
type Entry = Vec<(bool, Value)>;

/// What remains of one elimination for back substitution.
struct Step {
    /// The reduced right-hand side divided by the pivot.
    scaled: Value,
    /// Rows below with their entries of L.
    column: Vec<(usize, Value)>,
}

/// Plans the solution. `None` if no order of this kind exists, as for a coordinate without mass.
pub(super) fn eliminate(
    values: &mut Values,
    system: &System,
    names: &[String],
    labels: &mut Labels,
) -> Option<Solution> {
    let order = elimination_order(system)?;
    let name = |position: usize| names[order[position]].as_str();
    let mut label = |value: Value, text: String| labels.push((value, text));
    // From here on rows and columns are in the order of elimination, lower triangle only.
    let start = |value: Option<Value>| value.map(|value| (false, value)).into_iter().collect::<Entry>();
    let mut matrix: Vec<Vec<Entry>> = order
        .iter()
        .enumerate()
        .map(|(i, row)| order[..=i].iter().map(|column| start(system.entry(*row, *column))).collect())
        .collect();
    let mut rhs: Vec<Entry> = order.iter().map(|row| start(Some(system.rhs[*row]))).collect();
    let (mut pivots, mut steps) = (Vec::new(), Vec::new());
    let one = values.constant(1.0);
    for k in 0..order.len() {
        let pivot = values.sum(matrix[k][k].clone());
        label(pivot, format!("pivot_{}", name(k)));
        pivots.push((pivot, magnitude(values, &matrix[k][k])));
        let inverse = values.quotient(one, pivot);
        label(inverse, format!("inverse_{}", name(k)));
        let reduced = values.sum(rhs[k].clone());
        label(reduced, format!("rhs_{}", name(k)));
        let mut column: Vec<(usize, Value, Value)> = Vec::new();
        for i in k + 1..order.len() {
            if matrix[i][k].is_empty() {
                continue;
            }
            let value = values.sum(matrix[i][k].clone());
            label(value, format!("k_{}_{}", name(i), name(k)));
            let factor = values.product(vec![value, inverse]);
            label(factor, format!("l_{}_{}", name(i), name(k)));
            column.push((i, value, factor));
            rhs[i].push((true, values.product(vec![factor, reduced])));
            for &(j, value, _) in &column {
                matrix[i][j].push((true, values.product(vec![factor, value])));
            }
        }
        let scaled = values.product(vec![reduced, inverse]);
        steps.push(Step { scaled, column: column.into_iter().map(|(i, _, factor)| (i, factor)).collect() });
    }
    let mut unknowns = vec![one; order.len()];
    for (k, step) in steps.into_iter().enumerate().rev() {
        let mut terms = vec![(false, step.scaled)];
        for (i, factor) in step.column {
            terms.push((true, values.product(vec![factor, unknowns[order[i]]])));
        }
        unknowns[order[k]] = values.sum(terms);
        label(unknowns[order[k]], name(k).to_owned());
    }
    Some(Solution { unknowns, pivots })
}

impl System {
    fn entry(&self, i: usize, j: usize) -> Option<Value> {
        self.matrix[i.max(j)][i.min(j)]
    }
}

/// The sum of the magnitudes of terms.
fn magnitude(values: &mut Values, terms: &[(bool, Value)]) -> Value {
    let sizes = terms.iter().map(|(_, term)| (false, values.magnitude(*term))).collect();
    values.sum(sizes)
}

/// Which unknown to eliminate when, by structure alone.
fn elimination_order(system: &System) -> Option<Vec<usize>> {
    let n = system.rhs.len();
    let mut linked: Vec<Vec<bool>> = (0..n).map(|i| (0..n).map(|j| system.entry(i, j).is_some()).collect()).collect();
    let mut left: Vec<usize> = (0..n).collect();
    let mut order = Vec::with_capacity(n);
    while !left.is_empty() {
        let is_ready = |k: usize| {
            let is_coordinate = k < system.coordinates;
            let waits = left.iter().any(|j| *j < system.coordinates && system.entry(k, *j).is_some());
            linked[k][k] && (is_coordinate || !waits)
        };
        let degree = |k: usize| left.iter().filter(|j| **j != k && linked[k][**j]).count();
        let next = left.iter().copied().filter(|k| is_ready(*k)).min_by_key(|k| (degree(*k), *k))?;
        left.retain(|k| *k != next);
        for &i in &left {
            for &j in &left {
                let fill = linked[i][next] && linked[next][j];
                linked[i][j] |= fill;
            }
        }
        order.push(next);
    }
    Some(order)
}
