//! Errors of figures.

use crate::WriteError;
use std::fmt::Display;
use std::path::{Path, PathBuf};

/// Why a figure was not made.
#[derive(Debug, thiserror::Error)]
pub enum ShowError {
    /// There is nothing to show.
    #[error("figure `{figure}` has nothing to show: {why}")]
    Empty {
        /// The figure's name.
        figure: String,
        /// What is missing.
        why: &'static str,
    },
    /// A curve does not fit its abscissae.
    #[error("figure `{figure}`: curve `{curve}` has {values} values for {abscissae} abscissae")]
    Curve {
        /// The figure's name.
        figure: String,
        /// The curve's label.
        curve: String,
        /// The number of its values.
        values: usize,
        /// The number of abscissae of the plot.
        abscissae: usize,
    },
    /// A pose does not fit the shapes.
    #[error("figure `{figure}`: the pose at {at} has {numbers} numbers, its shapes take {needed}")]
    Pose {
        /// The figure's name.
        figure: String,
        /// The pose's time, or the value of what is driven.
        at: f64,
        /// The number of its numbers.
        numbers: usize,
        /// The number that the shapes need.
        needed: usize,
    },
    /// The font cannot be used.
    #[error("the font of figures cannot be used: {0}")]
    Font(String),
    /// The picture cannot be drawn.
    #[error("cannot draw the figure: {0}")]
    Draw(String),
    /// A file or directory cannot be written.
    #[error("cannot write {}: {why}", path.display())]
    Write {
        /// The file or directory.
        path: PathBuf,
        /// Why not.
        why: String,
    },
}

impl From<WriteError> for ShowError {
    fn from(WriteError { path, reason }: WriteError) -> Self {
        ShowError::Write { path, why: reason }
    }
}

impl ShowError {
    /// The error if a file or directory cannot be written.
    pub(super) fn write(path: &Path, why: impl Display) -> Self {
        ShowError::Write { path: path.to_owned(), why: why.to_string() }
    }

    /// The error if there is nothing to show.
    pub(super) fn empty(figure: &str, why: &'static str) -> Self {
        ShowError::Empty { figure: figure.to_owned(), why }
    }
}
