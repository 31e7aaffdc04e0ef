//! Expressions as Rust, with every parenthesis that Rust's precedence needs, and no other.

use super::ident;
use crate::program::Tree;
use proc_macro2::{Delimiter, Group, Literal, Punct, Spacing, TokenStream};
use quote::{ToTokens, TokenStreamExt, quote};
use std::f64::consts::{E, PI};

/// How tightly the outermost operation of a piece of Rust binds.
#[derive(Clone, Copy, PartialEq, PartialOrd)]
enum Binding {
    Sum,
    Product,
    Unary,
    Atom,
}

/// An expression, written in place: nested token streams would be copied token by token.
impl ToTokens for Tree {
    fn to_tokens(&self, out: &mut TokenStream) {
        match self {
            Tree::Constant(value) => out.extend(constant(*value)),
            Tree::Name(name) => out.append(ident(name)),
            Tree::Field(name) => {
                out.append(ident("self"));
                mark('.', out);
                out.append(ident(name));
            }
            Tree::Sum(terms) => sum(terms, out),
            Tree::Product(factors) => product(factors, out),
            Tree::Quotient(above, below) => {
                bound(above, Binding::Product, out);
                mark('/', out);
                bound(below, Binding::Unary, out);
            }
            Tree::Negate(operand) => {
                mark('-', out);
                bound(operand, Binding::Unary, out);
            }
            Tree::Method(name, arguments) => {
                if let Some(receiver) = arguments.first() {
                    bound(receiver, Binding::Atom, out);
                }
                mark('.', out);
                out.append(ident(name));
                let others = arguments.iter().skip(1);
                out.append(Group::new(Delimiter::Parenthesis, quote! { #(#others),* }));
            }
        }
    }
}

fn bound(tree: &Tree, at_least: Binding, out: &mut TokenStream) {
    if binding(tree) >= at_least {
        tree.to_tokens(out);
    } else {
        out.append(Group::new(Delimiter::Parenthesis, tree.to_token_stream()));
    }
}

fn binding(tree: &Tree) -> Binding {
    match tree {
        Tree::Constant(_) | Tree::Name(_) | Tree::Field(_) | Tree::Method(..) => Binding::Atom,
        Tree::Sum(_) => Binding::Sum,
        Tree::Product(_) | Tree::Quotient(..) => Binding::Product,
        Tree::Negate(_) => Binding::Unary,
    }
}

fn sum(terms: &[(bool, Tree)], out: &mut TokenStream) {
    for (at, (negative, term)) in terms.iter().enumerate() {
        match (at, negative) {
            (0, false) => {}
            (_, true) => mark('-', out),
            (_, false) => mark('+', out),
        }
        bound(term, if at == 0 { Binding::Sum } else { Binding::Product }, out);
    }
}

fn product(factors: &[Tree], out: &mut TokenStream) {
    for (at, factor) in factors.iter().enumerate() {
        if at > 0 {
            mark('*', out);
        }
        bound(factor, if at == 0 { Binding::Product } else { Binding::Unary }, out);
    }
}

fn mark(sign: char, out: &mut TokenStream) {
    out.append(Punct::new(sign, Spacing::Alone));
}

fn constant(value: f64) -> TokenStream {
    let number = number(value);
    quote! { S::from_f64(#number) }
}

/// A number of Rust.
pub(super) fn number(value: f64) -> TokenStream {
    match value {
        // Overflow in the derivation behaves as in arithmetic.
        _ if value.is_nan() => quote! { ::core::f64::NAN },
        _ if value.is_infinite() => quote! { ::core::f64::INFINITY },
        _ if value == PI => quote! { ::core::f64::consts::PI },
        _ if value == E => quote! { ::core::f64::consts::E },
        _ if value.is_sign_negative() => {
            let size = number(-value);
            quote! { -#size }
        }
        _ => literal(value).into_token_stream(),
    }
}

/// The shortest text that reads back as the same number.
fn literal(value: f64) -> Literal {
    let digits = || Literal::f64_unsuffixed(value);
    // Outside this range there would be many zeros.
    match (1e-4..1e16).contains(&value) {
        true => digits(),
        false => format!("{value:?}").parse().unwrap_or_else(|_| digits()),
    }
}
