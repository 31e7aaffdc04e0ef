//! How the source of this workspace is built: which module imports which, where imports go in rings, whether a stage imports a
//! later one, and how long functions and files are. It is read from the source, token by token.

mod imports;
mod lengths;
mod rings;
mod source;
mod stages;

pub use imports::{Imports, imports};
pub use lengths::{Long, long_files, long_functions};
pub use rings::rings;
pub use source::{Module, Source};
pub use stages::{CRATES, Crate, out_of_order};
