//! Errors as exceptions of the package, with code, message and place.

use codegen::mistakes::Related;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use sim_command::{Problem, Refusal};
use sim_runtime::{Failure, LoadError};

/// An exception of `linkwright.errors`.
fn exception(py: Python<'_>, class: &str, message: &str, details: &Bound<'_, PyDict>) -> PyErr {
    let made = py
        .import("linkwright.errors")
        .and_then(|errors| errors.getattr(class))
        .and_then(|class| class.call((message,), Some(details)));
    made.map_or_else(|error| error, PyErr::from_value)
}

/// Something is not asked for as it should be.
pub(crate) fn argument(py: Python<'_>, message: &str) -> PyErr {
    exception(py, "ArgumentError", message, &PyDict::new(py))
}

/// A motion or a computation fails at a state.
pub(crate) fn failure(py: Python<'_>, failure: &Failure) -> PyErr {
    details(py, failure)
        .map_or_else(|error| error, |details| exception(py, "MotionError", &failure.to_string(), &details))
}

fn details<'py>(py: Python<'py>, failure: &Failure) -> PyResult<Bound<'py, PyDict>> {
    let state = PyDict::new(py);
    failure.state.iter().try_for_each(|(name, value)| state.set_item(name, value))?;
    let details = PyDict::new(py);
    details.set_item("code", failure.what.code())?;
    details.set_item("time", failure.time)?;
    details.set_item("state", state)?;
    Ok(details)
}

/// A kernel gives no numbers at these states.
pub(crate) fn kernel(py: Python<'_>, code: &str, message: &str, states: &[usize]) -> PyErr {
    let details = PyDict::new(py);
    let set = details.set_item("code", code).and_then(|()| details.set_item("states", states));
    set.map_or_else(|error| error, |()| exception(py, "MotionError", message, &details))
}

/// A command finds nothing.
pub(crate) fn refusal(py: Python<'_>, refusal: &Refusal) -> PyErr {
    match refusal {
        Refusal::Usage(message) => argument(py, message),
        Refusal::Failure(found) => failure(py, found),
        Refusal::Other(message) => exception(py, "LinkwrightError", message, &PyDict::new(py)),
    }
}

/// What is wrong with results: an exception that says so.
pub(crate) fn problem(py: Python<'_>, problem: &Problem) -> PyErr {
    match &problem.failure {
        Some(found) => failure(py, found),
        None => exception(py, "ResultError", &problem.message, &PyDict::new(py)),
    }
}

/// A declaration cannot be read.
pub(crate) fn load(py: Python<'_>, error: &LoadError) -> PyErr {
    let raised = match error {
        LoadError::Mistakes { path, text, mistakes } => {
            let all: PyResult<Vec<_>> = mistakes
                .iter()
                .map(|mistake| {
                    let details = PyDict::new(py);
                    details.set_item("code", mistake.code)?;
                    details.set_item("message", &mistake.message)?;
                    details.set_item("line", mistake.start.line + 1)?;
                    details.set_item("column", mistake.start.column + 1)?;
                    details.set_item("end_line", mistake.end.line + 1)?;
                    details.set_item("end_column", mistake.end.column + 1)?;
                    details.set_item("suggestion", mistake.suggestion())?;
                    details.set_item("words", text.lines().nth(mistake.start.line))?;
                    let place = |of: &Related| (of.message.clone(), of.start.line + 1, of.start.column + 1);
                    details.set_item("related", mistake.related.iter().map(place).collect::<Vec<_>>())?;
                    Ok(details)
                })
                .collect();
            all.and_then(|all| {
                let details = PyDict::new(py);
                details.set_item("path", path.as_os_str())?;
                details.set_item("mistakes", all)?;
                Ok(exception(py, "DeclarationError", &error.to_string(), &details))
            })
        }
        LoadError::Read { .. } => Ok(exception(py, "ReadError", &error.to_string(), &PyDict::new(py))),
        LoadError::Choice { .. } => Ok(argument(py, &error.to_string())),
    };
    raised.unwrap_or_else(|error| error)
}
