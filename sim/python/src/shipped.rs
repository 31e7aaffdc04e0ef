//! The shipped mechanisms, and the command `sim` over them.

use pyo3::prelude::*;
use sim_command::{Entry, text_entry};
use std::ffi::OsString;

/// By name and text.
static SHIPPED: &[Entry] = include!(concat!(env!("OUT_DIR"), "/shipped.rs"));

/// The names of the shipped mechanisms.
#[pyfunction]
pub(crate) fn shipped() -> Vec<&'static str> {
    SHIPPED.iter().map(Entry::name).collect()
}

/// A shipped mechanism.
pub(crate) fn entry(name: &str) -> Option<&'static Entry> {
    SHIPPED.iter().find(|entry| entry.name() == name)
}

/// Executes the command line `sim`, whose words begin with the name of the program. Gives the exit status.
#[pyfunction]
pub(crate) fn main(py: Python<'_>, words: Vec<OsString>) -> u8 {
    py.detach(|| sim_command::main_of(SHIPPED, words))
}
