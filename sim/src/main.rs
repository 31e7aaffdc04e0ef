//! The shipped binary: the command line over the shipped mechanisms.

use sim::cli::entry;
use std::process::ExitCode;

fn main() -> ExitCode {
    sim::cli::main(&[entry::<models::QuickReturn>(), entry::<models::QuickReturnRatio>()])
}
