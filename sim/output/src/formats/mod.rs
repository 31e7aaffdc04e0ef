//! Tables as files, in formats that other programs read.

mod lines;
mod numpy;
#[cfg(feature = "parquet")]
mod parquet;

use crate::write::{WriteError, write_csv};
use sim_runtime::Table;
use std::path::{Path, PathBuf};

pub use numpy::write_matrices;

/// A format of tables.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// Comma-separated, header cells `name [unit]`, numbers that read back as the same `f64`.
    Csv,
    /// JSON lines: an object for each row, by name; `null` for numbers that are not finite.
    JsonLines,
    /// NumPy: one array with a field for each column.
    Npy,
    /// NumPy: an archive with an array for each column.
    Npz,
    /// Apache Parquet, with the units in the file's metadata.
    #[cfg(feature = "parquet")]
    Parquet,
}

impl Format {
    /// All formats.
    pub const ALL: &[Format] = &[
        Format::Csv,
        Format::JsonLines,
        Format::Npy,
        Format::Npz,
        #[cfg(feature = "parquet")]
        Format::Parquet,
    ];

    /// Its name on the command line, and the extension of its files.
    pub const fn name(self) -> &'static str {
        match self {
            Format::Csv => "csv",
            Format::JsonLines => "jsonl",
            Format::Npy => "npy",
            Format::Npz => "npz",
            #[cfg(feature = "parquet")]
            Format::Parquet => "parquet",
        }
    }
}

/// Writes a table to `trajectory.EXTENSION` in a directory, and gives the path.
///
/// # Errors
/// If the file cannot be written.
pub fn write_table(table: &Table, format: Format, directory: &Path) -> Result<PathBuf, WriteError> {
    let path = directory.join(format!("trajectory.{}", format.name()));
    match format {
        Format::Csv => write_csv(table, &path)?,
        Format::JsonLines => lines::write(table, &path)?,
        Format::Npy => numpy::write_npy(table, &path)?,
        Format::Npz => numpy::write_npz(table, &path)?,
        #[cfg(feature = "parquet")]
        Format::Parquet => parquet::write(table, &path)?,
    }
    Ok(path)
}
