//! The names of generated types.

use super::ident;
use crate::kernel_id::Arguments;
use crate::model::Model;
use proc_macro2::Ident;
use quote::format_ident;

pub(super) fn outputs_name(model: &Model) -> Ident {
    format_ident!("{}Outputs", ident(&model.name))
}

pub(super) fn output_rates_name(model: &Model) -> Ident {
    format_ident!("{}OutputRates", ident(&model.name))
}

pub(super) fn prepared_name(model: &Model) -> Ident {
    format_ident!("{}Prepared", ident(&model.name))
}

/// The name of the scalar that a mechanism is converted to.
pub(super) fn other_scalar(mechanism: &str) -> Ident {
    ident(if mechanism == "T" { "U" } else { "T" })
}

/// `t, q, ..`
pub(super) fn argument_names(arguments: Arguments) -> Vec<Ident> {
    arguments.list().iter().map(|argument| ident(argument.name())).collect()
}
