//! The mechanism's type and its named vectors.

use super::documentation::documented;
use super::equations::equations as documented_equations;
use super::ident;
use super::marker::has_no_fields;
use super::names::{output_rates_name, outputs_name, prepared_name};
use super::record::record;
use crate::dsl::Head;
use crate::dynamics::EquationsOfMotion;
use crate::kernel_id::Record;
use crate::model::Model;
use crate::program::{Kernel, Program, Results};
use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

/// The types that a user names.
pub(super) fn types(head: &Head, equations: &EquationsOfMotion, program: &Program, path: &TokenStream) -> TokenStream {
    let model = &equations.model;
    let visibility = &head.visibility;
    let mechanism = mechanism(head, equations, path);
    let name = &model.name;
    let coordinates: Vec<_> =
        model.coordinates.iter().map(|c| (c.name.clone(), documented(&c.docs, &c.unit))).collect();
    let outputs: Vec<_> = model.outputs.iter().map(|o| (o.name.clone(), documented(&o.docs, &o.unit))).collect();
    let rates: Vec<_> = equations
        .outputs
        .rated()
        .into_iter()
        .map(|i| (model.outputs[i].name.clone(), vec![format!(" Rate of `{}`.", model.outputs[i].name)]))
        .collect();
    let records = [
        record(
            visibility,
            &format_ident!("{name}Coordinates"),
            &format!(" Coordinates of [`{name}`] by name, in SI units; also for their speeds and accelerations."),
            &coordinates,
            path,
        ),
        record(
            visibility,
            &outputs_name(model),
            &format!(" Outputs of [`{name}`] by name, in SI units."),
            &outputs,
            path,
        ),
        record(
            visibility,
            &output_rates_name(model),
            &format!(" Rates of the outputs of [`{name}`] by name, in SI units."),
            &rates,
            path,
        ),
    ];
    let prepared = prepared(head, model, program, path);
    quote! { #mechanism #(#records)* #prepared }
}

fn mechanism(head: &Head, equations: &EquationsOfMotion, path: &TokenStream) -> TokenStream {
    let model = &equations.model;
    let (visibility, name) = (&head.visibility, ident(&model.name));
    let docs = model.docs.lines().map(|line| format!(" {line}"));
    let written = documented_equations(equations);
    let fields = model.parameters.iter().map(|p| {
        let (name, docs) = (ident(&p.name), documented(&p.docs, &p.unit));
        quote! { #(#[doc = #docs])* pub #name: S, }
    });
    let activities = model.conditionals.iter().map(|c| {
        let (field, docs) =
            (ident(&c.field), format!(" Whether constraint `{}` holds: 1, or 0 where it is released.", c.name));
        quote! { #[doc = #docs] pub #field: S, }
    });
    let inputs = model.inputs.iter().map(|input| {
        let (name, docs) = (ident(&input.name), documented(&input.docs, &input.unit));
        quote! { #(#[doc = #docs])* pub #name: #path::Input<S>, }
    });
    let about = match model.inputs.is_empty() {
        true => " The fields are its parameters, in SI units; the methods are its kernels.",
        false => " The fields are its parameters and inputs, in SI units; the methods are its kernels.",
    };
    let marker = has_no_fields(model).then(|| quote! { scalar: ::core::marker::PhantomData<S>, });
    quote! {
        #(#[doc = #docs])*
        ///
        #[doc = #about]
        #(#[doc = #written])*
        #[allow(non_snake_case)]
        #[derive(::core::clone::Clone, ::core::marker::Copy, ::core::fmt::Debug, ::core::cmp::PartialEq)]
        #visibility struct #name<S = ::core::primitive::f64> { #(#fields)* #(#inputs)* #(#activities)* #marker }

        impl<S: #path::Scalar> ::core::default::Default for #name<S> {
            /// The declared values.
            fn default() -> Self {
                <Self as #path::Compiled<S>>::defaults()
            }
        }
    }
}

/// The values that the kernels of each step need of the parameters.
fn prepared(head: &Head, model: &Model, program: &Program, path: &TokenStream) -> TokenStream {
    let (visibility, name) = (&head.visibility, prepared_name(model));
    let fields: Vec<Ident> = program.kernels.iter().flat_map(prepared_fields).map(ident).collect();
    let inputs = model.inputs.iter().map(|input| {
        let (name, docs) = (ident(&input.name), documented(&input.docs, &input.unit));
        quote! { #(#[doc = #docs])* pub #name: #path::Input<S>, }
    });
    let is_empty = fields.is_empty() && model.inputs.is_empty();
    let marker = is_empty.then(|| quote! { scalar: ::core::marker::PhantomData<S>, });
    let docs = format!(
        " What the equations of motion need of the parameters of [`{0}`], from [`{0}::prepare`]; its methods are the \
         kernels of each step.",
        model.name
    );
    quote! {
        #[doc = #docs]
        #[allow(non_snake_case)]
        #[derive(::core::clone::Clone, ::core::marker::Copy, ::core::fmt::Debug, ::core::cmp::PartialEq)]
        #visibility struct #name<S = ::core::primitive::f64> { #(#fields: S,)* #(#inputs)* #marker }
    }
}

fn prepared_fields(kernel: &Kernel) -> Vec<&str> {
    match &kernel.results {
        Results::Record(Record::Prepared, fields) => fields.iter().map(|(name, _)| name.as_str()).collect(),
        _ => vec![],
    }
}
