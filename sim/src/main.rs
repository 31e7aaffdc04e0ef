//! The shipped binary: the command line over the shipped mechanisms.

use sim::cli::entry;
use std::process::ExitCode;

macro_rules! entries {
    ($($model:ty),*) => { [$(entry::<$model>()),*] };
}

fn main() -> ExitCode {
    sim::cli::main(&models::all_models!(entries))
}
