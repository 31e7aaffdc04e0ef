//! How long functions and files are.

use super::source::Source;
use proc_macro2::{Delimiter, TokenTree};

/// Something that is long.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Long {
    /// The file, and the function in it.
    pub what: String,
    /// Its lines.
    pub lines: usize,
}

/// The files of a crate with more lines than these.
pub fn long_files(source: &Source, most: usize) -> Vec<Long> {
    let long = source.modules.values().filter(|module| module.lines > most);
    long.map(|module| Long { what: module.file.display().to_string(), lines: module.lines }).collect()
}

/// The functions of a crate, each with its lines, that have more than these.
pub fn long_functions(source: &Source, most: usize) -> Vec<Long> {
    let mut found = Vec::new();
    for module in source.modules.values() {
        let mut functions = Vec::new();
        collect(&module.tokens, &mut functions);
        let long = functions.into_iter().filter(|(_, lines)| *lines > most);
        found.extend(long.map(|(name, lines)| Long { what: format!("{}: {name}", module.file.display()), lines }));
    }
    found
}

/// Each `fn name(..) { .. }` with its lines.
fn collect(tokens: &[TokenTree], functions: &mut Vec<(String, usize)>) {
    for (i, token) in tokens.iter().enumerate() {
        if let TokenTree::Group(group) = token {
            collect(&group.stream().into_iter().collect::<Vec<_>>(), functions);
        }
        let (TokenTree::Ident(word), Some(TokenTree::Ident(name))) = (token, tokens.get(i + 1)) else { continue };
        if word != "fn" {
            continue;
        }
        let is_end = |token: &&TokenTree| matches!(token, TokenTree::Punct(mark) if mark.as_char() == ';');
        let is_body =
            |token: &&TokenTree| matches!(token, TokenTree::Group(body) if body.delimiter() == Delimiter::Brace);
        if let Some(body) = tokens[i..].iter().find(|token| is_end(token) || is_body(token)).filter(is_body) {
            functions.push((name.to_string(), body.span().end().line - word.span().start().line + 1));
        }
    }
}
