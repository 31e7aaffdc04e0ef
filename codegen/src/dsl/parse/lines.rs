//! Lines that end with `;`. A mistake in one does not hide the next.

use crate::dsl::region::here;
use crate::mistakes::Mistakes;
use proc_macro2::TokenTree;
use syn::Token;
use syn::parse::{ParseStream, Result};

/// The lines of a block. All of their mistakes come together.
pub(super) fn lines<T>(content: ParseStream, parse: impl Fn(ParseStream) -> Result<T>) -> Result<Vec<T>> {
    let mut parsed = Vec::new();
    let mut mistakes = Mistakes::default();
    while !content.is_empty() {
        match parse(content) {
            Ok(item) => parsed.push(item),
            Err(mistake) => {
                mistakes.add(mistake);
                skip_line(content)?;
            }
        }
    }
    mistakes.or(parsed)
}

/// An item and the `;` after it.
pub(super) fn ended<T>(parse: impl Fn(ParseStream) -> Result<T>) -> impl Fn(ParseStream) -> Result<T> {
    move |input| {
        let item = parse(input)?;
        match input.parse::<Option<Token![;]>>()? {
            Some(_) => Ok(item),
            None => Err(here(input, "expected `;` at the end of this line")),
        }
    }
}

/// Drops tokens up to and including the next `;` or block.
pub(super) fn skip_line(input: ParseStream) -> Result<()> {
    while !input.is_empty() {
        match input.parse::<TokenTree>()? {
            TokenTree::Punct(punct) if punct.as_char() == ';' => break,
            TokenTree::Group(group) if group.delimiter() == proc_macro2::Delimiter::Brace => break,
            _ => {}
        }
    }
    Ok(())
}
