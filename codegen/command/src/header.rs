//! What a print says of where it comes from.

use crate::source::Source;
use codegen::dsl;

/// How a comment begins and ends.
#[derive(Clone, Copy)]
pub(crate) enum Comment {
    /// Rust, Graphviz.
    Slashes,
    /// LaTeX.
    Percent,
    /// Pages.
    Angles,
    /// Text that has no comments.
    None,
}

/// The first words, by which a header is known.
const MADE: &str = "Made by Linkwright ";

/// The program with its commit, each declaration by its hash, and the options; then an empty line.
pub(crate) fn header(source: &Source, options: &str, comment: Comment) -> syn::Result<String> {
    let mut lines = vec![format!("{MADE}{}, commit {}.", env!("CARGO_PKG_VERSION"), env!("LINKWRIGHT_COMMIT"))];
    for declaration in source.declarations()? {
        let hash = dsl::hash(declaration.clone());
        lines.push(format!("Declaration of {}: {hash}.", dsl::parse_head(declaration)?.name));
    }
    lines.push(format!("Options: {options}."));
    let (before, after) = match comment {
        Comment::Slashes => ("// ", ""),
        Comment::Percent => ("% ", ""),
        Comment::Angles => ("<!-- ", " -->"),
        Comment::None => ("", ""),
    };
    Ok(lines.iter().map(|line| format!("{before}{line}{after}\n")).collect::<String>() + "\n")
}

/// The header of a print, if it has one. Prints are compared without it: those of the same declaration by another commit are
/// the same where nothing else differs.
pub(crate) fn header_of(print: &str) -> &str {
    let is_header = print.lines().next().is_some_and(|line| line.contains(MADE));
    let end = print.find("\n\n").filter(|_| is_header);
    end.map_or("", |end| &print[..end + 2])
}
