//! The report of a run or a sweep: one page with the mechanism in motion, plots, tables and equations, that needs no network.
//!
//! Tables and equations are written here, as HTML; the motion and the curves travel as packed floats and are drawn by
//! the page's own script (`sim/output/assets/report`). The same run gives the same bytes.

mod data;
mod html;
mod live;
mod page;
mod rows;
mod sweep;
mod tables;

use super::ShowError;
use crate::outcome::{Outcome, Recorded, Rows};
use crate::whole::whole_bytes;
use data::Group;
use html::number;
use serde_json::Value;
use sim_kernel::{Description, Mechanism};
use sim_runtime::{Failure, Run, Table};
use std::path::Path;

pub use live::{Live, waiting_page};
pub use sweep::{sweep_report, sweep_report_text};

/// The contents of a report beside the run itself.
#[derive(Clone, Copy, Debug)]
pub struct About<'a> {
    /// The run's summary, as [`crate::summary`] makes it.
    pub summary: &'a Value,
    /// The command that repeats the run.
    pub command: &'a str,
    /// The run file that repeats it, as text.
    pub run_file: Option<&'a str>,
}

/// Writes the report of a run to a file.
///
/// Long runs are thinned out to keep the page under 2 MB: samples at equal distances, and those where a quantity is
/// largest or smallest.
///
/// # Errors
/// If there is no sample, or the file cannot be written.
pub fn report<M: Mechanism>(run: &Run<M>, table: &Table, about: &About, path: &Path) -> Result<(), ShowError> {
    report_of(run, &run.outcome(), table, about, path)
}

/// The same of a run whose mechanism has no type.
///
/// # Errors
/// As [`report`].
pub fn report_of(
    run: &dyn Recorded,
    outcome: &Outcome,
    table: &Table,
    about: &About,
    path: &Path,
) -> Result<(), ShowError> {
    write_page(&report_text(run, outcome, table, about)?, path)
}

/// The same as a text.
///
/// # Errors
/// If there is no sample.
pub fn report_text(run: &dyn Recorded, outcome: &Outcome, table: &Table, about: &About) -> Result<String, ShowError> {
    of_run(run, outcome, table, about).page(None)
}

/// The same as a page that is served, and follows what it shows.
///
/// # Errors
/// If there is no sample.
pub fn live_report(
    run: &dyn Recorded,
    outcome: &Outcome,
    table: &Table,
    about: &About,
    live: &Live,
) -> Result<String, ShowError> {
    of_run(run, outcome, table, about).page(Some(live))
}

/// What the page of a run shows.
fn of_run<'a>(run: &'a dyn Recorded, outcome: &'a Outcome, table: &'a Table, about: &'a About) -> Shown<'a> {
    Shown {
        description: outcome.description,
        rows: run,
        table,
        times: table.times().to_vec(),
        abscissa: None,
        figures: &Vec::new,
        has_energy: true,
        is_at_rest: false,
        marks: outcome.events.iter().map(|event| event.time).collect(),
        period: outcome.period,
        failure: outcome.failure.as_ref(),
        facts: facts(outcome, about),
        tables: tables::tables(outcome, about.summary),
        command: about.command,
        run_file: about.run_file,
    }
}

/// The run in short.
fn facts(run: &Outcome, about: &About) -> Vec<Fact> {
    let (n, m) = (run.description.coordinates.len(), run.description.constraints.len());
    let mut facts = vec![("Time", format!("0 to {} s", number(run.reached, 12)), false)];
    if let Some(period) = run.period {
        facts.push(("Period", format!("{} s", number(period, 12)), false));
    }
    facts.push(("Coordinates", n.to_string(), false));
    if m > 0 {
        let open = number(run.position_residual, 2);
        facts.push(("Constraints", format!("{m}, open by at most {open}"), false));
    }
    if let Some(name) = about.summary["method"]["name"].as_str() {
        facts.push(("Method", name.to_owned(), false));
    }
    let doubtful = run.is_out_of_balance();
    facts.push(("Energy balance off by", number(run.energy_balance, 2), doubtful));
    facts
}

/// A fact with its name, and whether it is a warning.
type Fact = (&'static str, String, bool);

/// What a page shows.
struct Shown<'a> {
    description: &'static Description,
    rows: &'a dyn Rows,
    table: &'a Table,
    /// The time of each sample in the animation, in increasing order.
    times: Vec<f64>,
    /// What is shown for that time, if it is not time.
    abscissa: Option<Abscissa>,
    /// Figures beside those of outputs and states.
    figures: &'a dyn Fn() -> Vec<Group>,
    has_energy: bool,
    is_at_rest: bool,
    /// Times to be marked.
    marks: Vec<f64>,
    period: Option<f64>,
    failure: Option<&'a Failure>,
    facts: Vec<Fact>,
    tables: String,
    command: &'a str,
    run_file: Option<&'a str>,
}

/// A quantity that changes in proportion to the time of the animation, in its declared unit.
struct Abscissa {
    name: &'static str,
    unit: &'static str,
    label: String,
    /// At the start.
    from: f64,
    /// Per second.
    rate: f64,
}

impl Shown<'_> {
    fn page(&self, live: Option<&Live>) -> Result<String, ShowError> {
        match self.times.is_empty() {
            true => Err(ShowError::empty("report", "the run has no sample")),
            false => Ok(page::page(self, live)),
        }
    }
}

fn write_page(page: &str, path: &Path) -> Result<(), ShowError> {
    whole_bytes(path, page.as_bytes()).map_err(|why| ShowError::write(path, why))
}
