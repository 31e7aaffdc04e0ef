//! Steps, projected and recorded.

use crate::figures::Table;

pub(super) fn measure(table: &mut Table) {
    table.heading("Speed");
    table.elsewhere("a run beside the commit before, alternated", "cargo bench -p tests --bench run");
}
