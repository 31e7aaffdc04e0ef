//! Words and their neighbours, which distinguish lines, units and components.

use proc_macro2::{Delimiter, Group, Ident, Literal, TokenStream, TokenTree};
use syn::ext::IdentExt;

pub(super) fn is_punct(token: Option<&TokenTree>, mark: char) -> bool {
    matches!(token, Some(TokenTree::Punct(punct)) if punct.as_char() == mark)
}

pub(super) fn is_word(token: Option<&TokenTree>, word: &str) -> bool {
    matches!(token, Some(TokenTree::Ident(ident)) if ident == word)
}

pub(super) fn ident(token: Option<&TokenTree>) -> Option<&Ident> {
    match token {
        Some(TokenTree::Ident(ident)) => Some(ident),
        _ => None,
    }
}

pub(super) fn group(token: Option<&TokenTree>, delimiter: Delimiter) -> Option<&Group> {
    match token {
        Some(TokenTree::Group(group)) if group.delimiter() == delimiter => Some(group),
        _ => None,
    }
}

/// The name as the user thinks of it, without Rust's `r#`.
pub(super) fn plain(ident: &Ident) -> String {
    ident.unraw().to_string()
}

pub(super) fn list(tokens: TokenStream) -> Vec<TokenTree> {
    tokens.into_iter().collect()
}

/// Whether the brackets at `at` are a unit: they follow a name or a number, and no comma stands in them.
pub(super) fn is_unit(tokens: &[TokenTree], at: usize) -> bool {
    let Some(group) = group(tokens.get(at), Delimiter::Bracket) else { return false };
    let follows = matches!(at.checked_sub(1).map(|at| &tokens[at]), Some(TokenTree::Ident(_) | TokenTree::Literal(_)));
    follows && !group.stream().into_iter().any(|token| is_punct(Some(&token), ','))
}

/// Whether the word at `at` is a component, as `x` in `P.x`.
pub(super) fn is_component(tokens: &[TokenTree], at: usize) -> bool {
    let before = |back: usize| at.checked_sub(back).map(|at| &tokens[at]);
    is_punct(before(1), '.') && !is_punct(before(2), '.')
}

/// The parts between commas.
pub(super) fn split(tokens: &[TokenTree]) -> Vec<&[TokenTree]> {
    if tokens.is_empty() {
        return vec![];
    }
    let mut parts: Vec<_> = tokens.split(|token| is_punct(Some(token), ',')).collect();
    // A comma may stand after the last.
    if parts.last().is_some_and(|part| part.is_empty()) {
        parts.pop();
    }
    parts
}

/// Whether words are plain numbers with operators: without a name, and without a unit.
pub(super) fn is_of_numbers(tokens: &[TokenTree]) -> bool {
    tokens.iter().all(|token| match token {
        TokenTree::Literal(literal) => text(literal).is_none(),
        TokenTree::Punct(mark) => ['+', '-', '*', '/', '^'].contains(&mark.as_char()),
        TokenTree::Group(group) => group.delimiter() == Delimiter::Parenthesis && is_of_numbers(&list(group.stream())),
        TokenTree::Ident(_) => false,
    })
}

/// The whole number that these words are.
pub(super) fn whole_number(tokens: &[TokenTree]) -> Option<i64> {
    match tokens {
        [TokenTree::Literal(literal)] => literal.to_string().replace('_', "").parse().ok(),
        _ => None,
    }
}

/// A text between quotes.
pub(super) fn text(literal: &Literal) -> Option<String> {
    match syn::Lit::new(literal.clone()) {
        syn::Lit::Str(text) => Some(text.value()),
        _ => None,
    }
}

/// Drops the documentation at the end, which preceded the item that is now written out.
pub(super) fn drop_documentation(out: &mut Vec<TokenTree>) {
    while let [.., TokenTree::Punct(pound), TokenTree::Group(group)] = &out[..]
        && pound.as_char() == '#'
        && group.delimiter() == Delimiter::Bracket
    {
        out.truncate(out.len() - 2);
    }
}
