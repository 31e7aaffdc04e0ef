//! What is counted of a declaration.

use super::Table;
use std::time::Instant;

/// The first mechanism of a text, and a line on how long its derivation takes.
pub(super) fn derived(table: &mut Table, name: &str, text: &str) -> Option<codegen::Derived> {
    let clock = Instant::now();
    let declarations = codegen::dsl::declarations(text);
    match declarations.map(|found| found.into_iter().next()).and_then(|first| first.map(codegen::derive).transpose()) {
        Ok(derived) => {
            println!("{name}: derived in {:.2} s", clock.elapsed().as_secs_f64());
            derived
        }
        Err(mistakes) => {
            table.line(name, mistakes, "derived", false);
            None
        }
    }
}

/// All operations of a kernel but sines and cosines.
pub(super) fn operations(derived: &codegen::Derived, kernel: &str) -> Option<usize> {
    let kernel = derived.program.kernels.iter().find(|found| found.id.name() == kernel)?;
    Some(kernel.operations.total() - kernel.operations.sine_cosines)
}
