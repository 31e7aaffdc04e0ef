//! Runs of mechanisms by the loops that serve any model: those are compiled once, with the library, and not for each mechanism
//! of a test. Loops compiled for a mechanism give the same bits (`--test results`).

use sim::{Compiled, Erased, Failure, Method, OnHeap, Run, Settings, declared_start, erase};

/// A mechanism without its type.
pub type AnyModel = Erased<OnHeap>;

/// A mechanism without its type.
pub fn any<M: Compiled>(mechanism: M) -> AnyModel {
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
    let mechanism = any(mechanism);
    let start = declared_start(&mechanism);
    sim::run(mechanism, &start, settings)
}
