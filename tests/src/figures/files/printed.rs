//! Figures of files that tests and scripts print.

use crate::figures::Table;
use crate::figures::printed::{figure, output, passes, tell};
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

/// Parts of the 100,000, each a process of its own: what is told of a mechanism stays in memory as long as a process does.
const PARTS: usize = 20;

pub(super) fn mangled(table: &mut Table) {
    table.heading("100,000 mangled files");
    let clock = Instant::now();
    let mangled = "test --release --quiet -p tests --test interpreted -- --nocapture mangled";
    let lines = [("the slowest file, in s", 1.0), ("the most memory, in MB", 500.0)];
    let mut greatest = [0.0_f64; 2];
    for part in 0..PARTS {
        let mut command = Command::new("cargo");
        command.args(mangled.split(' ')).env("LINKWRIGHT_FUZZ", "10").env("LINKWRIGHT_SEED", (5000 * part).to_string());
        match output(&mut command) {
            Ok(text) => {
                for (greatest, (name, _)) in greatest.iter_mut().zip(lines) {
                    *greatest = greatest.max(figure(&text, name).unwrap_or(f64::INFINITY));
                }
            }
            Err(why) => table.line(&format!("part {part}"), why, "passed", false),
        }
    }
    greatest.into_iter().zip(lines).for_each(|(greatest, (name, bound))| table.at_most(name, greatest, bound));
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
