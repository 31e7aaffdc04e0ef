//! Regions of the user's text.

use proc_macro2::{Span, TokenStream, TokenTree};
use quote::quote_spanned;

/// A stretch of the user's text, from its first to its last word.
#[derive(Clone, Copy, Debug)]
pub struct Region {
    first: Span,
    last: Span,
}

impl Region {
    /// From the start of one region to the end of another.
    pub fn to(self, end: Region) -> Region {
        Region { first: self.first, last: end.last }
    }

    /// The start of the region.
    pub fn start(self) -> Span {
        self.first
    }

    /// The end of the region.
    pub fn end(self) -> Span {
        self.last
    }

    /// A mistake here. The message says what is wrong and what would be right.
    pub fn error(self, message: impl std::fmt::Display) -> syn::Error {
        // An error takes its place from the first and last token it is given.
        let (first, last) = (quote_spanned!(self.first=> a), quote_spanned!(self.last=> b));
        let ends: TokenStream = first.into_iter().chain(last).collect::<Vec<TokenTree>>().into_iter().collect();
        syn::Error::new_spanned(ends, message)
    }
}

impl From<Span> for Region {
    fn from(span: Span) -> Region {
        Region { first: span, last: span }
    }
}

impl From<&syn::Ident> for Region {
    fn from(ident: &syn::Ident) -> Region {
        ident.span().into()
    }
}

/// A mistake at the next word, or where the words end.
pub(super) fn here(input: syn::parse::ParseStream, message: impl std::fmt::Display) -> syn::Error {
    syn::Error::new(input.span(), message)
}
