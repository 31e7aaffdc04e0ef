//! The files of a run.

use super::Stop;
use super::arguments::RunArguments;
use super::folder::Folder;
use super::run_file::Reproduction;
use crate::Table;
use crate::outcome::{Outcome, Recorded};
use crate::show::{self, About};
use serde_json::{Value, json};
use std::time::Instant;

/// How long a run took with its files, in seconds.
pub(super) struct Took {
    /// Until figures were begun.
    pub(super) without_figures: f64,
    /// In all.
    pub(super) total: f64,
}

/// Writes everything: run file, tables, summary, figures, report, and last the times.
pub(super) fn write(
    run: &dyn Recorded,
    (outcome, table, summary): (&Outcome, &Table, &Value),
    arguments: &RunArguments,
    reproduction: &Reproduction,
    folder: &mut Folder,
    clock: Instant,
) -> Result<Took, Stop> {
    folder.json(&reproduction.file, "run.json")?;
    folder.table(table, &arguments.format)?;
    folder.json(summary, "summary.json")?;
    let without_figures = clock.elapsed().as_secs_f64();
    let is_empty = table.times().is_empty();
    let directory = folder.directory().to_owned();
    if !arguments.no_report && !is_empty {
        let about = About { summary, command: &reproduction.command, run_file: Some(&reproduction.text()) };
        let written = show::report_of(run, outcome, table, &about, &directory.join("report.html"));
        folder.note("report.html", written);
    }
    if !arguments.no_figures && !is_empty {
        folder.figures(show::figures_of(run, outcome, table, &directory, arguments.size.show()));
    }
    let total = clock.elapsed().as_secs_f64();
    let timing = json!({
        "integration_seconds": outcome.integration_seconds,
        "without_figures_seconds": without_figures,
        "total_seconds": total,
    });
    folder.json(&timing, "timing.json")?;
    Ok(Took { without_figures, total })
}
