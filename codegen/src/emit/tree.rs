//! Expressions as Rust, with every parenthesis that Rust's precedence needs, and no other.

use super::ident;
use crate::program::Tree;
use proc_macro2::{Literal, TokenStream};
use quote::{ToTokens, quote};
use std::f64::consts::{E, PI};

/// How tightly the outermost operation of a piece of Rust binds.
#[derive(Clone, Copy, PartialEq, PartialOrd)]
enum Binding {
    Sum,
    Product,
    Unary,
    Atom,
}

/// An expression.
pub(super) fn tree(tree: &Tree) -> TokenStream {
    tokens(tree).0
}

fn bound(tree: &Tree, at_least: Binding) -> TokenStream {
    let (tokens, binding) = tokens(tree);
    if binding >= at_least {
        tokens
    } else {
        quote! { (#tokens) }
    }
}

fn tokens(tree: &Tree) -> (TokenStream, Binding) {
    match tree {
        Tree::Constant(value) => (constant(*value), Binding::Atom),
        Tree::Name(name) => (ident(name).into_token_stream(), Binding::Atom),
        Tree::Field(name) => {
            let name = ident(name);
            (quote! { self.#name }, Binding::Atom)
        }
        Tree::Sum(terms) => (sum(terms), Binding::Sum),
        Tree::Product(factors) => (product(factors), Binding::Product),
        Tree::Quotient(above, below) => {
            let (above, below) = (bound(above, Binding::Product), bound(below, Binding::Unary));
            (quote! { #above / #below }, Binding::Product)
        }
        Tree::Negate(operand) => {
            let operand = bound(operand, Binding::Unary);
            (quote! { -#operand }, Binding::Unary)
        }
        Tree::Method(name, arguments) => {
            let name = ident(name);
            let receiver = arguments.first().map(|receiver| bound(receiver, Binding::Atom));
            let others = arguments.iter().skip(1).map(self::tree);
            (quote! { #receiver.#name(#(#others),*) }, Binding::Atom)
        }
    }
}

fn sum(terms: &[(bool, Tree)]) -> TokenStream {
    let mut out = TokenStream::new();
    for (at, (negative, term)) in terms.iter().enumerate() {
        let term = bound(term, if at == 0 { Binding::Sum } else { Binding::Product });
        out.extend(match (at, negative) {
            (0, false) => term,
            (_, true) => quote! { - #term },
            (_, false) => quote! { + #term },
        });
    }
    out
}

fn product(factors: &[Tree]) -> TokenStream {
    let mut out = TokenStream::new();
    for (at, factor) in factors.iter().enumerate() {
        if at > 0 {
            out.extend(quote! { * });
        }
        out.extend(bound(factor, if at == 0 { Binding::Product } else { Binding::Unary }));
    }
    out
}

fn constant(value: f64) -> TokenStream {
    let number = number(value);
    quote! { S::from_f64(#number) }
}

/// A number of Rust.
pub(super) fn number(value: f64) -> TokenStream {
    match value {
        // What overflows in the derivation behaves as it would in arithmetic.
        _ if value.is_nan() => quote! { ::core::f64::NAN },
        _ if value.is_infinite() => quote! { ::core::f64::INFINITY },
        _ if value == PI => quote! { ::core::f64::consts::PI },
        _ if value == E => quote! { ::core::f64::consts::E },
        _ if value.is_sign_negative() => {
            let size = number(-value);
            quote! { -#size }
        }
        _ => {
            // Shortest text that reads back as the same number.
            let literal = format!("{value:?}").parse::<Literal>().unwrap_or_else(|_| Literal::f64_unsuffixed(value));
            quote! { #literal }
        }
    }
}
