//! Random linkages.

use crate::figures::Table;

pub(super) fn measure(table: &mut Table) {
    table.heading("Random linkages");
    table.elsewhere("runs that are wrong, of 20,000", "cargo run --release -p tests --bin stress -- 20000 --seed 1");
}
