//! The command: reads declarations, prints one view of them, or compares it with a file.

use crate::difference::difference;
use crate::document::{Notation, document};
use crate::graph::graph;
use crate::header::{Comment, header, header_of};
use crate::source::Source;
use crate::statistics::statistics;
use anyhow::{Context, Result};
use clap::Parser;
use proc_macro2::TokenStream;
use std::io::{ErrorKind, Write};
use std::path::PathBuf;

/// Derives the equations of motion of the mechanisms that a text declares, and prints the kernels made of them.
///
/// Exit status: 0, 1 if `--check` finds a difference, 2 if something is wrong.
#[derive(Parser)]
#[command(name = "codegen", version = concat!(env!("CARGO_PKG_VERSION"), " (commit ", env!("LINKWRIGHT_COMMIT"), ")"))]
pub(crate) struct Arguments {
    /// A Rust file with `mechanism! { .. }` in it, or a bare declaration; `-` or nothing for standard input
    file: Option<PathBuf>,
    /// Print the equations of motion, as text, as a LaTeX document or as a page with MathML
    #[arg(long, value_name = "NOTATION", group = "view")]
    equations: Option<Notation>,
    /// Print the operations of each kernel, what sharing saves, and the times of the stages
    #[arg(long, group = "view", conflicts_with = "check")]
    statistics: bool,
    /// Print the graph of a kernel's operations for Graphviz, as in `codegen FILE --graph dynamics | dot -Tsvg`
    #[arg(long, value_name = "KERNEL", group = "view")]
    graph: Option<String>,
    /// Compare with this file instead of printing, but for the lines on top that say what made it
    #[arg(long, value_name = "FILE")]
    check: Option<PathBuf>,
    /// Where the generated code finds the trait `Mechanism`
    #[arg(long, value_name = "PATH", default_value = "sim_kernel")]
    path: String,
}

/// The outcome of a command that could be carried out.
pub(crate) enum Outcome {
    Done,
    /// `--check` has found a difference.
    Differs,
}

/// Carries a command out.
pub(crate) fn run(arguments: &Arguments) -> Result<Outcome> {
    let source = Source::read(arguments.file.as_deref())?;
    let text = view(arguments, &source)?;
    match &arguments.check {
        None => print(&(top(arguments, &source)? + &text)).map(|()| Outcome::Done),
        Some(file) => {
            let expected = std::fs::read_to_string(file).with_context(|| format!("cannot read {}", file.display()))?;
            let found = header_of(&expected).to_owned() + &text;
            match difference(&file.display().to_string(), &expected, &found) {
                None => Ok(Outcome::Done),
                Some(difference) => print(&difference).map(|()| Outcome::Differs),
            }
        }
    }
}

/// What stands above a view that may be kept as a file: where it comes from.
fn top(arguments: &Arguments, source: &Source) -> Result<String> {
    let (options, comment) = match (arguments.equations, &arguments.graph) {
        _ if arguments.statistics => return Ok(String::new()),
        (Some(Notation::Infix), _) => ("equations infix".to_owned(), Comment::None),
        (Some(Notation::Latex), _) => ("equations latex".to_owned(), Comment::Percent),
        (Some(Notation::Mathml), _) => ("equations mathml".to_owned(), Comment::Angles),
        (None, Some(kernel)) => (format!("graph {kernel}"), Comment::Slashes),
        (None, None) => (format!("path {}", arguments.path), Comment::Slashes),
    };
    source.located(header(source, &options, comment))
}

/// The requested view, as text.
fn view(arguments: &Arguments, source: &Source) -> Result<String> {
    let of_each = |view: &dyn Fn(TokenStream) -> syn::Result<String>| source.located(source.each(view));
    if let Some(notation) = arguments.equations {
        return source.located(document(source, notation));
    }
    if arguments.statistics {
        return of_each(&|declaration| statistics(declaration));
    }
    if let Some(kernel) = &arguments.graph {
        return graph(source, kernel);
    }
    source.located(codegen::generate_text_in(&source.text, &arguments.path, &source.folder))
}

/// A reader that closes early, as `head` does, has what it wants.
fn print(text: &str) -> Result<()> {
    match std::io::stdout().write_all(text.as_bytes()) {
        Err(error) if error.kind() == ErrorKind::BrokenPipe => Ok(()),
        result => result.context("cannot write to standard output"),
    }
}
