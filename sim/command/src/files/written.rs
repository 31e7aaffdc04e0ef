//! The files that a command writes.

use crate::arguments::{Voice, WrittenArguments};
use crate::files::folder;
use crate::files::identity::{self, PROVENANCE, RUN};
use crate::{Stop, print};
use serde_json::Value;
use sim_kernel::Description;
use sim_output::show::{FigureSettings, Figures, ShowError};
use sim_output::{Format, write_commented_csv, write_table};
use sim_runtime::Table;
use std::borrow::Cow;
use std::path::{Path, PathBuf};

/// Files written one after the other, and finally moved to a folder. One that cannot be written does not stop the
/// others.
pub(crate) struct Files {
    directory: PathBuf,
    /// The folder they are written to.
    unfinished: PathBuf,
    /// The names of those that were written.
    pub(crate) names: Vec<String>,
    /// Why others could not be.
    pub(crate) failures: Vec<String>,
    /// Whether one could not be written.
    is_short: bool,
}

impl Files {
    /// Creates and locks the folder, before work that may take long. Earlier files, these figures too, are removed when
    /// [`Files::finish`] has newer ones.
    pub(crate) fn new(description: &Description, directory: &Path, figures: &[&str]) -> Result<Files, Stop> {
        let figures = description.figures.iter().map(|figure| figure.name).chain(figures.iter().copied());
        let figures = figures.flat_map(|name| [format!("{name}.svg"), format!("{name}.png")]);
        let tables = ["csv", "jsonl", "npy", "npz", "parquet"].map(|extension| format!("trajectory.{extension}"));
        let unfinished = folder::hold(directory, figures.chain(tables).chain(["report.html".into()]).collect())?;
        let (names, failures) = (Vec::new(), Vec::new());
        Ok(Files { directory: directory.to_owned(), unfinished, names, failures, is_short: false })
    }

    /// Writes a file.
    pub(crate) fn add<E: Into<ShowError>>(&mut self, name: &str, write: impl FnOnce(&Path) -> Result<(), E>) {
        match write(&self.unfinished.join(name)) {
            Ok(()) => folder::add(name),
            Err(failure) => self.fail(failure.into()),
        }
    }

    /// Writes the columns of a table that are asked for, all if one is not there, in all formats that are.
    pub(crate) fn add_table(&mut self, table: &Table, written: &WrittenArguments) {
        let chosen = written.chosen(table).unwrap_or_else(|why| {
            self.failures.push(why);
            Cow::Borrowed(table)
        });
        let table = &*chosen;
        for format in Format::ALL.iter().filter(|format| written.format.contains(format)) {
            self.add(&format!("trajectory.{}", format.name()), |path| match format {
                Format::Csv if written.csv_comments => write_commented_csv(table, path),
                _ => write_table(table, *format, path.parent().unwrap_or(path)).map(|_| ()),
            });
        }
    }

    /// Their final folder.
    pub(crate) fn directory(&self) -> &Path {
        &self.directory
    }

    /// Draws figures into a folder that it is given.
    pub(crate) fn add_figures(&mut self, settings: FigureSettings, draw: impl FnOnce(&Path) -> Figures) {
        let drawn = draw(&self.unfinished);
        for name in &drawn.names {
            folder::add(&format!("{name}.svg"));
            if settings.png {
                folder::add(&format!("{name}.png"));
            }
        }
        drawn.failures.into_iter().for_each(|failure| self.fail(failure));
    }

    /// Whether all files could be written so far: if there is no room for numbers, pictures would only take more.
    pub(crate) fn has_room(&self) -> bool {
        !self.is_short
    }

    /// Records a file that could not be written or drawn.
    fn fail(&mut self, failure: ShowError) {
        let failure = match failure {
            ShowError::Write { path, why } => {
                self.is_short = true;
                let path = path.strip_prefix(&self.unfinished).map_or(path.clone(), |name| self.directory.join(name));
                ShowError::Write { path, why }
            }
            other => other,
        };
        self.failures.push(failure.to_string());
    }

    /// Names a run by its table and these values. From here on they bear the name, and say where they come from: of this
    /// command.
    pub(crate) fn name_run(table: &mut Table, command: String, values: &mut [&mut Value]) {
        let run = identity::of_run(table, &values.iter().map(|value| &**value).collect::<Vec<_>>());
        table.provenance.command = Some(command);
        table.provenance.run = Some(run.clone());
        for object in values.iter_mut().filter_map(|value| value.as_object_mut()) {
            object.shift_insert(0, RUN.to_owned(), run.clone().into());
            object.insert(PROVENANCE.to_owned(), table.provenance.to_json());
        }
    }

    /// Moves all files to their places, with `summary.json`, which lists them. Only then are earlier ones removed.
    pub(crate) fn finish(&mut self) {
        let filled = folder::fill(self.is_short);
        self.failures.extend(filled.failures.iter().map(ToString::to_string));
        if let Some(aside) = filled.aside {
            let (directory, aside) = (self.directory.display(), aside.display());
            self.failures.push(format!("earlier results stay in {directory}; what could be written is in {aside}"));
        }
        self.names = filled.names;
    }

    /// Prints the results: as JSON with the directory and the files, or as text.
    pub(crate) fn say(&self, voice: Voice, mut said: Value, text: &str) -> Result<(), Stop> {
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
    pub(crate) fn line(&self) -> String {
        format!("written      {}: {}\n", self.directory.display(), self.names.join(", "))
    }

    /// One error from these and other failures.
    pub(crate) fn check(self, others: Vec<String>, is_interrupted: bool) -> Result<(), Stop> {
        let problems = [others, self.failures].concat().join("\nerror: ");
        match problems.is_empty() {
            true => Ok(()),
            false if is_interrupted => Err(Stop::Interrupted(anyhow::anyhow!(problems))),
            false => Err(Stop::Failed(anyhow::anyhow!(problems))),
        }
    }
}
