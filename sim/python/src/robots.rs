//! Robots from URDF.

use crate::errors::{argument, load};
use pyo3::prelude::*;
use sim_runtime::import::urdf::{Base, Mimic, Options};
use sim_runtime::{DeclarationFile, LoadError};
use std::path::{Path, PathBuf};

/// The declaration of a robot's file, and what the file lacks or contradicts.
#[pyfunction]
#[expect(clippy::too_many_arguments, reason = "as many as there are options")]
pub(crate) fn import_robot(
    py: Python<'_>,
    path: PathBuf,
    base: &str,
    mimic: &str,
    damping: bool,
    stops: bool,
    straighten: Option<f64>,
    packages: Vec<(String, PathBuf)>,
) -> PyResult<(String, Vec<String>)> {
    let unknown =
        |what: &str, word: &str, known: &str| argument(py, &format!("no {what} is called `{word}`; known are {known}"));
    let base = match base {
        "fixed" => Base::Fixed,
        "free" => Base::Free,
        _ => return Err(unknown("base", base, "fixed and free")),
    };
    let mimic = match mimic {
        "substitute" => Mimic::Substitute,
        "couple" => Mimic::Couple,
        "free" => Mimic::Free,
        _ => return Err(unknown("way to mimic", mimic, "substitute, couple and free")),
    };
    let straighten = straighten.unwrap_or(Options::STRAIGHT);
    if !(0.0..=0.1).contains(&straighten) {
        return Err(argument(py, "`straighten` is an angle from 0 to 0.1, in radians"));
    }
    let options = Options { base, mimic, damping, stops, straighten, packages };
    let found = py.detach(|| {
        let file = DeclarationFile::read(&path)?.with_robots(options);
        Ok((file.robot()?.text.clone(), file.warnings()))
    });
    found.map_err(|why: LoadError| load(py, &why))
}

/// Where a declaration's text is from: what was imported from a robot's file is none.
pub(crate) fn declared_in(path: PathBuf, text: &str) -> PathBuf {
    let is_robot = path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("urdf"));
    let is_declaration = !text.trim_start().starts_with('<');
    if is_robot && is_declaration { Path::new(&path).with_extension("mech") } else { path }
}
