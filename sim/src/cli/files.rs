//! The files that a command writes.

use super::arguments::Voice;
use super::{Stop, print};
use crate::show::Figures;
use crate::{Format, Table, WriteError, write_table};
use serde_json::Value;
use sim_kernel::Description;
use std::fs;
use std::path::{Path, PathBuf};

/// Files as they are written one after the other to a directory; one that cannot be does not keep the others from it.
pub(super) struct Files {
    directory: PathBuf,
    /// The names of those that were written.
    pub(super) names: Vec<String>,
    /// Why others could not be.
    pub(super) failures: Vec<String>,
}

impl Files {
    /// Makes the directory, before work that may take long, and removes what was written to it earlier, these figures too, so
    /// that nothing there is older than what it seems to belong to.
    pub(super) fn new(description: &Description, directory: &Path, figures: &[&str]) -> Result<Files, Stop> {
        fs::create_dir_all(directory).map_err(|e| WriteError::new(directory, e))?;
        let figures = description.figures.iter().map(|figure| figure.name).chain(figures.iter().copied());
        let figures = figures.flat_map(|name| [format!("{name}.svg"), format!("{name}.png")]);
        let tables = ["csv", "jsonl", "npy", "npz", "parquet"].map(|extension| format!("trajectory.{extension}"));
        let others = ["report.html", "summary.json", "timing.json"].map(String::from);
        for name in figures.chain(tables).chain(others) {
            let path = directory.join(name);
            if path.is_file() {
                fs::remove_file(&path).map_err(|e| WriteError::new(&path, e))?;
            }
        }
        Ok(Files { directory: directory.to_owned(), names: Vec::new(), failures: Vec::new() })
    }

    /// Writes a file. What there is of one that could not be finished is removed: it would look like a whole one.
    pub(super) fn add<E: ToString>(&mut self, name: &str, write: impl FnOnce(&Path) -> Result<(), E>) {
        let path = self.directory.join(name);
        match write(&path) {
            Ok(()) => self.names.push(name.to_owned()),
            Err(failure) => {
                self.failures.push(failure.to_string());
                if path.symlink_metadata().is_ok_and(|file| file.is_file()) {
                    let _ = fs::remove_file(&path);
                }
            }
        }
    }

    /// Writes a table in these formats.
    pub(super) fn add_table(&mut self, table: &Table, formats: &[Format]) {
        let directory = self.directory.clone();
        for format in Format::ALL.iter().filter(|format| formats.contains(format)) {
            let name = format!("trajectory.{}", format.name());
            self.add(&name, |_| write_table(table, *format, &directory).map(|_| ()));
        }
    }

    /// Where they are.
    pub(super) fn directory(&self) -> &Path {
        &self.directory
    }

    /// Takes note of figures that were drawn.
    pub(super) fn add_figures(&mut self, drawn: &Figures) {
        self.names.extend(drawn.names.iter().flat_map(|name| [format!("{name}.svg"), format!("{name}.png")]));
        self.failures.extend(drawn.failures.iter().map(ToString::to_string));
    }

    /// Prints what was found: as JSON with the directory and the files, or as text.
    pub(super) fn say(&self, voice: Voice, mut said: Value, text: &str) -> Result<(), Stop> {
        match voice {
            Voice { quiet: true, .. } => Ok(()),
            Voice { json: true, .. } => {
                said["directory"] = self.directory.to_string_lossy().into();
                said["files"] = self.names.clone().into();
                print(&format!("{said:#}\n"))
            }
            _ => print(text),
        }
    }

    /// The line on what was written.
    pub(super) fn line(&self) -> String {
        format!("written      {}: {}\n", self.directory.display(), self.names.join(", "))
    }

    /// Of these and what else went wrong, one error.
    pub(super) fn check(self, others: Vec<String>, is_interrupted: bool) -> Result<(), Stop> {
        let problems = [others, self.failures].concat().join("\nerror: ");
        match problems.is_empty() {
            true => Ok(()),
            false if is_interrupted => Err(Stop::Interrupted(anyhow::anyhow!(problems))),
            false => Err(Stop::Failed(anyhow::anyhow!(problems))),
        }
    }
}
