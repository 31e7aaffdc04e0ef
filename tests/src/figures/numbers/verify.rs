//! Rows of verification, and the faults that make them fail.

use crate::figures::Table;

pub(super) fn measure(table: &mut Table) {
    table.heading("Verification");
    table.elsewhere("sound mechanisms that fail; planted faults not seen", "not measured yet");
}
