//! The procedural macros behind `mechanism!`. A crate that depends on `sim` has `sim::mechanism!`; one that wants kernels
//! alone depends on `sim-kernel`, and on this crate for [`mechanism!`].

use proc_macro::TokenStream;
use quote::quote;

/// Declares a mechanism, in a crate that depends on `sim-kernel`: see the language reference, `LANGUAGE.md` at the project's
/// root.
#[proc_macro]
pub fn mechanism(declaration: TokenStream) -> TokenStream {
    let declaration = proc_macro2::TokenStream::from(declaration);
    codegen::expand(quote! { ::sim_kernel; #declaration }).into()
}

/// Takes the path of `sim_kernel`, a semicolon and a declaration; gives the mechanism's types and kernels.
#[doc(hidden)]
#[proc_macro]
pub fn mechanism_at(input: TokenStream) -> TokenStream {
    codegen::expand(input.into()).into()
}
