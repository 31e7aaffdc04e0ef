//! Jansen's walker as a file: what a right-hand side costs in the run, and what follows the integration.

use super::Table;
use super::binary::{Binary, most_memory};
use serde_json::Value;
use std::io;
use std::path::Path;

/// Pairs of legs.
const PAIRS: [u32; 4] = [1, 3, 6, 12];
/// Runs of each, of which the least times count.
const RUNS: usize = 3;

/// The least times of a run, in seconds.
struct Times {
    /// A right-hand side with its part of the projections, rows and searches.
    right_hand_side: f64,
    /// From the end of the integration to the last file.
    output: f64,
}

pub(super) fn walker_runs(table: &mut Table) {
    table.heading("Jansen's walker with 2 n legs, `sim run --t-end 0.5` of its file");
    if let Err(why) = measure(table) {
        table.line("the binary", why, "measured", false);
    }
}

fn measure(table: &mut Table) -> io::Result<()> {
    let binary = Binary::built("figures-walker")?;
    let text = include_str!("../../robots/declared/beest.rs");
    let mut one = f64::NAN;
    for n in PAIRS {
        let file = format!("walker-{n}.rs");
        std::fs::write(binary.folder.join(&file), text.replace("const n = 6;", &format!("const n = {n};")))?;
        let run = ["run", &file, "--t-end", "0.5", "--out", "out", "--quiet"];
        let mut times = Times { right_hand_side: f64::INFINITY, output: f64::INFINITY };
        for _ in 0..RUNS {
            binary.succeed(&run)?;
            times = least(times, &binary.folder.join("out"))?;
        }
        let count = f64::from(n);
        if n == 1 {
            one = times.right_hand_side;
            let value = format!("{:.2} us", one * 1e6);
            table.line("n = 1: a right-hand side with its projection, interpreted", value, "printed", true);
        } else {
            let what = format!("n = {n}: a right-hand side with its projection, relative to n = 1");
            table.at_most(&what, times.right_hand_side / one, 1.5 * count);
        }
        let what = format!("n = {n}: from the end of integration to the last file, in s");
        table.at_most(&what, times.output, 0.5 + 0.1 * count);
        if n == 12 {
            let report = std::fs::metadata(binary.folder.join("out/report.html"))?.len();
            table.at_most("n = 12: the report, in MB", report as f64 / 1e6, 10.0);
            let memory = most_memory(&mut binary.command(&run))?;
            table.at_most("n = 12: the most memory, in MB", memory / 1e6, 300.0);
        }
    }
    Ok(())
}

/// The lesser of times and those that the files of a run tell.
fn least(times: Times, folder: &Path) -> io::Result<Times> {
    let read = |name: &str| -> io::Result<Value> { Ok(serde_json::from_slice(&std::fs::read(folder.join(name))?)?) };
    let (timing, summary) = (read("timing.json")?, read("summary.json")?);
    let seconds = |name: &str| timing[name].as_f64().unwrap_or(f64::NAN);
    let integration = seconds("integration_seconds");
    let evaluations = summary["method"]["right_hand_sides"].as_f64().unwrap_or(f64::NAN);
    Ok(Times {
        right_hand_side: times.right_hand_side.min(integration / evaluations),
        output: times.output.min(seconds("total_seconds") - seconds("integrated_seconds")),
    })
}
