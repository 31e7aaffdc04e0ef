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
        if let Err(mistake) = parse_head(tokens.clone()) {
            if names_something(tokens.clone()) {
                return Err(mistake);
            }
            let message = "no mechanism is declared here: there is no `mechanism! { .. }`, and the text is not a \
                           declaration, which starts with the mechanism's name: `pub QuickReturn;`";
            return Err(Error::new(tokens.into_iter().next().map_or_else(Span::call_site, |t| t.span()), message));
        }
        return Ok(vec![tokens]);
    }
    found.into_iter().map(version::without).collect()
}

/// Whether it starts as a declaration does, with a name and a semicolon.
fn names_something(tokens: TokenStream) -> bool {
    let is_documentation = |token: &TokenTree| match token {
        TokenTree::Punct(mark) => mark.as_char() == '#',
        other => matches!(other, TokenTree::Group(_)),
    };
    let is_pub = |token: &TokenTree| matches!(token, TokenTree::Ident(word) if word == "pub");
    let mut head = tokens.into_iter().skip_while(|token| is_documentation(token) || is_pub(token));
    let [name, mark] = [head.next(), head.next()];
    matches!(name, Some(TokenTree::Ident(_))) && matches!(mark, Some(TokenTree::Punct(mark)) if mark.as_char() == ';')
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
