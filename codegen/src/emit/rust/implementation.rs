//! The impl of the runtime's trait.

use super::concrete::Concrete;
use super::forward::forwards;
use super::marker::has_no_fields;
use super::names::other_scalar;
use super::speeds;
use super::{ident, size};
use crate::description::Description;
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
    description: &Description,
    concrete: &Concrete,
    path: &TokenStream,
) -> TokenStream {
    let model = &equations.model;
    let name = ident(&model.name);
    let (types, other) = (concrete.definitions(Trait::Mechanism), other_scalar(&model.name));
    let description = super::description::description(description, path);
    let (defaults, parameters) = (defaults(equations, path), parameters(model, path));
    let inputs = inputs(model, path);
    let switched = switched(model);
    let velocity_variables = speeds::velocity_variables(equations, path);
    let forwards = forwards(Trait::Mechanism, model, program, concrete, path);
    quote! {
        #[allow(non_snake_case, unused_variables, clippy::all, clippy::pedantic)]
        impl<S: #path::Scalar> #path::Mechanism<S> for #name<S> {
            #types
            type On<#other: #path::Scalar> = #name<#other>;

            #[inline(always)]
            fn description(&self) -> &'static #path::Description {
                const { &<Self as #path::Compiled<S>>::DESCRIPTION }
            }

            fn as_declared(&self) -> Self {
                <Self as #path::Compiled<S>>::defaults()
            }

            #parameters

            #inputs

            #switched

            #velocity_variables

            #forwards
        }

        #[allow(clippy::all, clippy::pedantic)]
        impl<S: #path::Scalar> #path::Compiled<S> for #name<S> {
            const DESCRIPTION: #path::Description = #description;

            #defaults
        }
    }
}

/// The declared values.
fn defaults(equations: &EquationsOfMotion, path: &TokenStream) -> TokenStream {
    let EquationsOfMotion { model, graph, .. } = equations;
    let fields = model.parameters.iter().map(|p| ident(&p.name));
    let inputs = model.inputs.iter().map(|input| ident(&input.name));
    let activities = model.conditionals.iter().map(|c| ident(&c.field));
    let starts = model.conditionals.iter().map(|c| match c.initially_active {
        true => quote! { S::from_f64(1.0) },
        false => quote! { S::from_f64(0.0) },
    });
    let marker = has_no_fields(model).then(|| quote! { scalar: ::core::marker::PhantomData });
    let values: Vec<Expr> = model.parameters.iter().map(|p| p.default).collect();
    let values = evaluate(graph, &values, |_| f64::NAN);
    quote! {
        fn defaults() -> Self {
            Self { #(#fields: S::from_f64(#values),)* #(#inputs: #path::Input::Declared,)* #(#activities: #starts,)* #marker }
        }
    }
}

/// Reading, changing and converting parameters.
fn parameters(model: &Model, path: &TokenStream) -> TokenStream {
    let (name, other) = (ident(&model.name), other_scalar(&model.name));
    let p = size(model.parameters.len());
    let fields: Vec<_> = model.parameters.iter().map(|p| ident(&p.name)).collect();
    let places = (0..fields.len()).map(size);
    let inputs: Vec<_> = model.inputs.iter().map(|input| ident(&input.name)).collect();
    let activities: Vec<_> = model.conditionals.iter().map(|c| ident(&c.field)).collect();
    let marker = has_no_fields(model).then(|| quote! { scalar: ::core::marker::PhantomData });
    quote! {
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
