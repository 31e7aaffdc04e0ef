//! Constraints that events switch.

use sim_kernel::{Array, Mechanism};

/// Whether a row of the constraints holds: all do but those of released ones.
pub fn is_active<M: Mechanism>(mechanism: &M, row: usize) -> bool {
    let activities = mechanism.activities();
    let conditionals = const { &M::DESCRIPTION }.conditionals.iter().zip(activities.iter());
    let mut released = conditionals.filter(|(_, activity)| **activity == 0.0);
    !released.any(|(conditional, _)| (conditional.first_row..conditional.first_row + conditional.rows).contains(&row))
}

/// How many rows are released.
pub(crate) fn released_rows<M: Mechanism>(mechanism: &M) -> usize {
    (0..M::L::LEN).filter(|row| !is_active(mechanism, *row)).count()
}
