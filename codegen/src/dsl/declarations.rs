//! Declarations in a text: a Rust file, or one declaration by itself.

use super::{limits, parse_head, version};
use proc_macro2::{LexError, Span, TokenStream, TokenTree};
use syn::{Error, Result};

/// The tokens of each `mechanism! { .. }` in a Rust file, in order; or the whole text, if it is a bare declaration. What says
/// which version of the language it is written in is left out.
///
/// # Errors
/// If the text is not made of Rust's tokens, or of brackets nested too deeply, if it declares nothing, and if it is written in
/// a newer language.
pub fn declarations(text: &str) -> Result<Vec<TokenStream>> {
    let tokens: TokenStream = text.parse().map_err(|e: LexError| {
        let message = "from here on this is not made of words: a bracket, a quote or a comment is not closed, or a sign is none of \
                       the language";
        Error::new(e.span(), message)
    })?;
    limits::check_file(tokens.clone())?;
    let mut found = Vec::new();
    collect(tokens.clone(), &mut found);
    if found.is_empty() {
        let tokens = version::without(tokens)?;
        if parse_head(tokens.clone()).is_err() {
            let message = "no mechanism is declared here: there is no `mechanism! { .. }`, and the text is not a \
                           declaration, which starts with the mechanism's name: `pub QuickReturn;`";
            return Err(Error::new(tokens.into_iter().next().map_or_else(Span::call_site, |t| t.span()), message));
        }
        return Ok(vec![tokens]);
    }
    found.into_iter().map(version::without).collect()
}

/// Modules and functions are looked into as well.
fn collect(tokens: TokenStream, found: &mut Vec<TokenStream>) {
    let tokens: Vec<TokenTree> = tokens.into_iter().collect();
    for (at, token) in tokens.iter().enumerate() {
        let TokenTree::Group(group) = token else { continue };
        match at.checked_sub(2).map(|start| &tokens[start..at]) {
            Some([TokenTree::Ident(name), TokenTree::Punct(mark)]) if name == "mechanism" && mark.as_char() == '!' => {
                found.push(group.stream());
            }
            _ => collect(group.stream(), found),
        }
    }
}
