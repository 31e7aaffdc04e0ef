//! The results of a command.

use crate::errors::{problem, refusal};
use numpy::{IntoPyArray, PyArray1};
use pyo3::prelude::*;
use sim_runtime::Column;
use std::sync::{Mutex, PoisonError};

/// A column: its name, unit and numbers.
type Named<'py> = (String, String, Bound<'py, PyArray1<f64>>);

/// The results of a command. The package makes its own classes of them.
#[pyclass(frozen, module = "linkwright._linkwright")]
pub(crate) struct Answer {
    found: sim_command::Answer,
    /// Until Python has taken them.
    columns: Mutex<Vec<Column>>,
}

impl Answer {
    pub(crate) fn new(mut found: sim_command::Answer) -> Answer {
        let columns = Mutex::new(found.table.take().map_or_else(Vec::new, |table| table.columns));
        Answer { found, columns }
    }
}

#[pymethods]
impl Answer {
    /// The results as JSON.
    #[getter]
    fn summary(&self) -> String {
        self.found.summary.to_string()
    }

    /// The columns of the motion, once: their numbers are moved into arrays.
    fn columns<'py>(&self, py: Python<'py>) -> Vec<Named<'py>> {
        let columns = std::mem::take(&mut *self.columns.lock().unwrap_or_else(PoisonError::into_inner));
        let moved = |column: Column| (column.name, column.unit.into_owned(), column.values.into_pyarray(py));
        columns.into_iter().map(moved).collect()
    }

    /// The exception that says what is wrong with the results, or None.
    #[getter]
    fn problem(&self, py: Python<'_>) -> Option<Py<PyAny>> {
        let found = self.found.problem.as_ref()?;
        Some(problem(py, found).into_value(py).into_any())
    }

    /// The report as a page, or None of a command that has none.
    fn report(&self, py: Python<'_>) -> PyResult<Option<String>> {
        let drawn = py.detach(|| self.found.report().transpose());
        drawn.map_err(|why| refusal(py, &why))
    }
}
