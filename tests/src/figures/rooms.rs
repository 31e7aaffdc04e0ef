//! A house with rooms: imports, functions and files.

use super::builds::{first_build_and_before, first_build_and_change};
use super::sizes::sizes_at_run_time;
use super::{Subject, Table};
use std::path::Path;
use tests::house::{CRATES, Crate, Long, Source, imports, long_files, long_functions, out_of_order, rings};

pub(super) const SUBJECTS: &[Subject] = &[
    ("sizes", sizes_at_run_time),
    ("builds", first_build_and_change),
    ("build-before", first_build_and_before),
    ("imports", imports_of_crates),
    ("lengths", lengths),
];

/// The longest that functions and files are to be.
const MOST: [usize; 2] = [60, 400];

/// The source of each crate; one that cannot be read is a line that is missed.
fn sources(table: &mut Table) -> Vec<(&'static Crate, Source)> {
    let mut found = Vec::new();
    for of in CRATES {
        match Source::read(&Path::new(env!("CARGO_MANIFEST_DIR")).join("..").join(of.folder)) {
            Ok(source) => found.push((of, source)),
            Err(error) => table.line(of.folder, error, "read", false),
        }
    }
    found
}

/// Rings between modules, but for child and parent, and imports against the order of stages.
fn imports_of_crates(table: &mut Table) {
    table.heading("Imports inside each crate");
    for (of, source) in sources(table) {
        let found = imports(&source);
        let (rings, against) = (rings(&found), out_of_order(of, &found));
        rings.iter().for_each(|ring| println!("  ring: {}", ring.join(", ")));
        against.iter().for_each(|import| println!("  against the order: {import}"));
        table.at_most(&format!("{}: rings", of.folder), rings.len() as f64, 0.0);
        table.at_most(&format!("{}: imports of a later stage", of.folder), against.len() as f64, 0.0);
    }
}

fn lengths(table: &mut Table) {
    table.heading("Lengths of functions and files, in lines");
    for (of, source) in sources(table) {
        let [functions, files] = [long_functions(&source, 0), long_files(&source, 0)];
        for (name, all, most) in [("functions", functions, MOST[0]), ("files", files, MOST[1])] {
            all.iter().filter(|long| long.lines > most).for_each(|long| println!("  {}: {}", long.what, long.lines));
            let what = format!("{}: the longest of {} {name}", of.folder, all.len());
            let [median, ninetieth, longest] = [0.5, 0.9, 1.0].map(|part| quantile(&all, part));
            table.at_most(&format!("{what}; median {median}, 90th percentile {ninetieth}"), longest, most as f64);
        }
    }
}

fn quantile(all: &[Long], part: f64) -> f64 {
    let mut lines: Vec<usize> = all.iter().map(|long| long.lines).collect();
    lines.sort_unstable();
    lines.get(((lines.len() as f64 - 1.0) * part).round() as usize).map_or(0.0, |lines| *lines as f64)
}
