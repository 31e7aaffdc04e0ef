//! The declaration's text, recovered from its tokens, so that a built mechanism can be derived again.

use super::hash::{documentation, hash};
use proc_macro2::{Delimiter, LineColumn, TokenStream, TokenTree};

/// What a built mechanism carries of its declaration.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Source {
    /// Its text, as [`source_text`] gives it.
    pub text: String,
    /// Its hash, as [`hash`] gives it.
    pub hash: String,
}

impl Source {
    /// Of a declaration's tokens, its files read in.
    pub fn of(tokens: TokenStream) -> Source {
        Source { hash: hash(tokens.clone()), text: source_text(tokens) }
    }
}

/// The tokens as text, on the lines and columns where they stood; comments other than documentation are gone. Tokens
/// without a place in a file are separated by one space.
pub fn source_text(tokens: TokenStream) -> String {
    let margin = leaves(tokens.clone()).iter().map(|leaf| leaf.start.column).min().unwrap_or(0);
    let mut writer = Writer { text: String::new(), at: None, margin };
    for leaf in leaves(tokens) {
        writer.put(&leaf);
    }
    writer.text.push('\n');
    writer.text
}

/// A word with its place.
struct Leaf {
    text: String,
    start: LineColumn,
    end: LineColumn,
    /// Documentation ends its line.
    ends_line: bool,
}

fn leaves(tokens: TokenStream) -> Vec<Leaf> {
    let mut out = Vec::new();
    let mut tokens = tokens.into_iter().peekable();
    while let Some(token) = tokens.next() {
        if let TokenTree::Punct(pound) = &token
            && pound.as_char() == '#'
            && let Some(TokenTree::Group(group)) = tokens.peek()
            && let Some(text) = documentation(group).filter(|text| !text.contains('\n'))
        {
            let span = pound.span();
            out.push(Leaf { text: format!("///{text}"), start: span.start(), end: span.end(), ends_line: true });
            tokens.next();
            continue;
        }
        match token {
            TokenTree::Group(group) => {
                let (open, close) = match group.delimiter() {
                    Delimiter::Parenthesis => ("(", ")"),
                    Delimiter::Brace => ("{", "}"),
                    Delimiter::Bracket => ("[", "]"),
                    Delimiter::None => ("", ""),
                };
                out.push(leaf(open, group.span_open()));
                out.extend(leaves(group.stream()));
                out.push(leaf(close, group.span_close()));
            }
            other => out.push(leaf(&other.to_string(), other.span())),
        }
    }
    out
}

fn leaf(text: &str, span: proc_macro2::Span) -> Leaf {
    Leaf { text: text.to_owned(), start: span.start(), end: span.end(), ends_line: false }
}

struct Writer {
    text: String,
    /// Where the last word ended, and whether its line is closed.
    at: Option<(LineColumn, bool)>,
    margin: usize,
}

impl Writer {
    fn put(&mut self, leaf: &Leaf) {
        if let Some((at, closed)) = self.at {
            // Several empty lines become one.
            let lines = leaf.start.line.saturating_sub(at.line).min(2).max(closed.into());
            let spaces = match lines {
                0 if at.line > 0 && leaf.start.line == at.line => leaf.start.column.checked_sub(at.column).unwrap_or(1),
                0 => 1,
                _ => leaf.start.column - self.margin,
            };
            self.text += &"\n".repeat(lines);
            self.text += &" ".repeat(spaces);
        }
        self.text += &leaf.text;
        self.at = Some((leaf.end, leaf.ends_line));
    }
}
