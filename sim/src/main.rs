//! The shipped binary: the command line over the shipped mechanisms.

use sim::cli::{Entry, model_entry};
use std::process::ExitCode;

fn main() -> ExitCode {
    let shipped: Vec<Entry> = models::erased().map(|(name, model)| model_entry(name, model)).collect();
    sim::cli::main(&shipped)
}
