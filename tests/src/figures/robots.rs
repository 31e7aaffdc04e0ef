//! Robots as they come: URDF. Most need the package `example-robot-data` and Pinocchio, which `tests/robots/urdf/urdf.sh` installs.

use super::printed::{Bounded, passes, tell, tell_of_parts};
use super::{Subject, Table};
use std::process::Command;

pub(super) const SUBJECTS: &[Subject] =
    &[("pinocchio", pinocchio), ("first", first_results), ("trip", round_trip), ("mangled", mangled)];

/// What the script prints of a subject.
fn script(table: &mut Table, subject: &str, lines: &[Bounded]) {
    tell(table, Command::new("tests/robots/urdf/urdf.sh").arg(subject), lines);
}

fn pinocchio(table: &mut Table) {
    table.heading("The robots of example-robot-data against Pinocchio, fixed and free");
    let lines = [
        ("robots that differ or are read wrongly", 0.0),
        ("forward dynamics, largest difference", 1e-11),
        ("inverse dynamics, largest difference", 1e-11),
        ("mass matrix, largest difference", 1e-11),
        ("kinetic energy, largest difference", 1e-11),
        ("potential energy, largest difference", 1e-11),
    ];
    script(table, "compare", &lines);
}

fn first_results(table: &mut Table) {
    table.heading("The whole process, from URDF to report and figures");
    script(table, "first", &[("Panda, in s", 0.5), ("Talos, in s", 3.0)]);
}

fn round_trip(table: &mut Table) {
    table.heading("What sim import writes, run");
    script(table, "trip", &[("robots whose import runs to other bytes than their file", 0.0)]);
}

fn mangled(table: &mut Table) {
    table.heading("21,000 mangled robots");
    let test = "test --release --quiet -p tests --test import -- --nocapture mangled";
    let lines = [
        ("the slowest robot, in s", 1.0),
        ("an accepted robot beside its original", 2.0),
        ("the most memory, in MB", 500.0),
    ];
    tell_of_parts(table, test, [7, 10, 300], &lines);
    passes(table, "all tests of the import", "test --release --quiet -p tests --test import");
}
