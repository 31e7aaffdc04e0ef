//! `sim list`.

use super::Stop;
use sim_kernel::Description;
use std::io::Write;

/// Prints each mechanism with its size and the first line of its documentation.
pub(super) fn list(mechanisms: impl Iterator<Item = &'static Description>) -> Result<(), Stop> {
    let mut out = std::io::stdout().lock();
    for d in mechanisms {
        let (coordinates, constraints) =
            (counted(d.coordinates.len(), "coordinate"), counted(d.constraints.len(), "constraint"));
        writeln!(out, "{:<20} {coordinates}, {constraints}", d.name)?;
        if let Some(line) = d.docs.lines().next() {
            writeln!(out, "{:<20} {line}", "")?;
        }
    }
    Ok(())
}

/// `1 step`, `2 steps`.
pub(super) fn counted(n: usize, what: &str) -> String {
    format!("{n} {what}{}", if n == 1 { "" } else { "s" })
}
