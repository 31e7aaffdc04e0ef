//! Programs as Rust tokens.

mod concrete;
mod description;
mod documentation;
mod equations;
mod format;
mod forward;
mod function;
mod implementation;
mod kernel;
mod marker;
mod names;
mod record;
mod speeds;
mod stub;
mod table_constant;
mod tree;
mod types;

pub use format::format;
pub use stub::stub;

use crate::description::Description;
use crate::dsl::Head;
use crate::dynamics::EquationsOfMotion;
use crate::program::Program;
use concrete::Concrete;
use proc_macro2::{Ident, Literal, Span, TokenStream};

/// All Rust items of a mechanism: its type with its parameters, named coordinates and outputs, its kernels, and the
/// impl of the runtime's trait. `path` is where `sim_kernel` is found.
pub fn emit(
    head: &Head,
    description: &Description,
    equations: &EquationsOfMotion,
    program: &Program,
    path: &TokenStream,
) -> TokenStream {
    let types = types::types(head, equations, program, path);
    let concrete = Concrete::of(equations, program, path);
    let kernels = kernel::kernels(equations, program, &concrete, path);
    let mechanism = implementation::implementation(equations, program, description, &concrete, path);
    let speeds = speeds::speeds(head, equations, program, &concrete, path);
    [types, kernels, mechanism].into_iter().chain(speeds).collect()
}

/// A name of the user's, raw if it is a keyword.
fn ident(name: &str) -> Ident {
    // Few names consist of lower-case letters alone, as all keywords do.
    if name.bytes().all(|letter| letter.is_ascii_lowercase()) && KEYWORDS.contains(&name) {
        return Ident::new_raw(name, Span::call_site());
    }
    // A raw name of the user's; names of the program's making are never written so.
    match name.strip_prefix("r#") {
        Some(raw) => Ident::new_raw(raw, Span::call_site()),
        None => Ident::new(name, Span::call_site()),
    }
}

/// Words that must be raw as names (The Rust Reference, edition 2024, chapter Keywords).
const KEYWORDS: [&str; 48] = [
    "abstract", "as", "async", "await", "become", "box", "break", "const", "continue", "do", "dyn", "else", "enum",
    "extern", "false", "final", "fn", "for", "gen", "if", "impl", "in", "let", "loop", "macro", "match", "mod", "move",
    "mut", "override", "priv", "pub", "ref", "return", "static", "struct", "trait", "true", "try", "type", "typeof",
    "unsafe", "unsized", "use", "virtual", "where", "while", "yield",
];

/// A size, without a suffix.
fn size(value: usize) -> Literal {
    Literal::usize_unsuffixed(value)
}
