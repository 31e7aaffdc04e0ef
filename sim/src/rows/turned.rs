//! Whether a row may have turned round between two positions, beside those before it.
//!
//! A row turns round where the part of it that is independent of those before it passes zero. With A and B the rows at both
//! positions, the leading minors of A B' are inner products of the volumes that the first rows span (Cauchy and Binet). So
//! the pivots of its elimination, ratios of successive ones, are positive while no such volume turns round, and only where one
//! is not need the parts themselves be looked at, which takes the square of the number of rows.

use super::sparse::{dot, products, sparse_rows};
use sim_kernel::{Array, Mechanism};

/// A pivot this small beside the product that it is left of says nothing: it has lost its digits, or the rows nearly depend on
/// each other, as at sines of 0.01 at both positions.
const LEAST: f64 = 1e-4;

/// Whether a row may have, from the entries of C_q D at both positions.
pub(crate) fn may_have_turned<M: Mechanism>(before: &M::Entries, after: &M::Entries) -> bool {
    let (rows, zero) = (sparse_rows::<M>(), M::Envelope::filled(0.0));
    // L below the diagonal of the one, the transpose of D U in the other.
    let (mut lower, mut upper, mut inverse_pivots) = (zero, zero, M::L::filled(0.0));
    products::<M>(after, before, &mut lower);
    products::<M>(before, after, &mut upper);
    for (k, row) in rows.iter().enumerate() {
        let start = row.diagonal + row.first - k;
        let (lower_before, own_lower) = lower.as_mut().split_at_mut(start);
        let (upper_before, own_upper) = upper.as_mut().split_at_mut(start);
        for j in row.first..k {
            let (other, at) = (&rows[j], j - row.first);
            let first = row.first.max(other.first);
            let (shared, theirs) = (first - row.first..at, other.diagonal + first - j..other.diagonal);
            own_lower[at] -= dot(&own_lower[shared.clone()], &upper_before[theirs.clone()]);
            own_lower[at] *= inverse_pivots[j];
            own_upper[at] -= dot(&own_upper[shared], &lower_before[theirs]);
        }
        let at = k - row.first;
        let product = own_lower[at];
        let pivot = product - dot(&own_lower[..at], &own_upper[..at]);
        if !(pivot > LEAST * product.abs()) {
            return true;
        }
        inverse_pivots[k] = 1.0 / pivot;
    }
    false
}
