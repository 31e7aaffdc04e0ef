//! Kills, pairs of runs into one folder, full disks.

use crate::figures::Table;
use std::path::PathBuf;
use std::process::Command;
use tests::faults::{Count, Faults};

pub(super) fn measure(table: &mut Table) {
    table.heading("Files under faults");
    if let Err(why) = measured(table) {
        table.line("kills, pairs of runs, full disks", why, "measured", false);
    }
}

fn measured(table: &mut Table) -> std::io::Result<()> {
    let faults = Faults::new(&program()?, &std::env::temp_dir().join(format!("faults-{}", std::process::id())))?;
    tell(table, "200 kills", faults.kills(200, 1)?);
    tell(table, "50 pairs of runs into one folder", faults.pairs(50)?);
    tell(table, "a full disk at every file", faults.full_disks(1)?);
    Ok(())
}

fn tell(table: &mut Table, what: &str, found: Count) {
    table.at_most(&format!("{what}: folders with a torn file"), found.torn as f64, 0.0);
    table.at_most(&format!("{what}: mixed without a word"), found.mixed as f64, 0.0);
    table.at_most(&format!("{what}: earlier results lost"), found.lost as f64, 0.0);
    table.at_most(&format!("{what}: folders that cannot be used again"), found.unusable as f64, 0.0);
}

/// The program of the tests of failures, which stands beside this one.
fn program() -> std::io::Result<PathBuf> {
    let here = std::env::current_exe()?;
    let is_release = !cfg!(debug_assertions);
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let mut build = Command::new(cargo);
    build.args(["build", "--quiet", "-p", "tests", "--bin", "failing"]).args(is_release.then_some("--release"));
    match build.status()?.success() {
        true => Ok(here.with_file_name(format!("failing{}", std::env::consts::EXE_SUFFIX))),
        false => Err(std::io::Error::other("the program of the tests could not be built")),
    }
}
