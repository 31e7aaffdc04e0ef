//! Least and greatest values of a sweep do not depend on its rows.

use crate::figures::Table;

pub(super) fn measure(table: &mut Table) {
    table.heading("Extremes of quick-return");
    for (what, value, bound) in tests::extremes::lines() {
        table.at_most(&what, value, bound);
    }
}
