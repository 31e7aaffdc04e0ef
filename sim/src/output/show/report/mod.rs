//! The report of a run: one page with the mechanism in motion, plots, tables and equations, that needs no network.
//!
//! Tables and equations are written here, as HTML; the motion and the curves travel as packed floats and are drawn by
//! the page's own script (`sim/assets/report`). The same run gives the same bytes.

mod data;
mod html;
mod page;
mod rows;
mod tables;

use super::ShowError;
use crate::output::outcome::{Outcome, Recorded};
use crate::output::whole::whole_bytes;
use crate::{Run, Table};
use serde_json::Value;
use sim_kernel::Mechanism;
use std::path::Path;

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

pub(crate) fn report_of(
    run: &dyn Recorded,
    outcome: &Outcome,
    table: &Table,
    about: &About,
    path: &Path,
) -> Result<(), ShowError> {
    if table.times().is_empty() {
        return Err(ShowError::empty("report", "the run has no sample"));
    }
    let page = page::page(run, outcome, table, about);
    whole_bytes(path, page.as_bytes()).map_err(|why| ShowError::write(path, why))
}
