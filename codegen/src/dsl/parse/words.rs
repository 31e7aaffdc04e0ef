//! The words and signs of lines.

use crate::dsl::Region;
use crate::dsl::region::here;
use crate::dsl::vocabulary::Word;
use syn::ext::IdentExt;
use syn::parse::{ParseStream, Result};
use syn::{Attribute, Ident, Token};

/// Reads the documentation in front of an item.
pub(super) fn docs(input: ParseStream) -> Result<String> {
    let mut lines = Vec::new();
    for attribute in input.call(Attribute::parse_outer)? {
        let text = match &attribute.meta {
            syn::Meta::NameValue(pair) if pair.path.is_ident("doc") => match &pair.value {
                syn::Expr::Lit(syn::ExprLit { lit: syn::Lit::Str(text), .. }) => Some(text.value()),
                _ => None,
            },
            _ => None,
        };
        match text {
            Some(text) => lines.push(text.trim().to_owned()),
            None => {
                let place = Region::from(attribute.pound_token.span);
                return Err(place.error("only documentation (`/// ..`) may stand here"));
            }
        }
    }
    Ok(lines.join("\n"))
}

/// A name that the user gives.
pub(super) fn name(input: ParseStream, what: &str) -> Result<Ident> {
    let name = Ident::parse_any(input).map_err(|e| syn::Error::new(e.span(), format!("expected {what}")))?;
    if ["self", "Self", "super", "crate", "_"].iter().any(|word| name.unraw() == word) {
        return Err(syn::Error::new(name.span(), format!("`{name}` cannot be a name in Rust; choose another")));
    }
    Ok(name)
}

pub(super) fn equals(input: ParseStream, advice: &str) -> Result<()> {
    if input.parse::<Option<Token![=]>>()?.is_none() {
        return Err(here(input, advice));
    }
    Ok(())
}

pub(super) fn colon(input: ParseStream, advice: &str) -> Result<()> {
    if input.parse::<Option<Token![:]>>()?.is_none() {
        return Err(here(input, advice));
    }
    Ok(())
}

/// The word that says what a line or a clause is, one of those of its place.
pub(super) fn keyword<W: Word>(input: ParseStream) -> Result<(Ident, W)> {
    let word =
        Ident::parse_any(input).map_err(|e| syn::Error::new(e.span(), format!("expected one of {}", list::<W>())))?;
    match W::of(&word.to_string()) {
        Some(known) => Ok((word, known)),
        None => {
            let message = format!("`{word}` is not known here; expected one of {}", list::<W>());
            Err(syn::Error::new(word.span(), message))
        }
    }
}

/// The words of a place, to be told.
pub(super) fn list<W: Word>() -> String {
    W::texts().into_iter().map(|text| format!("`{text}`")).collect::<Vec<_>>().join(", ")
}

pub(super) fn accept_word(input: ParseStream, word: &str) -> Result<bool> {
    let ahead = input.peek(Ident::peek_any) && input.fork().call(Ident::parse_any)? == word;
    if ahead {
        input.call(Ident::parse_any)?;
    }
    Ok(ahead)
}

pub(super) fn expect_word(input: ParseStream, word: &str, form: &str) -> Result<()> {
    if accept_word(input, word)? { Ok(()) } else { Err(here(input, format!("expected `{word}`: `{form}`"))) }
}
