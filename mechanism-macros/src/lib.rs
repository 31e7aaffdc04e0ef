//! The procedural macro behind `mechanism!`. Use it through `sim::mechanism!` or `sim_kernel::mechanism!`, which
//! tell it where the runtime's traits are.

use proc_macro::TokenStream;

/// Takes the path of `sim_kernel`, a semicolon and a declaration; gives the mechanism's types and kernels.
#[proc_macro]
pub fn mechanism_at(input: TokenStream) -> TokenStream {
    codegen::expand(input.into()).into()
}
