//! The command `sim`, built by this workspace and run in a folder of its own.

use std::io;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::Duration;

/// The time between two looks at the memory of a process.
const LOOK: Duration = Duration::from_millis(2);

/// The binary, and the folder that it runs in.
pub(super) struct Binary {
    sim: PathBuf,
    pub(super) folder: PathBuf,
}

impl Binary {
    /// Built for release, with a new folder of this name.
    pub(super) fn built(name: &str) -> io::Result<Binary> {
        let workspace = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
        let folder = workspace.join("target").join(name);
        let _ = std::fs::remove_dir_all(&folder);
        std::fs::create_dir_all(&folder)?;
        let mut build = Command::new("cargo");
        succeed(build.args(["build", "--release", "--quiet", "-p", "sim"]).current_dir(&workspace))?;
        let target = std::env::var_os("CARGO_TARGET_DIR").map_or(workspace.join("target"), PathBuf::from);
        Ok(Binary { sim: target.join("release/sim"), folder })
    }

    /// With these words.
    pub(super) fn command(&self, words: &[&str]) -> Command {
        let mut command = Command::new(&self.sim);
        command.args(words).current_dir(&self.folder);
        command
    }

    /// Runs it to its end.
    pub(super) fn succeed(&self, words: &[&str]) -> io::Result<()> {
        succeed(&mut self.command(words))
    }
}

fn succeed(command: &mut Command) -> io::Result<()> {
    let output = command.output()?;
    match output.status.success() {
        true => Ok(()),
        false => Err(io::Error::other(String::from_utf8_lossy(&output.stderr).into_owned())),
    }
}

/// The most memory that a process has had at once, in bytes, as Linux counts it.
pub(super) fn most_memory(command: &mut Command) -> io::Result<f64> {
    let mut child = command.stdout(Stdio::null()).stderr(Stdio::null()).spawn()?;
    let status = format!("/proc/{}/status", child.id());
    let mut most = f64::NAN;
    while child.try_wait()?.is_none() {
        let text = std::fs::read_to_string(&status).unwrap_or_default();
        let kilobytes =
            text.lines().find_map(|line| line.strip_prefix("VmHWM:")?.split_whitespace().next()?.parse().ok());
        most = kilobytes.map_or(most, |kilobytes: f64| kilobytes * 1024.0);
        std::thread::sleep(LOOK);
    }
    Ok(most)
}
