//! Structs with a field for each entry of a vector.

use super::{ident, size};
use proc_macro2::{Ident, TokenStream};
use quote::quote;
use syn::Visibility;

/// A struct of scalars that converts from and to an array. Nothing for no fields.
pub(super) fn record(
    visibility: &Visibility,
    name: &Ident,
    docs: &str,
    fields: &[(String, Vec<String>)],
    path: &TokenStream,
) -> TokenStream {
    if fields.is_empty() {
        return TokenStream::new();
    }
    let (names, field_docs): (Vec<_>, Vec<_>) = fields.iter().map(|(name, docs)| (ident(name), docs)).unzip();
    let n = size(names.len());
    let places = (0..names.len()).map(size);
    quote! {
        #[doc = #docs]
        #[allow(non_snake_case)]
        #[derive(::core::clone::Clone, ::core::marker::Copy, ::core::fmt::Debug, ::core::cmp::PartialEq)]
        #visibility struct #name<S = ::core::primitive::f64> { #(#(#[doc = #field_docs])* pub #names: S,)* }

        impl<S: #path::Scalar> ::core::convert::From<[S; #n]> for #name<S> {
            fn from(values: [S; #n]) -> Self {
                Self { #(#names: values[#places]),* }
            }
        }

        impl<S: #path::Scalar> ::core::convert::From<#name<S>> for [S; #n] {
            fn from(record: #name<S>) -> Self {
                [#(record.#names),*]
            }
        }
    }
}

/// The type of a vector that has a struct of its own if it has entries.
pub(super) fn record_type(name: &Ident, len: usize) -> TokenStream {
    if len == 0 {
        quote! { [S; 0] }
    } else {
        quote! { #name<S> }
    }
}
