//! Constraints that events switch.

use sim_kernel::{Description, Mechanism};

/// Whether a row of the constraints holds: all do except those of released constraints.
pub fn is_active<M: Mechanism>(mechanism: &M, row: usize) -> bool {
    is_row_active(mechanism.description(), mechanism.activities().as_ref(), row)
}

/// The same of a mechanism of any type.
pub(crate) fn is_row_active(description: &Description, activities: &[f64], row: usize) -> bool {
    let mut released = description.conditionals.iter().zip(activities).filter(|(_, activity)| **activity == 0.0);
    !released.any(|(conditional, _)| (conditional.first_row..conditional.first_row + conditional.rows).contains(&row))
}

/// The number of released rows.
pub(crate) fn released_rows<M: Mechanism>(mechanism: &M) -> usize {
    (0..mechanism.m()).filter(|row| !is_active(mechanism, *row)).count()
}
