//! Rows of verification, and the faults that make them fail.

use crate::figures::Table;
use sim::verify::{Check, verify};
use sim::{Mechanism, declared_start};

pub(super) fn measure(table: &mut Table) {
    table.heading("Verification");
    let mut failing = Vec::new();
    macro_rules! all {
        ($($model:ty),*) => { $(failing.extend(rows_that_fail(<$model>::default()));)* };
    }
    models::all_models!(all);
    failing.iter().for_each(|row| println!("{row}"));
    table.at_most("rows of shipped mechanisms that fail", failing.len() as f64, 0.0);
    table.elsewhere(
        "rows that a planted fault fails by 100 times the bound",
        "cargo test -p tests --test motion verification",
    );
}

/// Rows that fail, or why there are none.
fn rows_that_fail<M: Mechanism>(mechanism: M) -> Vec<String> {
    let name = M::DESCRIPTION.name;
    match verify(mechanism, &declared_start(&mechanism), 2.0) {
        Ok(checks) => checks
            .iter()
            .filter(|check| !check.passes())
            .map(|Check { name: row, figure, bound, .. }| format!("{name}: {row} {figure:?} of {bound:e}"))
            .collect(),
        Err(error) => vec![format!("{name}: {error}")],
    }
}
