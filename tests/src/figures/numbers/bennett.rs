//! An overconstrained loop: the order of equal steps, and what adaptive ones cost.

use crate::figures::Table;

pub(super) fn measure(table: &mut Table) {
    table.heading("Bennett's linkage");
    table.elsewhere("order of RK4 by projection and mass-projection", "not measured yet");
    table.elsewhere("right-hand sides of DOP853 at 1e-10, beside partitioning", "not measured yet");
}
