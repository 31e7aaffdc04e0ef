//! Vectors and matrices of values.

use crate::program::values::{Value, Values};

/// Three components.
pub(super) type Triple = [Value; 3];
/// Three rows.
pub(super) type Matrix = [Triple; 3];

/// The sum of values, in a fixed order, so that equal sums are one value. What depends on parameters alone is added up apart,
/// that in terms which are sums included: `a + (b + x)` is `(a + b) + x`, which costs no new value.
pub(super) fn sum(values: &mut Values, terms: &[Value]) -> Value {
    let (mut parametric, mut moving) = (Vec::new(), Vec::new());
    let has_fixed = terms.iter().any(|term| values.is_parametric(*term) && !values.is_zero(*term));
    for term in terms {
        let (negative, size) = values.signed(*term);
        match values.parametric_and_moving(size).filter(|_| has_fixed) {
            Some([fixed, rest]) => {
                parametric.push((fixed.0 != negative, fixed.1));
                moving.push((rest.0 != negative, rest.1));
            }
            None if values.is_parametric(size) => parametric.push((negative, size)),
            None => moving.push((negative, size)),
        }
    }
    let fixed = sum_of_numbers(values, &parametric).unwrap_or_else(|| {
        parametric.sort_by_key(|(_, value)| *value);
        values.sum(parametric)
    });
    let (negative, size) = values.signed(fixed);
    moving.push((negative, size));
    moving.sort_by_key(|(_, value)| *value);
    values.sum(moving)
}

fn sum_of_numbers(values: &mut Values, terms: &[(bool, Value)]) -> Option<Value> {
    let mut total = 0.0;
    for (negative, term) in terms {
        let number = values.number(*term)?;
        total += if *negative { -number } else { number };
    }
    Some(values.constant(total))
}

pub(super) fn product(values: &mut Values, a: Value, b: Value) -> Value {
    match (values.number(a), values.number(b)) {
        (Some(x), Some(y)) => values.constant(x * y),
        _ => values.product(vec![a, b]),
    }
}

pub(super) fn difference(values: &mut Values, a: Value, b: Value) -> Value {
    let b = values.negate(b);
    sum(values, &[a, b])
}

/// `sum of a_i b_i`.
pub(super) fn inner(values: &mut Values, pairs: &[(Value, Value)]) -> Value {
    let products: Vec<Value> = pairs.iter().map(|(a, b)| product(values, *a, *b)).collect();
    sum(values, &products)
}

pub(super) fn dot(values: &mut Values, a: &Triple, b: &Triple) -> Value {
    inner(values, &[(a[0], b[0]), (a[1], b[1]), (a[2], b[2])])
}

pub(super) fn add(values: &mut Values, a: &Triple, b: &Triple) -> Triple {
    std::array::from_fn(|i| sum(values, &[a[i], b[i]]))
}

pub(super) fn cross(values: &mut Values, a: &Triple, b: &Triple) -> Triple {
    std::array::from_fn(|i| {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        let (ahead, back) = (product(values, a[j], b[k]), product(values, a[k], b[j]));
        difference(values, ahead, back)
    })
}

/// A v.
pub(super) fn apply(values: &mut Values, a: &Matrix, v: &Triple) -> Triple {
    std::array::from_fn(|i| dot(values, &a[i], v))
}

pub(super) fn transposed(a: &Matrix) -> Matrix {
    std::array::from_fn(|i| std::array::from_fn(|j| a[j][i]))
}

pub(super) fn zero(values: &mut Values) -> Triple {
    [values.constant(0.0); 3]
}

pub(super) fn identity(values: &mut Values) -> Matrix {
    let (zero, one) = (values.constant(0.0), values.constant(1.0));
    std::array::from_fn(|i| std::array::from_fn(|j| if i == j { one } else { zero }))
}
