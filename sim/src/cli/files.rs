//! The files of a run.

use super::Stop;
use super::arguments::RunArguments;
use super::run_file::Reproduction;
use crate::outcome::{Outcome, Recorded};
use crate::show::{self, About, ShowError};
use crate::write::summary_of;
use crate::{Format, Table, WriteError, write_json, write_table};
use serde_json::json;
use sim_kernel::Description;
use std::fs;
use std::path::Path;
use std::time::Instant;

/// What was written.
pub(super) struct Written {
    /// The names of files.
    pub(super) names: Vec<String>,
    /// How many figures.
    pub(super) figures: usize,
    /// Seconds from the start until figures were begun, and in all.
    pub(super) without_figures: f64,
    pub(super) total: f64,
    /// What could not be drawn.
    failures: Vec<ShowError>,
}

impl Written {
    /// All that could not be drawn, as one error.
    pub(super) fn check(&self) -> Result<(), Stop> {
        let failures: Vec<String> = self.failures.iter().map(ToString::to_string).collect();
        match failures.is_empty() {
            true => Ok(()),
            false => Err(Stop::Failed(anyhow::anyhow!("{}", failures.join("\nerror: ")))),
        }
    }
}

/// Removes what an earlier run wrote, so that nothing there is older than the run that it seems to belong to.
pub(super) fn remove_earlier(description: &Description, directory: &Path) -> Result<(), Stop> {
    let figures = description.figures.iter().map(|figure| figure.name).chain(["mechanism"]);
    let figures = figures.flat_map(|name| [format!("{name}.svg"), format!("{name}.png")]);
    let tables = ["csv", "jsonl", "npy", "npz", "parquet"].map(|extension| format!("trajectory.{extension}"));
    let others = ["report.html", "summary.json", "timing.json"].map(String::from);
    for name in figures.chain(tables).chain(others) {
        let path = directory.join(name);
        if path.is_file() {
            fs::remove_file(&path).map_err(|e| WriteError::new(&path, e))?;
        }
    }
    Ok(())
}

/// Writes everything: run file, tables, summary, figures, report, and last the times.
pub(super) fn write(
    run: &dyn Recorded,
    outcome: &Outcome,
    table: &Table,
    arguments: &RunArguments,
    (reproduction, directory, clock): (&Reproduction, &Path, Instant),
) -> Result<Written, Stop> {
    fs::create_dir_all(directory).map_err(|e| WriteError::new(directory, e))?;
    let mut names = vec!["run.json".to_owned()];
    write_json(&reproduction.file, &directory.join("run.json"))?;
    for format in Format::ALL.iter().filter(|format| arguments.format.contains(format)) {
        write_table(table, *format, directory)?;
        names.push(format!("trajectory.{}", format.name()));
    }
    let summary = summary_of(outcome, table);
    write_json(&summary, &directory.join("summary.json"))?;
    names.push("summary.json".into());
    let without_figures = clock.elapsed().as_secs_f64();
    let is_empty = table.times().is_empty();
    let mut failures = Vec::new();
    if !arguments.no_report && !is_empty {
        let about = About { summary: &summary, command: &reproduction.command, run_file: Some(&reproduction.text()) };
        match show::report_of(run, outcome, table, &about, &directory.join("report.html")) {
            Ok(()) => names.push("report.html".into()),
            Err(failure) => failures.push(failure),
        }
    }
    let size = arguments.size.show();
    let drawn = if arguments.no_figures || is_empty {
        show::Figures::default()
    } else {
        show::figures_of(run, outcome, table, directory, size)
    };
    failures.extend(drawn.failures);
    names.extend(drawn.names.iter().flat_map(|name| [format!("{name}.svg"), format!("{name}.png")]));
    let total = clock.elapsed().as_secs_f64();
    let timing = json!({
        "integration_seconds": outcome.integration_seconds,
        "without_figures_seconds": without_figures,
        "total_seconds": total,
    });
    write_json(&timing, &directory.join("timing.json"))?;
    names.push("timing.json".into());
    Ok(Written { names, figures: drawn.names.len(), without_figures, total, failures })
}
