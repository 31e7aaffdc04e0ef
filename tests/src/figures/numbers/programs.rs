//! The programs that figures run.

use std::io;
use std::path::PathBuf;
use std::process::Command;

/// Builds `sim` and `found`, beside this program; whether it could.
pub(super) fn programs_are_built() -> bool {
    let build = "build --release -q -p sim -p tests --bin sim --bin found --features tests/found";
    Command::new("cargo").args(build.split(' ')).status().is_ok_and(|status| status.success())
}

/// Where a program is that was built beside this one.
pub(super) fn program(name: &str) -> io::Result<PathBuf> {
    Ok(std::env::current_exe()?.with_file_name(name))
}
