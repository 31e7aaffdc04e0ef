//! Stage 1: text to parsed declaration, with the place of every word kept.

mod declarations;
mod file;
mod hash;
mod limits;
mod parse;
mod print;
mod rates;
mod region;
mod reuse;
mod source;
mod syntax;
mod tree;
pub mod version;
mod vocabulary;

pub use declarations::declarations;
pub use file::{files_named, folder_of_tables, read_files};
pub use hash::hash;
pub use parse::{parse_head, parse_unit};
pub use region::Region;
pub use reuse::attributed;
pub use source::{Source, source_text};
pub use syntax::*;
pub use tree::*;

use proc_macro2::TokenStream;

/// Reads a whole declaration, with its joints as written.
///
/// # Errors
/// All mistakes of form, each at the user's own word, combined into one error.
pub fn read(tokens: TokenStream) -> syn::Result<Declaration> {
    parse::declaration(reuse::expand(tokens)?)
}
