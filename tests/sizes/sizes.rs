//! A program whose mechanisms have different sizes, with the command line.

#![allow(missing_docs)]

#[path = "declared.rs"]
mod declared;

use declared::{Chain, Row};
use sim::cli::{entry, entry_with_own_loops};
use std::process::ExitCode;

fn main() -> ExitCode {
    sim::cli::main(&[entry::<Chain>(), entry::<Row>(), entry_with_own_loops::<models::QuickReturn>()])
}
