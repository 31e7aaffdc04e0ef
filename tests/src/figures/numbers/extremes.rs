//! Least and greatest values of a sweep do not depend on its rows.

use crate::figures::Table;

pub(super) fn measure(table: &mut Table) {
    table.heading("Extremes of quick-return");
    table.elsewhere("rows 1, 8, 36, 720: difference of extremes, of their range", "not measured yet");
}
