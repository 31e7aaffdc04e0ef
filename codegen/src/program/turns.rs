//! From the multipliers of turned rows to those of the rows as declared.

use super::lower::Lowering;
use super::values::Value;
use crate::dynamics::ConstraintForm;
use crate::symbolic::Expr;

/// lambda = R' lambda~: turns the multipliers of turned rows back, in place.
pub(super) fn turned_back(lowering: &mut Lowering, form: &ConstraintForm, multipliers: &mut [Value]) {
    for turn in &form.turns {
        let [i, j] = turn.rows;
        let [cos, sin] = turn.direction.map(|expr| lowering.lower(expr));
        let [along, across] = [multipliers[i], multipliers[j]];
        let mut combination = |terms: [(bool, Value, Value); 2]| {
            let terms = terms.map(|(negative, a, b)| (negative, lowering.values.product(vec![a, b])));
            lowering.values.sum(terms.to_vec())
        };
        multipliers[i] = combination([(false, cos, along), (true, sin, across)]);
        multipliers[j] = combination([(false, sin, along), (false, cos, across)]);
    }
}

/// d lambda = R' d lambda~ + dR' lambda~, in place: with dR' lambda~ = (-lambda_y, lambda_x) d phi for the `multipliers`
/// lambda, and the derivatives of the `angles` phi.
pub(super) fn derivatives_turned_back(
    lowering: &mut Lowering,
    form: &ConstraintForm,
    multipliers: &[Value],
    angles: &[Expr],
    derivatives: &mut [Value],
) {
    turned_back(lowering, form, derivatives);
    for (turn, angle) in form.turns.iter().zip(angles) {
        let [i, j] = turn.rows;
        let angle = lowering.lower(*angle);
        let by_turning = [multipliers[j], multipliers[i]].map(|value| lowering.values.product(vec![value, angle]));
        derivatives[i] = lowering.values.sum(vec![(false, derivatives[i]), (true, by_turning[0])]);
        derivatives[j] = lowering.values.sum(vec![(false, derivatives[j]), (false, by_turning[1])]);
    }
}
