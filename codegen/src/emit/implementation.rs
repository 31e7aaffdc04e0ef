//! The impl of the runtime's trait.

use super::description::description;
use super::forward::forward;
use super::marker::has_no_fields;
use super::names::{other_scalar, prepared_name};
use super::speeds;
use super::{ident, size};
use crate::dsl::Source;
use crate::dynamics::EquationsOfMotion;
use crate::model::Model;
use crate::program::{Program, Results, Sparsity};
use crate::symbolic::{Expr, evaluate};
use proc_macro2::{Ident, TokenStream};
use quote::quote;

/// The runtime's trait: sizes, description, and every kernel by name.
pub(super) fn implementation(
    equations: &EquationsOfMotion,
    program: &Program,
    source: &Source,
    path: &TokenStream,
) -> TokenStream {
    let model = &equations.model;
    let name = ident(&model.name);
    let types = types(equations, program, path);
    let description = description(equations, program, source, path);
    let parameters = parameters(model, path);
    let inputs = inputs(model, path);
    let switched = switched(model);
    let velocity_variables = speeds::velocity_variables(equations, path);
    let own = program.kernels.iter().filter(|kernel| !speeds::is_of_speeds(kernel));
    let forwards = own.map(|kernel| forward(model, kernel, path));
    quote! {
        #[allow(non_snake_case, clippy::all, clippy::pedantic)]
        impl<S: #path::Scalar> #path::Mechanism<S> for #name<S> {
            #types

            const DESCRIPTION: #path::Description = #description;

            #parameters

            #inputs

            #switched

            #velocity_variables

            #(#forwards)*
        }
    }
}

/// The types of the trait's vectors and matrices.
fn types(equations: &EquationsOfMotion, program: &Program, path: &TokenStream) -> TokenStream {
    let model = &equations.model;
    let (name, prepared, other) = (ident(&model.name), prepared_name(model), other_scalar(&model.name));
    let [n, m] = [model.coordinates.len(), model.constraints.len()];
    let z = size(n + m);
    let [n, m, p, outputs] = [n, m, model.parameters.len(), model.outputs.len()].map(size);
    let [events, rates, drawing] =
        [model.events.len(), equations.outputs.rated().len(), kernel_len(program, "drawing")].map(size);
    let [entries, envelope] = program.sparsity.as_ref().map_or([0; 2], Sparsity::sizes).map(size);
    let [conditionals, values, inputs] =
        [model.conditionals.len(), kernel_len(program, "event_values"), model.inputs.len()].map(size);
    quote! {
        type Q = [S; #n];
        type L = [S; #m];
        type Z = [S; #z];
        type QQ = [[S; #n]; #n];
        type LQ = [[S; #n]; #m];
        type LL = [[S; #m]; #m];
        type ZZ = [[S; #z]; #z];
        type Entries = [S; #entries];
        type Envelope = [S; #envelope];
        type Parameters = [S; #p];
        type Outputs = [S; #outputs];
        type OutputRates = [S; #rates];
        type Events = [S; #events];
        type EventValues = [S; #values];
        type Activities = [S; #conditionals];
        type Drawing = [S; #drawing];
        type QP = [[S; #p]; #n];
        type LP = [[S; #p]; #m];
        type Inputs = [#path::Input<S>; #inputs];
        type Prepared = #prepared<S>;
        type On<#other: #path::Scalar> = #name<#other>;
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
    let starts = model.conditionals.iter().map(|c| match c.initially_active {
        true => quote! { S::from_f64(1.0) },
        false => quote! { S::from_f64(0.0) },
    });
    let marker = has_no_fields(model).then(|| quote! { scalar: ::core::marker::PhantomData });
    let defaults: Vec<Expr> = model.parameters.iter().map(|p| p.default).collect();
    let defaults = evaluate(&model.graph, &defaults, |_| f64::NAN);
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

fn kernel_len(program: &Program, name: &str) -> usize {
    program.kernels.iter().find(|kernel| kernel.name == name).map_or(0, |kernel| match &kernel.results {
        Results::Vector(entries) => entries.len(),
        _ => 0,
    })
}
