//! The types of the runtime's traits as arrays of this mechanism's sizes.

use super::names::prepared_name;
use super::{ident, size};
use crate::dynamics::EquationsOfMotion;
use crate::kernel_id::{Argument, Arguments, Associated, KernelId, Trait, Type};
use crate::program::{Program, Results, Sparsity, Tree};
use proc_macro2::TokenStream;
use quote::{format_ident, quote};

/// How many of each thing there are.
#[derive(Default)]
struct Sizes {
    coordinates: usize,
    constraints: usize,
    parameters: usize,
    inputs: usize,
    outputs: usize,
    output_rates: usize,
    events: usize,
    event_values: usize,
    switching_functions: usize,
    load_conditions: usize,
    conditionals: usize,
    drawing: usize,
    entries: usize,
    envelope: usize,
    generalized_speeds: usize,
    rows_left: usize,
    velocities: usize,
}

/// Writes types down.
pub(super) struct Concrete<'a> {
    sizes: Sizes,
    prepared: TokenStream,
    path: &'a TokenStream,
}

impl<'a> Concrete<'a> {
    /// The types of a mechanism.
    pub(super) fn of(equations: &EquationsOfMotion, program: &Program, path: &'a TokenStream) -> Concrete<'a> {
        let model = &equations.model;
        let [entries, envelope] = program.sparsity.as_ref().map_or([0; 2], Sparsity::sizes);
        let sizes = Sizes {
            coordinates: model.coordinates.len(),
            constraints: model.constraints.len(),
            parameters: model.parameters.len(),
            inputs: model.inputs.len(),
            outputs: model.outputs.len(),
            output_rates: equations.outputs.rated().len(),
            events: model.events.len(),
            event_values: vector_len(program, KernelId::EventValues),
            switching_functions: vector_len(program, KernelId::SwitchingFunctions),
            load_conditions: equations.load_conditions.len(),
            conditionals: model.conditionals.len(),
            drawing: vector_len(program, KernelId::Drawing),
            entries,
            envelope,
            generalized_speeds: model.generalized_speeds.len(),
            rows_left: equations.speeds.as_ref().map_or(0, |speeds| speeds.rows.len()),
            velocities: rows(program, KernelId::SpeedMassMatrix),
        };
        let prepared = prepared_name(model);
        Concrete { sizes, prepared: quote! { #prepared<S> }, path }
    }

    /// The types of a mechanism with nothing in it.
    pub(super) fn empty(path: &'a TokenStream) -> Concrete<'a> {
        Concrete { sizes: Sizes::default(), prepared: quote! { () }, path }
    }

    /// `type Q = [S; 2];` and so on, all that a trait's impl says but what the mechanism is on other numbers.
    pub(super) fn definitions(&self, of: Trait) -> TokenStream {
        let define = |associated: Associated| {
            let (name, is) = (format_ident!("{associated:?}"), self.associated(associated));
            quote! { type #name = #is; }
        };
        Associated::ALL.iter().copied().filter(|associated| associated.of() == of).map(define).collect()
    }

    /// A type of the trait.
    pub(super) fn of_type(&self, written: &Type) -> TokenStream {
        match written {
            Type::Scalar => quote! { S },
            Type::Associated(associated) => self.associated(*associated),
            Type::Record(record, arguments) => {
                let (path, name) = (self.path, format_ident!("{record:?}"));
                let arguments = arguments.iter().map(|argument| self.of_type(argument));
                quote! { #path::#name<#(#arguments),*> }
            }
        }
    }

    /// `t: S, q: &[S; n], ..`
    pub(super) fn arguments(&self, arguments: Arguments) -> Vec<TokenStream> {
        self.arguments_by(arguments, &quote! { & })
    }

    /// The same, vectors by such references.
    pub(super) fn arguments_by(&self, arguments: Arguments, reference: &TokenStream) -> Vec<TokenStream> {
        let argument = |argument: &Argument| {
            let name = ident(argument.name());
            match argument.vector() {
                None => quote! { #name: S },
                Some(vector) => {
                    let vector = self.associated(vector);
                    quote! { #name: #reference #vector }
                }
            }
        };
        arguments.list().iter().map(argument).collect()
    }

    fn associated(&self, associated: Associated) -> TokenStream {
        let s = &self.sizes;
        let (n, m, p) = (s.coordinates, s.constraints, s.parameters);
        match associated {
            Associated::Q => vector(n),
            Associated::L => vector(m),
            Associated::Z => vector(n + m),
            Associated::QQ => matrix(n, n),
            Associated::V => vector(s.velocities),
            Associated::VV => matrix(s.velocities, s.velocities),
            Associated::LQ => matrix(m, n),
            Associated::LL => matrix(m, m),
            Associated::ZZ => matrix(n + m, n + m),
            Associated::Entries => vector(s.entries),
            Associated::Envelope => vector(s.envelope),
            Associated::Parameters => vector(p),
            Associated::Outputs => vector(s.outputs),
            Associated::OutputRates => vector(s.output_rates),
            Associated::Events => vector(s.events),
            Associated::EventValues => vector(s.event_values),
            Associated::SwitchingFunctions => vector(s.switching_functions),
            Associated::LoadConditions => vector(s.load_conditions),
            Associated::Activities => vector(s.conditionals),
            Associated::Drawing => vector(s.drawing),
            Associated::QP => matrix(n, p),
            Associated::LP => matrix(m, p),
            Associated::Inputs => {
                let (path, len) = (self.path, size(s.inputs));
                quote! { [#path::Input<S>; #len] }
            }
            Associated::Prepared => self.prepared.clone(),
            Associated::U => vector(s.generalized_speeds),
            Associated::R => vector(s.rows_left),
        }
    }
}

/// `[S; len]`
pub(super) fn vector(len: usize) -> TokenStream {
    let len = size(len);
    quote! { [S; #len] }
}

fn matrix(rows: usize, columns: usize) -> TokenStream {
    let (rows, columns) = (size(rows), size(columns));
    quote! { [[S; #columns]; #rows] }
}

fn rows(program: &Program, kernel: KernelId) -> usize {
    match results(program, kernel) {
        Some(Results::Matrix(_, rows)) => rows.len(),
        _ => 0,
    }
}

fn results(program: &Program, kernel: KernelId) -> Option<&Results<Tree>> {
    program.kernels.iter().find(|found| found.id == kernel).map(|found| &found.results)
}

fn vector_len(program: &Program, kernel: KernelId) -> usize {
    match results(program, kernel) {
        Some(Results::Vector(entries)) => entries.len(),
        _ => 0,
    }
}
