//! Each program as a method of the mechanism.

use super::names::{output_rates_name, outputs_name, prepared_name};
use super::record::record_type;
use super::{ident, size, table};
use crate::model::Model;
use crate::program::{Arguments, Kernel, LookUp, Name, Piece, Program, Receiver, Record, Results, Statement, Tree};
use proc_macro2::{Delimiter, Group, Ident, TokenStream};
use quote::{ToTokens, format_ident, quote};

/// All kernels, as methods of the mechanism and of what is prepared from its parameters.
pub(super) fn kernels(model: &Model, program: &Program, path: &TokenStream) -> TokenStream {
    let (name, prepared) = (ident(&model.name), prepared_name(model));
    let of = |receiver: Receiver| program.kernels.iter().filter(move |kernel| kernel.receiver == receiver);
    let functions = of(Receiver::Mechanism).map(|kernel| function(model, kernel, path));
    let prepared_functions = of(Receiver::Prepared).map(|kernel| function(model, kernel, path));
    let tables = table::tables(model, path);
    let shortcuts = of(Receiver::Prepared).map(|kernel| shortcut(model, kernel, path));
    let constants = (!model.graph.tables().is_empty()).then(|| quote! { non_upper_case_globals, });
    let allowed =
        quote! { #[allow(non_snake_case, #constants unused_variables, unused_parens, clippy::all, clippy::pedantic)] };
    quote! {
        #allowed
        impl<S: #path::Scalar> #name<S> { #tables #(#functions)* #(#shortcuts)* }

        #allowed
        impl<S: #path::Scalar> #prepared<S> { #(#prepared_functions)* }
    }
}

fn function(model: &Model, kernel: &Kernel, path: &TokenStream) -> TokenStream {
    let name = format_ident!("{}", kernel.name);
    let docs = format!("{}\n\nOperations: {}.", kernel.docs, kernel.operations);
    let docs = docs.lines().map(|line| format!(" {line}"));
    let arguments = arguments(model, kernel.arguments);
    let returns = returns(model, kernel, path);
    let statements = kernel.statements.iter().map(|each| statement(model, each));
    let body = [entries(kernel), calls(kernel)].into_iter().chain(statements).chain([results(model, kernel, path)]);
    let body = braces(body);
    let inline = inline(kernel);
    let pieces = kernel.pieces.iter().enumerate().map(|(i, piece)| piece_function(model, kernel, i, piece));
    quote! {
        #(#pieces)*

        #(#[doc = #docs])*
        #inline
        pub fn #name(&self #(, #arguments)*) -> #returns #body
    }
}

/// Tokens in braces, without copying.
fn braces(words: impl Iterator<Item = TokenStream>) -> Group {
    Group::new(Delimiter::Brace, words.collect())
}

fn piece_name(kernel: &Kernel, i: usize) -> Ident {
    format_ident!("{}_part_{}", kernel.name, i + 1)
}

/// A part of a long kernel: from the results of the parts before to the values that later parts need.
fn piece_function(model: &Model, kernel: &Kernel, i: usize, piece: &Piece) -> TokenStream {
    let name = piece_name(kernel, i);
    let mut arguments = arguments(model, kernel.arguments);
    let mut unpacked = None;
    if !piece.given.is_empty() {
        let (len, names) = (size(piece.given.len()), piece.given.iter().map(|name| ident(name)));
        arguments.push(quote! { found: &[S; #len] });
        unpacked = Some(quote! { let [#(#names),*] = *found; });
    }
    let statements = piece.statements.iter().map(|each| statement(model, each));
    let (len, handed_on) = (size(piece.handed_on.len()), piece.handed_on.iter().map(|name| ident(name)));
    let handed_on = quote! { [#(#handed_on),*] };
    let body = braces([entries(kernel)].into_iter().chain(unpacked).chain(statements).chain([handed_on]));
    quote! {
        #[inline(never)]
        fn #name(&self #(, #arguments)*) -> [S; #len] #body
    }
}

/// The parts of a long kernel in order, and their results by name.
fn calls(kernel: &Kernel) -> TokenStream {
    let mut calls = TokenStream::new();
    for (i, piece) in kernel.pieces.iter().enumerate() {
        let name = piece_name(kernel, i);
        let mut arguments: Vec<TokenStream> =
            argument_names(kernel.arguments).iter().map(ToTokens::to_token_stream).collect();
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
    if kernel.name == "dynamics" && kernel.pieces.is_empty() {
        quote! { #[inline(always)] }
    } else {
        quote! { #[inline] }
    }
}

/// A kernel of what is prepared, for one call with given parameters.
fn shortcut(model: &Model, kernel: &Kernel, path: &TokenStream) -> TokenStream {
    let name = format_ident!("{}", kernel.name);
    let list = arguments(model, kernel.arguments);
    let names = argument_names(kernel.arguments);
    let returns = returns(model, kernel, path);
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

/// `t, q, ..`
pub(super) fn argument_names(arguments: Arguments) -> Vec<Ident> {
    names(arguments).iter().map(|name| ident(name)).collect()
}

fn names(arguments: Arguments) -> &'static [&'static str] {
    match arguments {
        Arguments::Parameters => &[],
        Arguments::Positions => &["t", "q"],
        Arguments::Speeds => &["t", "q", "qd"],
        Arguments::Accelerations => &["t", "q", "qd", "qdd"],
        Arguments::Multipliers => &["t", "q", "qd", "qdd", "lambda"],
        Arguments::GeneralizedSpeeds => &["t", "q", "u"],
    }
}

/// `t: S, q: &[S; n], ..`
pub(super) fn arguments(model: &Model, arguments: Arguments) -> Vec<TokenStream> {
    let argument = |name: &&str| {
        let len = match *name {
            "t" => return quote! { t: S },
            "lambda" => model.constraints.len(),
            "u" => model.speeds.len(),
            _ => model.coordinates.len(),
        };
        let (name, len) = (ident(name), size(len));
        quote! { #name: &[S; #len] }
    };
    names(arguments).iter().map(argument).collect()
}

/// Names for the entries of the arguments.
fn entries(kernel: &Kernel) -> TokenStream {
    let e = &kernel.entries;
    let levels = [
        ("q", &e.positions),
        ("qd", &e.speeds),
        ("qdd", &e.accelerations),
        ("lambda", &e.multipliers),
        ("u", &e.generalized_speeds),
    ];
    let bindings = levels.into_iter().filter(|(_, names)| names.iter().any(Option::is_some)).map(|(array, names)| {
        let array = ident(array);
        let names = names.iter().map(pattern);
        quote! { let [#(#names),*] = *#array; }
    });
    quote! { #(#bindings)* }
}

/// The binding of a value; none if it has no name.
fn pattern(name: &Option<Name>) -> Ident {
    ident(name.as_deref().unwrap_or("_"))
}

fn statement(model: &Model, statement: &Statement) -> TokenStream {
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
            let mechanism = ident(&model.name);
            let table = table::constant(&model.graph.table(*table).name);
            quote! { let [#(#names),*] = #mechanism::<S>::#table.at(#argument); }
        }
    }
}

fn vector(entries: &[Tree]) -> TokenStream {
    quote! { [#(#entries),*] }
}

fn matrix(rows: &[Vec<Tree>]) -> TokenStream {
    let rows = rows.iter().map(|row| vector(row));
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

/// The type that a kernel returns: a struct with named fields if there is one.
fn returns(model: &Model, kernel: &Kernel, path: &TokenStream) -> TokenStream {
    match (record_of(model, kernel), &kernel.results) {
        (Some(record), Results::Vector(entries)) => record_type(&record, entries.len()),
        _ => returned_array(model, kernel, path),
    }
}

/// The return type of the trait's function of that name.
pub(super) fn returned_array(model: &Model, kernel: &Kernel, path: &TokenStream) -> TokenStream {
    let [n, m, p] = [model.coordinates.len(), model.constraints.len(), model.parameters.len()].map(size);
    match &kernel.results {
        Results::Scalar(_) => quote! { S },
        Results::Vector(entries) => {
            let len = size(entries.len());
            quote! { [S; #len] }
        }
        Results::Matrix(columns, rows) => {
            let (columns, rows) = (size(*columns), size(rows.len()));
            quote! { [[S; #columns]; #rows] }
        }
        Results::Record(record, fields) => match record {
            Record::Initial => quote! { #path::Initial<[S; #n]> },
            Record::ConstraintLinearization => {
                let jacobian = match fields.iter().find(|(name, _)| name == "jacobian") {
                    Some((_, Results::Vector(entries))) => {
                        let len = size(entries.len());
                        quote! { [S; #len] }
                    }
                    _ => quote! { [[S; #n]; #m] },
                };
                quote! { #path::ConstraintLinearization<[S; #m], #jacobian> }
            }
            Record::Dynamics => quote! { #path::Dynamics<S, [S; #n], [S; #m]> },
            Record::DynamicsJacobian => quote! { #path::DynamicsJacobian<S, [[S; #n]; #n], [[S; #n]; #m]> },
            Record::DynamicsSensitivity => quote! { #path::DynamicsSensitivity<S, [[S; #p]; #n], [[S; #p]; #m]> },
            Record::Kinematics => quote! { #path::Kinematics<S, [S; #n]> },
            Record::SpeedDynamics => {
                let [k, r] = [model.speeds.len(), model.constraints.len() - model.satisfied_rows().len()].map(size);
                quote! { #path::SpeedDynamics<S, [S; #k], [S; #r]> }
            }
            Record::Prepared => {
                let prepared = prepared_name(model);
                quote! { #prepared<S> }
            }
        },
        Results::Sparse(size, _) => {
            let [rows, columns] = size.map(super::size);
            quote! { [[S; #columns]; #rows] }
        }
        Results::Refused(_) => quote! { S::Mask },
    }
}

/// The struct that a kernel returns instead of an array.
pub(super) fn record_of(model: &Model, kernel: &Kernel) -> Option<Ident> {
    match kernel.name {
        "outputs" => Some(outputs_name(model)),
        "output_rates" => Some(output_rates_name(model)),
        _ => None,
    }
}

fn results(model: &Model, kernel: &Kernel, path: &TokenStream) -> TokenStream {
    let returned = returned(model, &kernel.results, path);
    match &kernel.results {
        Results::Vector(entries) if record_of(model, kernel).is_some() && !entries.is_empty() => {
            quote! { #returned.into() }
        }
        _ => returned,
    }
}

fn returned(model: &Model, results: &Results<Tree>, path: &TokenStream) -> TokenStream {
    match results {
        Results::Scalar(value) => value.to_token_stream(),
        Results::Vector(entries) => vector(entries),
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
