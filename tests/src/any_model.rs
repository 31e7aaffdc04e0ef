//! Runs of mechanisms by the loops that serve any model: those are compiled once, with the library, and not for each mechanism
//! of a test. Loops compiled for a mechanism give the same bits (`--test results`), and so do interpreted kernels
//! (`--test interpreted`).

use sim::{
    Array, Compiled, DeclarationFile, Erased, Failure, Method, OnHeap, Run, Settings, Start, declared_start, erase,
};
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

/// A compiled mechanism without its type.
fn of<M: Compiled>(mechanism: M) -> AnyModel {
    Erased::of(erase(mechanism))
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
    crate::run_with(of(mechanism), settings)
}

/// As [`sim::run`].
///
/// # Errors
/// If it cannot be assembled.
pub fn run_from<M: Compiled>(mechanism: M, start: &Start<M>, settings: &Settings) -> Result<Run<AnyModel>, Failure> {
    let (model, start) = without_type(mechanism, start);
    sim::run(model, &start, settings)
}

/// A mechanism and its start without its type.
pub fn without_type<M: Compiled>(mechanism: M, start: &Start<M>) -> (AnyModel, Start<AnyModel>) {
    let model = of(mechanism);
    let Start { position_given, speed_given, .. } = start.clone();
    let shaped = declared_start(&model);
    let positions = shaped.positions.like(|i| start.positions[i]);
    let speeds = shaped.speeds.like(|i| start.speeds[i]);
    (model, Start { positions, speeds, position_given, speed_given })
}
