//! Generated code as text, to be read.

use proc_macro2::TokenStream;

/// Formats generated items.
///
/// # Errors
/// If the tokens are not Rust items.
pub fn format(tokens: TokenStream) -> syn::Result<String> {
    Ok(prettyplease::unparse(&syn::parse2(tokens)?))
}
