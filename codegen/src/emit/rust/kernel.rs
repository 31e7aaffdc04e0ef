//! Each program as a method of the mechanism.

use super::concrete::{Concrete, vector};
use super::function::{Function, is_apart};
use super::names::{argument_names, output_rates_name, outputs_name, prepared_name};
use super::record::record_type;
use super::{ident, size, table_constant};
use crate::dynamics::EquationsOfMotion;
use crate::kernel_id::{Argument, Associated, KernelId, Receiver, Record, Type};
use crate::model::Model;
use crate::program::{Columns, Kernel, LookUp, Name, Piece, Program, Results, Statement, Tree};
use proc_macro2::{Delimiter, Group, Ident, Literal, TokenStream};
use quote::{ToTokens, format_ident, quote};

/// All kernels, as methods of the mechanism and of what is prepared from its parameters.
pub(super) fn kernels(
    equations: &EquationsOfMotion,
    program: &Program,
    concrete: &Concrete,
    path: &TokenStream,
) -> TokenStream {
    let EquationsOfMotion { model, graph, .. } = equations;
    let (name, prepared) = (ident(&model.name), prepared_name(model));
    let of = |receiver| program.kernels.iter().filter(move |kernel| kernel.id.signature().receiver == receiver);
    let functions = of(Receiver::Mechanism).map(|kernel| function(equations, kernel, concrete, path));
    let prepared_functions = of(Receiver::Prepared).map(|kernel| function(equations, kernel, concrete, path));
    let tables = table_constant::tables(graph, path);
    let shortcuts = of(Receiver::Prepared).map(|kernel| shortcut(model, kernel, concrete));
    let constants = (!graph.tables().is_empty()).then(|| quote! { non_upper_case_globals, });
    let allowed =
        quote! { #[allow(non_snake_case, #constants unused_variables, unused_parens, clippy::all, clippy::pedantic)] };
    quote! {
        #allowed
        impl<S: #path::Scalar> #name<S> { #tables #(#functions)* #(#shortcuts)* }

        #allowed
        impl<S: #path::Scalar> #prepared<S> { #(#prepared_functions)* }
    }
}

fn function(equations: &EquationsOfMotion, kernel: &Kernel, concrete: &Concrete, path: &TokenStream) -> TokenStream {
    let model = &equations.model;
    let docs = format!("{}\n\nOperations: {}.", kernel.docs, kernel.operations);
    let docs = docs.lines().map(|line| format!(" {line}"));
    let statements = kernel.statements.iter().map(|each| statement(equations, each, path));
    let body = [entries(kernel), calls(kernel)].into_iter().chain(statements).chain([results(model, kernel, path)]);
    let inline = inline(kernel);
    let pieces =
        kernel.pieces.iter().enumerate().map(|(i, piece)| piece_function(equations, kernel, i, piece, concrete, path));
    let function = Function {
        name: ident(kernel.id.name()),
        of: receiver(model, kernel),
        arguments: kernel.id.signature().arguments,
        is_part: !kernel.pieces.is_empty(),
        found: None,
        returns: returns(model, kernel, concrete),
        body: &braces(body),
    };
    let public = quote! { pub };
    let function =
        if is_apart(kernel) { function.apart(&public, concrete, path) } else { function.plain(&public, concrete) };
    quote! {
        #(#pieces)*

        #(#[doc = #docs])*
        #inline
        #function
    }
}

/// What a kernel is a method of.
fn receiver(model: &Model, kernel: &Kernel) -> Ident {
    match kernel.id.signature().receiver {
        Receiver::Mechanism => ident(&model.name),
        Receiver::Prepared => prepared_name(model),
    }
}

/// Tokens in braces, without copying.
fn braces(words: impl Iterator<Item = TokenStream>) -> Group {
    Group::new(Delimiter::Brace, words.collect())
}

fn piece_name(kernel: &Kernel, i: usize) -> Ident {
    format_ident!("{}_part_{}", kernel.id.name(), i + 1)
}

/// A part of a long kernel: from the results of the parts before to the values that later parts need.
fn piece_function(
    equations: &EquationsOfMotion,
    kernel: &Kernel,
    i: usize,
    piece: &Piece,
    concrete: &Concrete,
    path: &TokenStream,
) -> TokenStream {
    let statements = piece.statements.iter().map(|each| statement(equations, each, path));
    let given = piece.given.iter().map(|name| ident(name));
    let unpacked = (!piece.given.is_empty()).then(|| quote! { let [#(#given),*] = *found; });
    let handed_on = piece.handed_on.iter().map(|name| ident(name));
    let handed_on = quote! { [#(#handed_on),*] };
    let body = braces([entries(kernel)].into_iter().chain(unpacked).chain(statements).chain([handed_on]));
    let function = Function {
        name: piece_name(kernel, i),
        of: receiver(&equations.model, kernel),
        arguments: kernel.id.signature().arguments,
        is_part: true,
        found: Some(piece.given.len()).filter(|len| *len > 0),
        returns: vector(piece.handed_on.len()),
        body: &body,
    };
    let function = function.apart(&TokenStream::new(), concrete, path);
    quote! {
        #[inline(never)]
        #function
    }
}

/// The parts of a long kernel in order, and their results by name.
fn calls(kernel: &Kernel) -> TokenStream {
    let mut calls = TokenStream::new();
    for (i, piece) in kernel.pieces.iter().enumerate() {
        let name = piece_name(kernel, i);
        let mut arguments: Vec<TokenStream> =
            argument_names(kernel.id.signature().arguments).iter().map(ToTokens::to_token_stream).collect();
        if !piece.given.is_empty() {
            arguments.push(quote! { &found });
        }
        calls.extend(quote! { let found = self.#name(#(#arguments),*); });
    }
    if let Some(last) = kernel.pieces.last() {
        let names = last.handed_on.iter().map(|name| ident(name));
        calls.extend(quote! { let [#(#names),*] = found; });
    }
    calls
}

/// Unless it is long, the kernel for batches is compiled for the vector instructions of the function that inlines it.
fn inline(kernel: &Kernel) -> TokenStream {
    if kernel.id == KernelId::Dynamics && kernel.pieces.is_empty() {
        quote! { #[inline(always)] }
    } else {
        quote! { #[inline] }
    }
}

/// A kernel of what is prepared, for one call with given parameters.
fn shortcut(model: &Model, kernel: &Kernel, concrete: &Concrete) -> TokenStream {
    let name = ident(kernel.id.name());
    let arguments = kernel.id.signature().arguments;
    let (list, names) = (concrete.arguments(arguments), argument_names(arguments));
    let returns = returns(model, kernel, concrete);
    let prepared = prepared_name(model);
    let docs =
        format!(" [`{prepared}::{name}`] once; for many calls with the same parameters [`Self::prepare`] first.");
    quote! {
        #[doc = #docs]
        #[inline]
        pub fn #name(&self #(, #list)*) -> #returns {
            self.prepare().#name(#(#names),*)
        }
    }
}

/// Names for the entries of the arguments.
fn entries(kernel: &Kernel) -> TokenStream {
    let e = &kernel.entries;
    let levels = [
        (Argument::Positions, &e.positions),
        (Argument::Speeds, &e.speeds),
        (Argument::Accelerations, &e.accelerations),
        (Argument::Multipliers, &e.multipliers),
        (Argument::GeneralizedSpeeds, &e.generalized_speeds),
    ];
    let bindings =
        levels.into_iter().filter(|(_, names)| names.iter().any(Option::is_some)).map(|(argument, names)| {
            let array = ident(argument.name());
            let names = names.iter().map(pattern);
            quote! { let [#(#names),*] = *#array; }
        });
    quote! { #(#bindings)* }
}

/// The binding of a value; none if it has no name.
fn pattern(name: &Option<Name>) -> Ident {
    ident(name.as_deref().unwrap_or("_"))
}

fn statement(equations: &EquationsOfMotion, statement: &Statement, path: &TokenStream) -> TokenStream {
    match statement {
        Statement::Let { name, value } => {
            let name = ident(name);
            quote! { let #name = #value; }
        }
        Statement::SinCos(waves) => {
            let sines = waves.iter().map(|wave| pattern(&wave.sin));
            let cosines = waves.iter().map(|wave| pattern(&wave.cos));
            let angles = waves.iter().map(|wave| &wave.argument);
            quote! { let ([#(#sines),*], [#(#cosines),*]) = S::sin_cos_each([#(#angles),*]); }
        }
        Statement::Table(LookUp { table, names, argument }) => {
            let names = names.iter().map(pattern);
            let mechanism = ident(&equations.model.name);
            let table = table_constant::constant(&equations.graph.table(*table).name);
            quote! { let [#(#names),*] = #mechanism::<S>::#table.at(#argument); }
        }
        Statement::Columns(solved) => columns(solved, path),
    }
}

/// A system solved for many right-hand sides.
fn columns(columns: &Columns, path: &TokenStream) -> TokenStream {
    let Columns { shape, inverses, entries, right_hand_sides, names } = columns;
    let steps = shape.steps.iter().map(|step| {
        let (unknown, blocks) = (size(step.unknown), Literal::u64_unsuffixed(step.blocks));
        let rows = step.rows.iter().map(|row| size(*row));
        quote! { #path::ColumnsStep { unknown: #unknown, rows: &[#(#rows),*], blocks: #blocks } }
    });
    let names = names.iter().map(|row| {
        let row = row.iter().map(pattern);
        quote! { [#(#row),*] }
    });
    let (inverses, entries, right_hand_sides) = (row(inverses), row(entries), matrix(right_hand_sides));
    quote! {
        let [#(#names),*] = {
            let (inverses, entries, mut columns) = (#inverses, #entries, #right_hand_sides);
            #path::solve_columns(&[#(#steps),*], &inverses, &entries, &mut columns);
            columns
        };
    }
}

fn row(entries: &[Tree]) -> TokenStream {
    quote! { [#(#entries),*] }
}

fn matrix(rows: &[Vec<Tree>]) -> TokenStream {
    let rows = rows.iter().map(|entries| row(entries));
    quote! { [#(#rows),*] }
}

/// A matrix by its entries that are not always 0.
fn sparse(shape: [usize; 2], entries: &[([usize; 2], Tree)]) -> TokenStream {
    let [rows, columns] = shape.map(size);
    let len = size(entries.len());
    let places = entries.iter().map(|(place, _)| {
        let [i, j] = place.map(size);
        quote! { [#i, #j] }
    });
    // Entries come first, as they may use names that the rest would hide.
    let entries = entries.iter().map(|(_, entry)| entry);
    quote! {
        {
            let entries = [#(#entries),*];
            let places: [[::core::primitive::usize; 2]; #len] = [#(#places),*];
            let mut matrix = [[S::from_f64(0.0); #columns]; #rows];
            for (entry, [i, j]) in entries.into_iter().zip(places) {
                matrix[i][j] = entry;
            }
            matrix
        }
    }
}

/// What a kernel returns: a struct with named fields where there is one, and numbers for inputs.
fn returns(model: &Model, kernel: &Kernel, concrete: &Concrete) -> TokenStream {
    match (record_of(model, kernel.id), &kernel.results) {
        (Some(record), Results::Vector(entries)) => record_type(&record, entries.len()),
        (None, Results::Vector(entries)) => vector(entries.len()),
        _ => concrete.of_type(&kernel.id.signature().result),
    }
}

/// The struct that a kernel returns instead of an array.
pub(super) fn record_of(model: &Model, kernel: KernelId) -> Option<Ident> {
    match kernel.signature().result {
        Type::Associated(Associated::Outputs) => Some(outputs_name(model)),
        Type::Associated(Associated::OutputRates) => Some(output_rates_name(model)),
        Type::Scalar | Type::Associated(_) | Type::Record(..) => None,
    }
}

fn results(model: &Model, kernel: &Kernel, path: &TokenStream) -> TokenStream {
    let returned = returned(model, &kernel.results, path);
    match &kernel.results {
        Results::Vector(entries) if record_of(model, kernel.id).is_some() && !entries.is_empty() => {
            quote! { #returned.into() }
        }
        _ => returned,
    }
}

fn returned(model: &Model, results: &Results<Tree>, path: &TokenStream) -> TokenStream {
    match results {
        Results::Scalar(value) => value.to_token_stream(),
        Results::Vector(entries) => row(entries),
        Results::Matrix(_, rows) => matrix(rows),
        Results::Sparse(size, entries) => sparse(*size, entries),
        Results::Refused(pivots) => refused(pivots.as_deref(), path),
        Results::Record(record, fields) => {
            let name = match record {
                Record::Prepared => prepared_name(model).into_token_stream(),
                _ => {
                    let name = format_ident!("{record:?}");
                    quote! { #path::#name }
                }
            };
            let inputs = match record {
                Record::Prepared => model.inputs.iter().map(|input| ident(&input.name)).collect(),
                _ => vec![],
            };
            let is_empty = fields.is_empty() && inputs.is_empty();
            let marker = is_empty.then(|| quote! { scalar: ::core::marker::PhantomData });
            let fields = fields.iter().flat_map(|(name, field)| {
                let name = ident(name);
                [quote! { #name: }, returned(model, field, path), quote! { , }]
            });
            let fields = braces(fields.chain([quote! { #(#inputs: self.#inputs,)* #marker }]));
            quote! { #name #fields }
        }
    }
}

fn refused(pivots: Option<&[(Tree, Tree)]>, path: &TokenStream) -> TokenStream {
    let pivots = match pivots {
        None => return quote! { S::not(<S::Mask as #path::Mask>::NONE) },
        Some([]) => return quote! { <S::Mask as #path::Mask>::NONE },
        Some(pivots) => pivots,
    };
    let checks = pivots.iter().map(|(pivot, terms)| quote! { #path::pivot_is_refused(#pivot, #terms) });
    quote! { #(#checks)|* }
}
