//! What the compiler takes: the first build of this workspace, and a change in a user's crate until its picture.

use super::Table;
use std::io;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::Instant;

/// Changes that are timed, of which the median counts.
const CHANGES: usize = 5;

/// The commit whose first build took 150 s when at most 100 s were asked for: machines differ, their ratio does less.
const BEFORE: &str = "3c98f408048eb4d271d11fdacb09a4926d8f9fea";
const TIME_BEFORE: f64 = 150.0;
const MOST_TIME: f64 = 100.0;

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
    let target = folder.join("target");
    let seconds = first_build(&workspace(), &target)?;
    table.at_most("first build of the workspace, in seconds; two idle cores", seconds, MOST_TIME);
    let own = folder.join("own");
    succeed(Command::new(target.join("release/sim")).arg("new").arg(&own))?;
    for (profile, options, bound) in [("debug", "", 3.0), ("release", "--release", 5.0)] {
        let seconds = of_a_change(&own, options)?;
        table.at_most(&format!("a change until its picture, {profile}: seconds of processor"), seconds, bound);
    }
    Ok(())
}

fn workspace() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// The seconds that a first build takes.
fn first_build(workspace: &Path, target: &Path) -> io::Result<f64> {
    succeed(Command::new("cargo").args(["fetch", "--quiet"]).current_dir(workspace))?;
    let mut build = Command::new("cargo");
    build.args(["build", "--release", "--quiet"]).current_dir(workspace).env("CARGO_TARGET_DIR", target);
    let clock = Instant::now();
    succeed(&mut build)?;
    Ok(clock.elapsed().as_secs_f64())
}

/// Builds the workspace for the first time, and as it was when the bound was set, on the same machine.
pub(super) fn first_build_and_before(table: &mut Table) {
    table.heading("The first build beside that of the commit for which the bound was set");
    let folder = workspace().join("target/figures-before");
    let before = folder.join("workspace");
    let ratio = checked_out(&before).and_then(|()| {
        let seconds = |name, workspace| {
            let target = folder.join(name);
            let seconds = first_build(workspace, &target);
            std::fs::remove_dir_all(target).and(seconds)
        };
        let times = [seconds("before", &before)?, seconds("now", &workspace())?];
        println!("  {:.1} s before, {:.1} s now", times[0], times[1]);
        Ok(times[1] / times[0])
    });
    let what = "first build beside that before";
    match ratio {
        Ok(ratio) => {
            table.at_most(what, ratio, MOST_TIME / TIME_BEFORE);
            table.at_most("  in seconds of the machine on which the bound was set", ratio * TIME_BEFORE, MOST_TIME);
        }
        Err(why) => table.line(what, why, "measured", false),
    }
}

/// The commit before, in a folder.
fn checked_out(folder: &Path) -> io::Result<()> {
    let _ = std::fs::remove_dir_all(folder);
    std::fs::create_dir_all(folder)?;
    let archive = format!("git archive {BEFORE} | tar -x -C '{}'", folder.display());
    succeed(&mut shell(&format!("set -o pipefail; {archive}"), &workspace()))
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
