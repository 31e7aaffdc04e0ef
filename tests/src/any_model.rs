//! Runs of mechanisms by the loops that serve any model: those are compiled once, with the library, and not for each mechanism
//! of a test. Loops compiled for a mechanism give the same bits (`--test results`), and so do interpreted kernels
//! (`--test interpreted`).

use sim::{Compiled, DeclarationFile, Erased, Failure, Method, OnHeap, Run, Settings, erase};
use std::path::Path;

/// A mechanism without its type.
pub type AnyModel = Erased<OnHeap>;

/// The mechanism of a declaration, interpreted.
///
/// # Errors
/// Its mistakes.
pub fn interpreted(declaration: &str) -> Result<AnyModel, String> {
    let file = DeclarationFile::of(Path::new("declaration.mech"), declaration.to_owned());
    file.model(None).map(Erased::of).map_err(|mistakes| mistakes.to_string())
}

/// As [`crate::run`].
///
/// # Errors
/// If it cannot be assembled.
pub fn run<M: Compiled>(mechanism: M, end: f64, steps: usize) -> Result<Run<AnyModel>, Failure> {
    run_with(mechanism, &Settings::equal_steps(Method::Rk4, end, steps))
}

/// As [`crate::run_with`].
///
/// # Errors
/// If it cannot be assembled.
pub fn run_with<M: Compiled>(mechanism: M, settings: &Settings) -> Result<Run<AnyModel>, Failure> {
    crate::run_with(Erased::of(erase(mechanism)), settings)
}
