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

#[cfg(test)]
mod tests {
    use super::numbers_together;
    use crate::program::values::{Input, Operation, Value, Values};

    /// The value of a sum where x is 10 and y is 100.
    fn at(values: &Values, value: Value) -> f64 {
        match values.operation(value) {
            Operation::Constant(bits) => f64::from_bits(*bits),
            Operation::Input(Input::Position(i)) => [10.0, 100.0][*i],
            Operation::Negate(operand) => -at(values, *operand),
            Operation::Sum(terms) => {
                let signed = |(negative, term): &(bool, Value)| if *negative { -1.0 } else { 1.0 } * at(values, *term);
                terms.iter().map(signed).sum()
            }
            other => unreachable!("{other:?}"),
        }
    }

    /// The number of terms in all sums that a value needs.
    fn terms(values: &Values, value: Value) -> usize {
        values.reachable(&[value], &Default::default()).iter().map(|value| values.operands(*value).count()).sum()
    }

    #[test]
    fn numbers_keep_their_signs() {
        for [outer_minus, inner_minus, number_minus] in
            [0, 1, 2, 3, 4, 5, 6, 7].map(|bits: u8| [1, 2, 4].map(|bit| bits & bit != 0))
        {
            let values = &mut Values::default();
            let [x, y] = [0, 1].map(|i| values.add(Operation::Input(Input::Position(i))));
            let [two, three] = [2.0, 3.0].map(|number| values.constant(number));
            let inner = values.sum(vec![(false, x), (number_minus, three)]);
            let whole = values.sum(vec![(false, y), (outer_minus, two), (inner_minus, inner)]);
            let together = numbers_together(values, &[whole])[&whole];
            assert_eq!(at(values, together), at(values, whole), "{outer_minus} {inner_minus} {number_minus}");
            assert_eq!([terms(values, whole), terms(values, together)], [5, 3]);
            // What others need stays whole.
            let kept = numbers_together(values, &[whole, inner])[&whole];
            assert_eq!(kept, whole);
        }
    }
}
