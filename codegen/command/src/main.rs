//! `codegen [FILE]`: what becomes of the mechanisms that a file declares.

mod command;
mod difference;
mod document;
mod graph;
mod header;
mod source;
mod statistics;

use clap::Parser;
use command::{Arguments, Outcome};
use std::io::Write;
use std::process::ExitCode;

fn main() -> ExitCode {
    match command::run(&Arguments::parse()) {
        Ok(Outcome::Done) => ExitCode::SUCCESS,
        Ok(Outcome::Differs) => ExitCode::from(1),
        Err(error) => {
            // Where nobody can hear it, the exit status tells.
            let _ = writeln!(std::io::stderr(), "{error:#}");
            ExitCode::from(2)
        }
    }
}
