//! What `sim run` takes as a process.

use super::milliseconds;
use crate::figures::Table;
use crate::figures::binary::Binary;
use std::io;
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
    let binary = Binary::built("figures-files")?;
    binary.succeed(&["new", "--file", "quick-return.mech", "--from", "quick-return"])?;
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
            binary.succeed(words)?;
            times.push(milliseconds(clock.elapsed()));
        }
        times.sort_by(f64::total_cmp);
        table.at_most(&format!("sim run quick-return.mech, {what}"), times[PROCESSES / 2], bound);
    }
    Ok(())
}
