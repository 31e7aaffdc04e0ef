//! `sim list`.

use crate::cli::arguments::Voice;
use crate::cli::{Stop, print};
use serde_json::json;
use sim_kernel::Description;

/// Prints each mechanism with its size and the first line of its documentation.
pub(in crate::cli) fn list(mechanisms: impl Iterator<Item = &'static Description>, voice: Voice) -> Result<(), Stop> {
    if voice.json {
        let of = |d: &Description| json!({ "name": d.name, "coordinates": d.coordinates.len(), "constraints": d.constraints.len(), "docs": d.docs });
        return print(&format!("{:#}\n", mechanisms.map(of).collect::<serde_json::Value>()));
    }
    let mut text = String::new();
    for d in mechanisms {
        let (coordinates, constraints) =
            (counted(d.coordinates.len(), "coordinate"), counted(d.constraints.len(), "constraint"));
        text += &format!("{:<20} {coordinates}, {constraints}\n", d.name);
        if let Some(line) = d.docs.lines().next() {
            text += &format!("{:<20} {line}\n", "");
        }
    }
    print(&text)
}

/// `1 step`, `2 steps`.
pub(in crate::cli) fn counted(n: usize, what: &str) -> String {
    format!("{n} {what}{}", if n == 1 { "" } else { "s" })
}
