//! Kills, pairs of runs into one folder, full disks.

use crate::figures::Table;

pub(super) fn measure(table: &mut Table) {
    table.heading("Files under faults");
    table.elsewhere("200 kills, 50 pairs of runs, a full disk at every file", "not measured yet");
}
