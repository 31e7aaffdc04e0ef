//! Figures of files that tests and scripts print.

use crate::figures::Table;
use crate::figures::printed::{passes, tell, tell_of_parts};
use std::process::Command;
use std::time::Instant;

pub(super) fn runs(table: &mut Table) {
    let of_runs = "test --release --quiet -p tests --test results -- --ignored interpreted";
    passes(table, "shipped mechanisms, interpreted, run to the same bits", of_runs);
}

pub(super) fn watch(table: &mut Table) {
    table.heading("sim watch");
    let in_chromium = "test --release --quiet -p sim --test report -- --ignored --nocapture saved_file_to_changed_page";
    tell(table, Command::new("cargo").args(in_chromium.split(' ')), &[("saved file to changed page, in ms", 150.0)]);
    let attacked = "test --release --quiet -p sim --test command watch";
    passes(table, "hostile requests get 403, 404 or a closed connection", attacked);
}

pub(super) fn mangled(table: &mut Table) {
    table.heading("100,000 mangled files");
    let clock = Instant::now();
    let test = "test --release --quiet -p tests --test interpreted -- --nocapture mangled";
    tell_of_parts(table, test, [20, 10, 500], &[("the slowest file, in s", 1.0), ("the most memory, in MB", 500.0)]);
    table.at_most("minutes", clock.elapsed().as_secs_f64() / 60.0, 20.0);
}

pub(super) fn python(table: &mut Table) {
    table.heading("The Python package");
    let lines = [
        ("the wheel, in MB", 10.0),
        ("dynamics of one mass, in ns a call", 1000.0),
        ("dynamics of quick-return at 10000 states, in ns a state", 30.0),
    ];
    tell(table, &mut Command::new(".ci/python"), &lines);
}
