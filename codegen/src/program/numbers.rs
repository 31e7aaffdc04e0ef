//! Numbers of sums in sums: `2 + (x + 3 - y)` is `(x - y) + 5` where nothing else needs the inner sum.

use super::values::{Operation, Value, Values};
use rustc_hash::FxHashMap;

/// The same results with numbers added up.
pub(super) fn numbers_together(values: &mut Values, roots: &[Value]) -> FxHashMap<Value, Value> {
    let needed = values.reachable(roots, &Default::default());
    let mut uses: FxHashMap<Value, usize> = FxHashMap::default();
    needed.iter().flat_map(|value| values.operands(*value)).for_each(|operand| *uses.entry(operand).or_default() += 1);
    roots.iter().for_each(|root| *uses.entry(*root).or_default() += 2);
    let mut moved: FxHashMap<Value, Value> = FxHashMap::default();
    for value in needed {
        let operation = values.operation(value).clone();
        let new = match &operation {
            Operation::Sum(terms) => {
                let is_inner = |term: &Value| uses.get(term) == Some(&1);
                let terms = terms.iter().map(|(negative, term)| (*negative, moved[term], is_inner(term)));
                added_up(values, terms.collect())
            }
            Operation::Product(factors) => values.product(factors.iter().map(|factor| moved[factor]).collect()),
            Operation::Negate(operand) => values.negate(moved[operand]),
            other => values.add(other.map(|operand| moved[&operand])),
        };
        moved.insert(value, new);
    }
    moved
}

/// The sum of terms, each with whether it is subtracted, and whether it may be taken apart.
fn added_up(values: &mut Values, terms: Vec<(bool, Value, bool)>) -> Value {
    let mut total = 0.0;
    let (mut numbers, mut rest, mut whole) = (0, Vec::new(), Vec::new());
    for (negative, term, is_inner) in terms {
        whole.push((negative, term));
        let (opposite, size) = values.signed(term);
        let negative = negative != opposite;
        let signed = |number: f64, minus: bool| if negative != minus { -number } else { number };
        let parts = match values.operation(size) {
            Operation::Sum(parts) if is_inner => parts.clone(),
            _ => vec![(false, size)],
        };
        let (fixed, moving): (Vec<_>, Vec<_>) = parts.iter().partition(|(_, part)| values.number(*part).is_some());
        numbers += fixed.len();
        total += fixed.iter().filter_map(|(minus, part)| Some(signed(values.number(*part)?, *minus))).sum::<f64>();
        match fixed.is_empty() {
            true => rest.push((negative, size)),
            false => {
                let moving = values.sum(moving);
                rest.push((negative, moving));
            }
        }
    }
    if numbers < 2 {
        return values.sum(whole);
    }
    let total = values.constant(total);
    rest.push((false, total));
    values.sum(rest)
}
