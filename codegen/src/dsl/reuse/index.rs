//! Whole numbers at build time: indices, constants and the bounds of repetitions.

use crate::dsl::region::here;
use crate::nearest;
use syn::ext::IdentExt;
use syn::parse::{ParseStream, Result};
use syn::{Ident, LitInt, Token};

/// The values of indices and constants; later ones hide earlier ones.
#[derive(Clone, Default)]
pub(super) struct Indices(Vec<(String, i64)>);

impl Indices {
    pub(super) fn get(&self, name: &str) -> Option<i64> {
        self.0.iter().rev().find(|(known, _)| known == name).map(|(_, value)| *value)
    }

    pub(super) fn with(&self, name: &str, value: i64) -> Indices {
        let mut indices = self.clone();
        indices.define(name, value);
        indices
    }

    pub(super) fn define(&mut self, name: &str, value: i64) {
        self.0.push((name.to_owned(), value));
    }

    /// A text in which indices stand in braces.
    pub(super) fn fill(&self, text: &str) -> String {
        let fill =
            |text: String, (name, value): &(String, i64)| text.replace(&format!("{{{name}}}"), &value.to_string());
        self.0.iter().rev().fold(text.to_owned(), fill)
    }

    fn names(&self) -> impl Iterator<Item = &str> {
        self.0.iter().map(|(name, _)| name.as_str())
    }
}

/// From the first to the last, and whether a name stands in the bounds.
pub(super) struct Range {
    pub(super) first: i64,
    pub(super) last: i64,
    pub(super) text: String,
    pub(super) is_literal: bool,
}

/// Reads `1..=n` or `0..n`.
pub(super) fn range(input: ParseStream, indices: &Indices) -> Result<Range> {
    let first_is_literal = input.peek(LitInt);
    let first = whole(input, indices)?;
    let closed = input.parse::<Option<Token![..=]>>()?.is_some();
    if !closed && input.parse::<Option<Token![..]>>()?.is_none() {
        return Err(here(input, "a repetition needs a range: `1..=3` includes its end, `0..3` does not"));
    }
    let last_is_literal = input.peek(LitInt);
    let end = whole(input, indices)?;
    let last = if closed { end } else { end.saturating_sub(1) };
    let text = format!("{first}{}{end}", if closed { "..=" } else { ".." });
    Ok(Range { first, last, text, is_literal: first_is_literal && last_is_literal })
}

/// Reads an expression of whole numbers.
pub(super) fn whole(input: ParseStream, indices: &Indices) -> Result<i64> {
    let mut left = product(input, indices)?;
    loop {
        let place = input.span();
        let result = match () {
            _ if input.parse::<Option<Token![+]>>()?.is_some() => left.checked_add(product(input, indices)?),
            _ if input.parse::<Option<Token![-]>>()?.is_some() => left.checked_sub(product(input, indices)?),
            _ => return Ok(left),
        };
        left = result.ok_or_else(|| too_large(place))?;
    }
}

fn product(input: ParseStream, indices: &Indices) -> Result<i64> {
    let mut left = atom(input, indices)?;
    loop {
        let place = input.span();
        let zero = || syn::Error::new(place, "division by zero in an index");
        if input.parse::<Option<Token![*]>>()?.is_some() {
            left = left.checked_mul(atom(input, indices)?).ok_or_else(|| too_large(place))?;
        } else if input.parse::<Option<Token![%]>>()?.is_some() {
            left = left.checked_rem_euclid(atom(input, indices)?).ok_or_else(zero)?;
        } else if input.parse::<Option<Token![/]>>()?.is_some() {
            let divisor = atom(input, indices)?;
            if left.checked_rem(divisor).ok_or_else(zero)? != 0 {
                return Err(syn::Error::new(place, format!("{left}/{divisor} is not a whole number")));
            }
            left /= divisor;
        } else {
            return Ok(left);
        }
    }
}

fn too_large(place: proc_macro2::Span) -> syn::Error {
    syn::Error::new(place, "this number is too large for an index")
}

fn atom(input: ParseStream, indices: &Indices) -> Result<i64> {
    let place = input.span();
    if input.parse::<Option<Token![-]>>()?.is_some() {
        return atom(input, indices)?.checked_neg().ok_or_else(|| too_large(place));
    }
    if input.peek(syn::token::Paren) {
        let content;
        syn::parenthesized!(content in input);
        let value = whole(&content, indices)?;
        return if content.is_empty() { Ok(value) } else { Err(not_whole(&content)) };
    }
    if input.peek(LitInt) {
        let literal: LitInt = input.parse()?;
        if !literal.suffix().is_empty() {
            return Err(not_whole_at(literal.span()));
        }
        return literal.base10_parse().map_err(|_| too_large(literal.span()));
    }
    if !input.peek(Ident::peek_any) {
        return Err(not_whole(input));
    }
    let name = input.call(Ident::parse_any)?;
    let text = name.unraw().to_string();
    indices.get(&text).ok_or_else(|| {
        let near = nearest::suggestion(&text, indices.names());
        let message =
            format!("no index is called `{text}`{near}; an index is made of whole numbers, `const`s and the counters of `repeat`");
        syn::Error::new(name.span(), message)
    })
}

pub(super) fn not_whole(input: ParseStream) -> syn::Error {
    not_whole_at(input.span())
}

fn not_whole_at(place: proc_macro2::Span) -> syn::Error {
    syn::Error::new(place, "an index is made of whole numbers and names: `i`, `i - 1`, `2*n`")
}
