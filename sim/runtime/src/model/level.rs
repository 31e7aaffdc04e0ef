//! Constraints between speeds, which say nothing of positions.
//!
//! Such a row enters everywhere as the rate of a constraint between positions does; only corrections of positions leave
//! it out. So the runtime knows one kind of row, and this list.

use sim_kernel::{Array, Mechanism, Scalar};

/// Whether any row holds between speeds alone.
#[inline(always)]
pub(crate) fn has_speed_rows<S: Scalar, M: Mechanism<S>>(mechanism: &M) -> bool {
    !mechanism.description().speed_constraints.is_empty()
}

/// Whether this row holds between speeds alone.
#[inline(always)]
pub(crate) fn is_speed_row<S: Scalar, M: Mechanism<S>>(mechanism: &M, row: usize) -> bool {
    mechanism.description().speed_constraints.contains(&row)
}

/// The constraint Jacobian with zeros in the rows between speeds: what positions are corrected by.
#[inline(always)]
pub(crate) fn between_positions<S: Scalar, M: Mechanism<S>>(mechanism: &M, jacobian: &M::LQ) -> M::LQ {
    match has_speed_rows(mechanism) {
        false => jacobian.clone(),
        true => jacobian
            .like(|i| if is_speed_row(mechanism, i) { jacobian[i].like(|_| S::ZERO) } else { jacobian[i].clone() }),
    }
}
