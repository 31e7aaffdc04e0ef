//! What the compiler takes: the first build of this workspace, and a change in a user's crate until its picture.

use super::Table;
use std::io;
use std::path::Path;
use std::process::Command;
use std::time::Instant;

/// Changes that are timed, of which the median counts.
const CHANGES: usize = 5;

/// Builds the workspace for the first time, then a crate as `sim new` makes it, and changes that.
pub(super) fn first_build_and_change(table: &mut Table) {
    table.heading("Builds");
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../target/figures-builds");
    if let Err(why) = measure(table, &folder) {
        table.line("builds", why, "measured", false);
    }
}

fn measure(table: &mut Table, folder: &Path) -> io::Result<()> {
    let _ = std::fs::remove_dir_all(folder);
    std::fs::create_dir_all(folder)?;
    let (workspace, target) = (Path::new(env!("CARGO_MANIFEST_DIR")).join(".."), folder.join("target"));
    let clock = Instant::now();
    let mut build = Command::new("cargo");
    succeed(build.args(["build", "--release", "--quiet"]).current_dir(workspace).env("CARGO_TARGET_DIR", &target))?;
    table.at_most("first build of the workspace, in seconds; two idle cores", elapsed(clock), 100.0);
    let own = folder.join("own");
    succeed(Command::new(target.join("release/sim")).arg("new").arg(&own))?;
    for (profile, options, bound) in [("debug", "", 3.0), ("release", "--release", 5.0)] {
        let seconds = of_a_change(&own, options)?;
        table.at_most(&format!("a change until its picture, {profile}: seconds of processor"), seconds, bound);
    }
    Ok(())
}

fn elapsed(clock: Instant) -> f64 {
    clock.elapsed().as_secs_f64()
}

/// The time of the processor that a change in the declaration takes until its run is drawn.
fn of_a_change(own: &Path, options: &str) -> io::Result<f64> {
    let run = format!("cargo run --quiet {options} -- run own --quiet");
    let source = own.join("src/lib.rs");
    let text = std::fs::read_to_string(&source)?;
    succeed(&mut shell(&run, own))?;
    let mut times = Vec::new();
    for change in 0..CHANGES {
        std::fs::write(&source, text.replace("crank [mm] = 100", &format!("crank [mm] = 100.{}", change + 1)))?;
        times.push(processor_time(&run, own)?);
    }
    std::fs::write(&source, text)?;
    times.sort_by(f64::total_cmp);
    Ok(times[CHANGES / 2])
}

/// The seconds of the processor that a command takes, with all that it starts.
fn processor_time(command: &str, folder: &Path) -> io::Result<f64> {
    let timed = format!("TIMEFORMAT='%U %S'; time {command}");
    let output = shell(&timed, folder).output()?;
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    let last = said.lines().last().unwrap_or_default();
    let seconds: Option<Vec<f64>> = last.split(' ').map(|word| word.parse().ok()).collect();
    match (output.status.success(), seconds) {
        (true, Some(seconds)) => Ok(seconds.iter().sum()),
        _ => Err(io::Error::other(said)),
    }
}

/// A command in a folder, which builds there.
fn shell(command: &str, folder: &Path) -> Command {
    let mut shell = Command::new("bash");
    shell.args(["-c", command]).current_dir(folder).env_remove("CARGO_TARGET_DIR");
    shell
}

fn succeed(command: &mut Command) -> io::Result<()> {
    let output = command.output()?;
    match output.status.success() {
        true => Ok(()),
        false => Err(io::Error::other(String::from_utf8_lossy(&output.stderr).into_owned())),
    }
}
