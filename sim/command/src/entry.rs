//! The mechanisms that a program runs by their names.

use crate::arguments::{RunArguments, Voice};
use crate::commands::run::run_command;
use crate::{Stop, not_among};
use sim_kernel::{Compiled, Description};
use sim_runtime::{DeclarationFile, LoadError, Model, erase};
use std::path::Path;
use std::sync::Arc;

/// The command `run` of one mechanism.
pub(super) type RunCommand = fn(&RunArguments, Voice) -> Result<(), Stop>;

/// A mechanism that the command line can run.
#[derive(Clone, Copy)]
pub struct Entry {
    name: &'static str,
    source: Source,
    /// Its runs by step loops of its own, if it has them.
    pub(super) run: Option<RunCommand>,
}

/// Where the mechanism comes from.
#[derive(Clone, Copy)]
enum Source {
    Compiled(fn() -> Arc<dyn Model>),
    Text(&'static str),
}

/// Registers a mechanism with [`main`](super::main). Commands are compiled once for all mechanisms: of this one only its
/// kernels are.
pub fn entry<M: Compiled>() -> Entry {
    let description: &Description = const { &M::DESCRIPTION };
    model_entry(description.name, || erase(M::defaults()))
}

/// The same with step loops compiled for this mechanism: `run` integrates several times as fast, to the same bits, and
/// a build takes some seconds more. For long runs.
pub fn entry_with_own_loops<M: Compiled>() -> Entry {
    let run = |arguments: &RunArguments, voice: Voice| run_command(M::defaults(), arguments, voice);
    Entry { run: Some(run), ..entry::<M>() }
}

/// Registers a mechanism that is a model already.
pub const fn model_entry(name: &'static str, model: fn() -> Arc<dyn Model>) -> Entry {
    Entry { name, source: Source::Compiled(model), run: None }
}

/// Registers a declaration by its text, that of a `.mech` or `.rs` file with this mechanism alone. It is read when the
/// mechanism is needed.
pub const fn text_entry(name: &'static str, text: &'static str) -> Entry {
    Entry { name, source: Source::Text(text), run: None }
}

impl Entry {
    /// The name on the command line: `four-bar`.
    pub fn name(&self) -> &'static str {
        self.name
    }

    /// The mechanism.
    ///
    /// # Errors
    /// If it is a text with mistakes.
    pub fn model(&self) -> Result<Arc<dyn Model>, LoadError> {
        match self.source {
            Source::Compiled(model) => Ok(model()),
            Source::Text(text) => DeclarationFile::of(Path::new(self.name), text.to_owned()).model(None),
        }
    }
}

/// The mechanism of this name.
pub(super) fn find<'a>(mechanisms: &'a [Entry], name: &str) -> Result<&'a Entry, Stop> {
    let names = || mechanisms.iter().map(Entry::name).collect::<Vec<_>>();
    mechanisms.iter().find(|entry| entry.name == name).ok_or_else(|| not_among("model", name, &names()))
}
