//! Tables as constants of the mechanism, in which its kernels look values up.

use super::tree::number;
use crate::symbolic::{Graph, Table};
use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

/// The name of a table's constant.
pub(super) fn constant(table: &str) -> Ident {
    format_ident!("TABLE_{table}")
}

/// The constants of all tables.
pub(super) fn tables(graph: &Graph, path: &TokenStream) -> TokenStream {
    graph.tables().iter().map(|table| table_constant(table, path)).collect()
}

fn table_constant(table: &Table, path: &TokenStream) -> TokenStream {
    let name = constant(&table.name);
    let docs = match table.docs.as_str() {
        "" => format!("Table `{}`, in SI units.", table.name),
        docs => format!("{}, in SI units.", docs.trim_end_matches('.')),
    };
    let docs = docs.lines().map(|line| format!(" {line}"));
    let knots = table.knots.iter().map(|knot| number(*knot));
    let pieces = table.pieces.iter().enumerate().map(|(place, coefficients)| {
        let numbers = [table.start(place)].into_iter().chain(*coefficients).map(number);
        quote! { [#(#numbers),*] }
    });
    let period = number(table.period().unwrap_or(0.0));
    quote! {
        #(#[doc = #docs])*
        pub const #name: #path::Table = #path::Table::new(&[#(#knots),*], &[#(#pieces),*], #period);
    }
}
