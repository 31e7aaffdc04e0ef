//! Problems with known solutions, as commands are given.

use crate::figures::Table;

pub(super) fn measure(table: &mut Table) {
    table.heading("Known solutions");
    table.elsewhere("runs, sweeps and linearisations that were wrong", "not measured yet");
}
