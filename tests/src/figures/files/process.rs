//! What `sim run` takes as a process.

use super::milliseconds;
use crate::figures::Table;
use std::io;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::Instant;

/// Runs of the binary, of which the median counts.
const PROCESSES: usize = 21;

pub(super) fn whole_process(table: &mut Table) {
    table.heading("The whole process: read, derive, integrate, write");
    if let Err(why) = processes(table) {
        table.line("the binary", why, "measured", false);
    }
}

fn processes(table: &mut Table) -> io::Result<()> {
    let workspace = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let folder = workspace.join("target/figures-files");
    let _ = std::fs::remove_dir_all(&folder);
    std::fs::create_dir_all(&folder)?;
    let mut build = Command::new("cargo");
    succeed(build.args(["build", "--release", "--quiet", "-p", "sim"]).current_dir(&workspace))?;
    let target = std::env::var_os("CARGO_TARGET_DIR").map_or(workspace.join("target"), PathBuf::from);
    let sim = target.join("release/sim");
    let command = |words: &[&str]| {
        let mut command = Command::new(&sim);
        command.args(words).current_dir(&folder);
        command
    };
    succeed(&mut command(&["new", "--file", "quick-return.mech", "--from", "quick-return"]))?;
    let without_png = ["run", "quick-return.mech", "--quiet", "--no-png"];
    let plain = ["run", "quick-return.mech", "--quiet", "--no-figures", "--no-report"];
    for (what, words, bound) in [
        ("no figures, no report, in ms", &plain[..], 25.0),
        ("with report and figures as SVG, in ms", &without_png, 150.0),
        ("with report and figures, PNG too, in ms", &plain[..3], 400.0),
    ] {
        let mut times = Vec::new();
        for _ in 0..PROCESSES {
            let clock = Instant::now();
            succeed(&mut command(words))?;
            times.push(milliseconds(clock.elapsed()));
        }
        times.sort_by(f64::total_cmp);
        table.at_most(&format!("sim run quick-return.mech, {what}"), times[PROCESSES / 2], bound);
    }
    Ok(())
}

fn succeed(command: &mut Command) -> io::Result<()> {
    let output = command.output()?;
    match output.status.success() {
        true => Ok(()),
        false => Err(io::Error::other(String::from_utf8_lossy(&output.stderr).into_owned())),
    }
}
