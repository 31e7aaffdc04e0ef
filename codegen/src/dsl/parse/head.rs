//! The head of a declaration.

use super::words::{docs, name};
use crate::dsl::region::here;
use crate::dsl::vocabulary::{Block, Word};
use crate::dsl::{Head, limits};
use proc_macro2::{TokenStream, TokenTree};
use syn::ext::IdentExt;
use syn::parse::{ParseStream, Parser, Result};
use syn::{Token, Visibility};

/// Reads only the head.
///
/// # Errors
/// Where the head itself is not `/// docs  pub Name;`.
pub fn parse_head(tokens: TokenStream) -> Result<Head> {
    // The rest may be beyond the limits.
    let mut is_open = true;
    let ends = |token: &TokenTree| matches!(token, TokenTree::Punct(punct) if punct.as_char() == ';');
    let words = tokens.into_iter().take_while(|token| std::mem::replace(&mut is_open, !ends(token)));
    let words: TokenStream = words.collect();
    limits::check(words.clone())?;
    head.parse2(words)
}

pub(super) fn head(input: ParseStream) -> Result<Head> {
    const FORM: &str = "a declaration starts with the mechanism's name: `pub QuickReturn;`";
    let docs = docs(input)?;
    let visibility: Visibility = input.parse()?;
    let name = name(input, FORM).map_err(|e| syn::Error::new(e.span(), FORM))?;
    if Block::of(&name.to_string()).is_some() {
        return Err(syn::Error::new(name.span(), FORM));
    }
    let taken = match name.unraw().to_string().as_str() {
        "S" => "is the scalar type in generated code",
        "sim" | "sim_kernel" | "core" | "alloc" | "std" => "is a crate that generated code refers to",
        _ => "",
    };
    if !taken.is_empty() {
        return Err(syn::Error::new(name.span(), format!("`{name}` {taken}; choose another name")));
    }
    if input.parse::<Option<Token![;]>>()?.is_none() {
        return Err(here(input, FORM));
    }
    Ok(Head { docs, visibility, name })
}
