//! Mechanisms as files: the same bits without a compiler, and what that costs.

mod calls;
mod first;
mod printed;
mod process;

use super::{Subject, Table};
use std::time::Duration;
use tests::same_bits::{compiled, differences, interpreted};

pub(super) const SUBJECTS: &[Subject] = &[
    ("bits", same_bits),
    ("process", process::whole_process),
    ("call", calls::a_call),
    ("blocks", calls::blocks),
    ("run", calls::a_run),
    ("first", first::first_results),
    ("watch", printed::watch),
    ("python", printed::python),
    ("mangled", printed::mangled),
];

/// Where every kernel is called.
const STATES: usize = 1000;

fn same_bits(table: &mut Table) {
    table.heading("The same bits");
    let found: Vec<String> = compiled()
        .into_iter()
        .enumerate()
        .flat_map(|(seed, compiled)| match interpreted(&*compiled) {
            Ok(interpreted) => differences(&*compiled, &*interpreted, STATES, seed as u64),
            Err(mistakes) => vec![mistakes.to_string()],
        })
        .collect();
    found.iter().for_each(|difference| println!("  {difference}"));
    table.at_most("kernels of shipped mechanisms with other bits, of 1000 states", found.len() as f64, 0.0);
    printed::runs(table);
}

fn milliseconds(time: Duration) -> f64 {
    1e3 * time.as_secs_f64()
}
