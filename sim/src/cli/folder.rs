//! The folder that a command writes into, and what it says of it.

use super::{Stop, Voice, print};
use crate::show::{Figures, ShowError};
use crate::{Format, Table, WriteError, write_json, write_table};
use serde_json::Value;
use sim_kernel::Description;
use std::fs;
use std::path::{Path, PathBuf};

/// A folder of results.
pub(super) struct Folder {
    directory: PathBuf,
    /// What has been written.
    names: Vec<String>,
    /// What could not be drawn.
    failures: Vec<ShowError>,
}

impl Folder {
    /// A folder without what was written into it before, so that nothing there is older than what it seems to belong to.
    pub(super) fn open(description: &Description, directory: &Path, figures: &[&str]) -> Result<Folder, Stop> {
        fs::create_dir_all(directory).map_err(|why| WriteError::new(directory, why))?;
        let figures = figures.iter().copied().chain(description.figures.iter().map(|figure| figure.name));
        let figures = figures.chain(["mechanism"]).flat_map(files_of);
        let tables = Format::ALL.iter().map(|format| format!("trajectory.{}", format.name()));
        let others = ["trajectory.parquet", "report.html", "summary.json", "timing.json"].map(String::from);
        for path in figures.chain(tables).chain(others).map(|name| directory.join(name)) {
            if path.is_file() {
                fs::remove_file(&path).map_err(|why| WriteError::new(&path, why))?;
            }
        }
        Ok(Folder { directory: directory.into(), names: Vec::new(), failures: Vec::new() })
    }

    /// Where it is.
    pub(super) fn directory(&self) -> &Path {
        &self.directory
    }

    /// The files in it.
    pub(super) fn names(&self) -> &[String] {
        &self.names
    }

    /// Writes a table in some formats.
    pub(super) fn table(&mut self, table: &Table, formats: &[Format]) -> Result<(), Stop> {
        for format in Format::ALL.iter().filter(|format| formats.contains(format)) {
            write_table(table, *format, &self.directory)?;
            self.names.push(format!("trajectory.{}", format.name()));
        }
        Ok(())
    }

    /// Writes a JSON file.
    pub(super) fn json(&mut self, value: &Value, name: &str) -> Result<(), Stop> {
        write_json(value, &self.directory.join(name))?;
        self.names.push(name.to_owned());
        Ok(())
    }

    /// Takes note of a file, or of why it was not written.
    pub(super) fn note(&mut self, name: &str, written: Result<(), ShowError>) {
        match written {
            Ok(()) => self.names.push(name.to_owned()),
            Err(failure) => self.failures.push(failure),
        }
    }

    /// Takes note of figures.
    pub(super) fn figures(&mut self, drawn: Figures) {
        self.names.extend(drawn.names.iter().flat_map(|name| files_of(name)));
        self.failures.extend(drawn.failures);
    }

    /// Prints what was found, as JSON with the folder and its files, or as text.
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

    /// All that could not be drawn, as one error.
    pub(super) fn check(&self) -> Result<(), Stop> {
        let failures: Vec<String> = self.failures.iter().map(ToString::to_string).collect();
        match failures.is_empty() {
            true => Ok(()),
            false => Err(Stop::Failed(anyhow::anyhow!("{}", failures.join("\nerror: ")))),
        }
    }
}

/// The files of a figure.
fn files_of(name: &str) -> [String; 2] {
    ["svg", "png"].map(|extension| format!("{name}.{extension}"))
}
