//! Runs read back from their directories.

use crate::files::{asked, identity};
use crate::{Stop, unknown};
use sim_output::WriteError;
use sim_runtime::Provenance;
use std::fs::File;
use std::io;
use std::path::{Path, PathBuf};

/// The table of a run.
pub(crate) struct Stored {
    /// The label of its curves: its directory.
    pub(crate) name: String,
    columns: Vec<StoredColumn>,
    /// Where it comes from, as far as the files beside it say.
    provenance: Provenance,
}

/// A column, as its header says.
pub(crate) struct StoredColumn {
    /// Its name.
    pub(crate) name: String,
    /// Its unit; 1 where the header has none.
    pub(crate) unit: String,
    /// Whether the header has one.
    pub(crate) has_unit: bool,
    /// Its values.
    pub(crate) values: Vec<f64>,
}

impl Stored {
    /// Reads a run's directory, or its CSV.
    pub(crate) fn read(path: &Path) -> Result<Stored, Stop> {
        if path.is_dir() {
            identity::check(path)?;
        }
        let file = if path.is_dir() { path.join("trajectory.csv") } else { path.to_owned() };
        if !file.is_file() {
            return Err(Stop::Usage(format!(
                "no run at {}: {} is missing; `run` writes it, unless other formats are asked for",
                path.display(),
                file.display()
            )));
        }
        let columns = columns(&file)?;
        let directory = file.parent().and_then(Path::file_name).unwrap_or(file.as_os_str());
        let provenance = identity::provenance(file.parent().unwrap_or(Path::new("")));
        Ok(Stored { name: directory.to_string_lossy().into_owned(), columns, provenance })
    }

    /// A column by name.
    pub(crate) fn column(&self, name: &str) -> Result<&StoredColumn, Stop> {
        let known = || self.columns.iter().map(|column| column.name.as_str());
        self.columns.iter().find(|column| column.name == name).ok_or_else(|| unknown("quantity", name, known()))
    }

    /// The names of all columns.
    pub(crate) fn names(&self) -> impl Iterator<Item = &str> {
        self.columns.iter().map(|column| column.name.as_str())
    }
}

impl StoredColumn {
    /// `name [unit]`; a pure number's is 1.
    pub(crate) fn header(&self) -> String {
        format!("{} [{}]", self.name, self.unit)
    }
}

/// Where a figure of these runs comes from: of this command, and of what they have in common.
pub(crate) fn provenance_of(runs: &[Stored]) -> Provenance {
    let common = |of: fn(&Provenance) -> &Option<String>| {
        let mut values = runs.iter().map(|run| of(&run.provenance));
        values.next().filter(|first| values.all(|other| other == *first)).cloned().flatten()
    };
    let names: Vec<&str> = runs.iter().filter_map(|run| run.provenance.run.as_deref()).collect();
    Provenance {
        model: common(|of| &of.model),
        declaration: common(|of| &of.declaration),
        command: Some(asked::command()),
        run: (!names.is_empty()).then(|| names.join(", ")),
    }
}

/// The columns of a CSV; `-` is standard input.
pub(crate) fn columns(file: &Path) -> Result<Vec<StoredColumn>, Stop> {
    let fail = |why: &dyn std::fmt::Display| Stop::Failed(anyhow::anyhow!("cannot read {}: {why}", file.display()));
    let input: Box<dyn io::Read> = match file == Path::new("-") {
        true => Box::new(io::stdin().lock()),
        false => Box::new(File::open(file).map_err(|why| fail(&why))?),
    };
    let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).trim(csv::Trim::All).from_reader(input);
    let mut columns: Vec<StoredColumn> = reader.headers().map_err(|why| fail(&why))?.iter().map(column).collect();
    if let Some(name) = given_twice(&columns) {
        return Err(fail(&format!("the heading has `{name}` twice")));
    }
    for record in reader.records() {
        let record = record.map_err(|why| fail(&why))?;
        for (column, cell) in columns.iter_mut().zip(&record) {
            let line = record.position().map_or(0, csv::Position::line);
            let value = cell.parse().map_err(|_| fail(&format!("line {line}: `{cell}` is not a number")))?;
            column.values.push(value);
        }
    }
    Ok(columns)
}

/// A name that two columns have: which is meant is not known.
fn given_twice(columns: &[StoredColumn]) -> Option<&str> {
    let mut names: Vec<&str> =
        columns.iter().map(|column| column.name.as_str()).filter(|name| !name.is_empty()).collect();
    names.sort_unstable();
    names.windows(2).find(|pair| pair[0] == pair[1]).map(|pair| pair[0])
}

/// A column from its header, `name [unit]`.
fn column(header: &str) -> StoredColumn {
    let (name, unit) = header.split_once('[').unwrap_or((header, "1]"));
    let (name, unit) = (name.trim().to_owned(), unit.trim_end_matches(']').trim().to_owned());
    StoredColumn { name, unit, has_unit: header.contains('['), values: Vec::new() }
}

/// A directory and the name of a figure in it, from a path without extension.
pub(crate) fn place(path: &Path) -> (PathBuf, String) {
    let name = path.file_name().map_or("plot".into(), |name| name.to_string_lossy().into_owned());
    (path.parent().unwrap_or(Path::new("")).to_owned(), name)
}

/// A directory that cannot be made is reported as for files.
pub(crate) fn make(directory: &Path) -> Result<(), WriteError> {
    match directory.as_os_str().is_empty() {
        true => Ok(()),
        false => std::fs::create_dir_all(directory).map_err(|why| WriteError::new(directory, why)),
    }
}
