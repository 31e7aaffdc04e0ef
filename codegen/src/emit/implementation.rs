//! The impl of the runtime's trait.

use super::concrete::Concrete;
use super::description::description;
use super::forward::forwards;
use super::marker::has_no_fields;
use super::names::other_scalar;
use super::speeds;
use super::{ident, size};
use crate::dsl::Source;
use crate::dynamics::EquationsOfMotion;
use crate::kernel_id::Trait;
use crate::model::Model;
use crate::program::Program;
use crate::symbolic::{Expr, evaluate};
use proc_macro2::{Ident, TokenStream};
use quote::quote;

/// The runtime's trait: sizes, description, and every kernel by name.
pub(super) fn implementation(
    equations: &EquationsOfMotion,
    program: &Program,
    source: &Source,
    concrete: &Concrete,
    path: &TokenStream,
) -> TokenStream {
    let model = &equations.model;
    let name = ident(&model.name);
    let (types, other) = (concrete.definitions(Trait::Mechanism), other_scalar(&model.name));
    let description = description(equations, program, source, path);
    let parameters = parameters(equations, path);
    let inputs = inputs(model, path);
    let switched = switched(model);
    let velocity_variables = speeds::velocity_variables(equations, path);
    let forwards = forwards(Trait::Mechanism, model, program, concrete, path);
    quote! {
        #[allow(non_snake_case, clippy::all, clippy::pedantic)]
        impl<S: #path::Scalar> #path::Mechanism<S> for #name<S> {
            #types
            type On<#other: #path::Scalar> = #name<#other>;

            const DESCRIPTION: #path::Description = #description;

            #parameters

            #inputs

            #switched

            #velocity_variables

            #forwards
        }
    }
}

/// Reading, changing and converting parameters.
fn parameters(equations: &EquationsOfMotion, path: &TokenStream) -> TokenStream {
    let EquationsOfMotion { model, graph, .. } = equations;
    let (name, other) = (ident(&model.name), other_scalar(&model.name));
    let p = size(model.parameters.len());
    let fields: Vec<_> = model.parameters.iter().map(|p| ident(&p.name)).collect();
    let places = (0..fields.len()).map(size);
    let inputs: Vec<_> = model.inputs.iter().map(|input| ident(&input.name)).collect();
    let activities: Vec<_> = model.conditionals.iter().map(|c| ident(&c.field)).collect();
    let starts = model.conditionals.iter().map(|c| match c.initially_active {
        true => quote! { S::from_f64(1.0) },
        false => quote! { S::from_f64(0.0) },
    });
    let marker = has_no_fields(model).then(|| quote! { scalar: ::core::marker::PhantomData });
    let defaults: Vec<Expr> = model.parameters.iter().map(|p| p.default).collect();
    let defaults = evaluate(graph, &defaults, |_| f64::NAN);
    quote! {
        fn defaults() -> Self {
            Self { #(#fields: S::from_f64(#defaults),)* #(#inputs: #path::Input::Declared,)* #(#activities: #starts,)* #marker }
        }

        fn parameters(&self) -> [S; #p] {
            [#(self.#fields),*]
        }

        fn with_parameters(&self, parameters: [S; #p]) -> Self {
            Self { #(#fields: parameters[#places],)* ..*self }
        }

        fn on<#other: #path::Scalar>(&self, convert: impl ::core::ops::Fn(S) -> #other) -> #name<#other> {
            #name { #(#fields: convert(self.#fields),)* #(#inputs: self.#inputs.map(&convert),)* #(#activities: convert(self.#activities),)* #marker }
        }
    }
}

/// Reading and setting inputs.
fn inputs(model: &Model, path: &TokenStream) -> TokenStream {
    let inputs: Vec<_> = model.inputs.iter().map(|input| ident(&input.name)).collect();
    let (places, len): (Vec<_>, _) = ((0..inputs.len()).map(size).collect(), size(inputs.len()));
    quote! {
        fn inputs(&self) -> [#path::Input<S>; #len] {
            [#(self.#inputs),*]
        }

        fn with_inputs(&self, inputs: [#path::Input<S>; #len]) -> Self {
            Self { #(#inputs: inputs[#places],)* ..*self }
        }

        fn set_inputs(prepared: &mut Self::Prepared, inputs: [#path::Input<S>; #len]) {
            #(prepared.#inputs = inputs[#places];)*
        }
    }
}

/// Reading and changing activities, if there are any.
fn switched(model: &Model) -> Option<TokenStream> {
    let fields: Vec<Ident> = model.conditionals.iter().map(|c| ident(&c.field)).collect();
    let (len, places) = (size(fields.len()), (0..fields.len()).map(size));
    (!fields.is_empty()).then(|| {
        quote! {
            fn activities(&self) -> [S; #len] {
                [#(self.#fields),*]
            }

            fn with_activities(self, activities: [S; #len]) -> Self {
                Self { #(#fields: activities[#places],)* ..self }
            }
        }
    })
}
