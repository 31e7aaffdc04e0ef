//! Constraints between speeds, which say nothing of positions.
//!
//! Such a row enters everywhere as the rate of a constraint between positions does; only corrections of positions leave
//! it out. So the runtime knows one kind of row, and this list.

use sim_kernel::{Array, Mechanism};

/// Whether any row holds between speeds alone.
#[inline(always)]
pub(crate) fn has_speed_rows<M: Mechanism>() -> bool {
    !M::DESCRIPTION.speed_constraints.is_empty()
}

/// Whether this row holds between speeds alone.
#[inline(always)]
pub(crate) fn is_speed_row<M: Mechanism>(row: usize) -> bool {
    M::DESCRIPTION.speed_constraints.contains(&row)
}

/// The constraint Jacobian with zeros in the rows between speeds: what positions are corrected by.
#[inline(always)]
pub(crate) fn between_positions<M: Mechanism>(jacobian: &M::LQ) -> M::LQ {
    let zero = M::Q::filled(0.0);
    match has_speed_rows::<M>() {
        false => *jacobian,
        true => M::LQ::from_fn(|i| if is_speed_row::<M>(i) { zero } else { jacobian[i] }),
    }
}
