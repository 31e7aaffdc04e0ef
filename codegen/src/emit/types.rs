//! The mechanism's type, its named vectors, and the impl of the runtime's trait.

use super::description::description;
use super::equations::equations as documented_equations;
use super::kernel::{argument_names, arguments, record_of, returned_array};
use super::record::record;
use super::speeds;
use super::{ident, size};
use crate::dsl::Head;
use crate::dynamics::EquationsOfMotion;
use crate::model::{Model, Unit};
use crate::program::{Kernel, Program, Receiver, Record, Results, Sparsity};
use crate::symbolic::{Expr, evaluate};
use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

pub(super) fn outputs_name(model: &Model) -> Ident {
    format_ident!("{}Outputs", ident(&model.name))
}

pub(super) fn output_rates_name(model: &Model) -> Ident {
    format_ident!("{}OutputRates", ident(&model.name))
}

pub(super) fn prepared_name(model: &Model) -> Ident {
    format_ident!("{}Prepared", ident(&model.name))
}

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

/// Documentation of a quantity with its unit, a line each.
pub(super) fn documented(docs: &str, unit: &Unit) -> Vec<String> {
    let text = docs.trim_end_matches('.');
    let unit = unit.si_text();
    let text = if text.is_empty() { format!("In `{unit}`.") } else { format!("{text}, in `{unit}`.") };
    text.lines().map(|line| format!(" {line}")).collect()
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
                <Self as #path::Mechanism<S>>::defaults()
            }
        }
    }
}

/// What the kernels of each step need of the parameters.
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

/// Whether the mechanism needs a field for its scalar alone.
fn has_no_fields(model: &Model) -> bool {
    model.parameters.is_empty() && model.inputs.is_empty() && model.conditionals.is_empty()
}

fn prepared_fields(kernel: &Kernel) -> Vec<&str> {
    match &kernel.results {
        Results::Record(Record::Prepared, fields) => fields.iter().map(|(name, _)| name.as_str()).collect(),
        _ => vec![],
    }
}

/// The runtime's trait: sizes, description, and every kernel by name.
pub(super) fn mechanism_impl(
    equations: &EquationsOfMotion,
    program: &Program,
    declaration: &str,
    path: &TokenStream,
) -> TokenStream {
    let model = &equations.model;
    let (name, prepared, other) = (ident(&model.name), prepared_name(model), other_scalar(&model.name));
    let [n, m] = [model.coordinates.len(), model.constraints.len()];
    let z = size(n + m);
    let [n, m, p, outputs] = [n, m, model.parameters.len(), model.outputs.len()].map(size);
    let [events, rates, drawing] =
        [model.events.len(), equations.outputs.rated().len(), kernel_len(program, "drawing")].map(size);
    let description = description(equations, program, declaration, path);
    let [entries, envelope] = program.sparsity.as_ref().map_or([0; 2], Sparsity::sizes).map(size);
    let fields: Vec<_> = model.parameters.iter().map(|p| ident(&p.name)).collect();
    let places = (0..fields.len()).map(size);
    let (activities, starts): (Vec<_>, Vec<_>) = model
        .conditionals
        .iter()
        .map(|c| {
            (
                ident(&c.field),
                if c.initially_active {
                    quote! { S::from_f64(1.0) }
                } else {
                    quote! { S::from_f64(0.0) }
                },
            )
        })
        .unzip();
    let switched = switched(model);
    let velocity_variables = speeds::velocity_variables(equations, path);
    let (conditionals, values) = (size(activities.len()), size(kernel_len(program, "event_values")));
    let marker = has_no_fields(model).then(|| quote! { scalar: ::core::marker::PhantomData });
    let inputs: Vec<_> = model.inputs.iter().map(|input| ident(&input.name)).collect();
    let (input_places, input_count): (Vec<_>, _) = ((0..inputs.len()).map(size).collect(), size(inputs.len()));
    let defaults: Vec<Expr> = model.parameters.iter().map(|p| p.default).collect();
    let defaults = evaluate(&model.graph, &defaults, |_| f64::NAN);
    let own = program.kernels.iter().filter(|kernel| !speeds::is_of_speeds(kernel));
    let forwards = own.map(|kernel| forward(model, kernel, path));
    quote! {
        #[allow(non_snake_case, clippy::all, clippy::pedantic)]
        impl<S: #path::Scalar> #path::Mechanism<S> for #name<S> {
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
            type Inputs = [#path::Input<S>; #input_count];
            type Prepared = #prepared<S>;
            type On<#other: #path::Scalar> = #name<#other>;

            const DESCRIPTION: #path::Description = #description;

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

            fn inputs(&self) -> [#path::Input<S>; #input_count] {
                [#(self.#inputs),*]
            }

            fn with_inputs(&self, inputs: [#path::Input<S>; #input_count]) -> Self {
                Self { #(#inputs: inputs[#input_places],)* ..*self }
            }

            fn set_inputs(prepared: &mut Self::Prepared, inputs: [#path::Input<S>; #input_count]) {
                #(prepared.#inputs = inputs[#input_places];)*
            }

            #switched

            #velocity_variables

            #(#forwards)*
        }
    }
}

/// What the scalar that a mechanism is converted to is called.
pub(super) fn other_scalar(mechanism: &str) -> Ident {
    ident(if mechanism == "T" { "U" } else { "T" })
}

/// How activities are read and changed, if there are any.
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

/// The trait's function, which calls the inherent one of the same name.
pub(super) fn forward(model: &Model, kernel: &Kernel, path: &TokenStream) -> TokenStream {
    let function = format_ident!("{}", kernel.name);
    let prepared_function = format_ident!("prepared_{}", kernel.name);
    let list = arguments(model, kernel.arguments);
    let names = argument_names(kernel.arguments);
    let returns = returned_array(model, kernel, path);
    let to_array = record_of(model, kernel).map(|_| quote! { .into() });
    match kernel.receiver {
        Receiver::Mechanism if kernel.name == "input_values" => quote! {
            fn held_inputs(&self #(, #list)*) -> Self::Inputs {
                self.#function(#(#names),*).map(#path::Input::Held)
            }
        },
        Receiver::Mechanism => quote! {
            #[inline(always)]
            fn #function(&self #(, #list)*) -> #returns {
                self.#function(#(#names),*) #to_array
            }
        },
        Receiver::Prepared if ["dynamics", "kinematics", "speed_dynamics"].contains(&kernel.name) => quote! {
            #[inline(always)]
            fn #prepared_function(prepared: &Self::Prepared #(, #list)*) -> #returns {
                prepared.#function(#(#names),*)
            }
        },
        Receiver::Prepared => quote! {
            #[inline(always)]
            fn #function(&self #(, #list)*) -> #returns {
                self.prepare().#function(#(#names),*)
            }
        },
    }
}
