//! The description of the mechanism, as a constant.

use super::size;
use super::table_constant::constant;
use crate::description::{
    Conditional, Coordinate, Description, Event, Figure, Quantity, RunDefault, Shape, SparseRow, Step, Switching,
    Target,
};
use proc_macro2::TokenStream;
use quote::quote;

pub(super) fn description(description: &Description, path: &TokenStream) -> TokenStream {
    let quantities = |all: &[Quantity]| all.iter().map(|each| quantity(each, path)).collect::<Vec<_>>();
    let Description { name, type_name, docs, source, mixes_lengths, optional_kernels, .. } = description;
    let (declaration, declaration_hash) = (&source.text, &source.hash);
    let coordinates = description.coordinates.iter().map(|c| coordinate(c, path));
    let parameters = quantities(&description.parameters);
    let inputs = quantities(&description.inputs);
    let constraints = quantities(&description.constraints);
    let outputs = quantities(&description.outputs);
    let sizes = |all: &[usize]| all.iter().copied().map(size).collect::<Vec<_>>();
    let speed_constraints = sizes(&description.speed_constraints);
    let norm_constraints = sizes(&description.norm_constraints);
    let rated = sizes(&description.rated_outputs);
    let sparsity = description.sparsity.iter().map(|row| sparse_row(row, path));
    let common_column = match description.common_column.map(size) {
        Some(column) => quote! { ::core::option::Option::Some(#column) },
        None => quote! { ::core::option::Option::None },
    };
    let conditionals = description.conditionals.iter().map(|c| conditional(c, path));
    let events = description.events.iter().map(|each| event(each, path));
    let figures = description.figures.iter().map(|each| figure(each, path));
    let drawing = description.drawing.iter().map(|each| shape(*each, path));
    let run = description.run.iter().map(|each| run_default(each, path));
    let switchings = |all: &[Switching]| all.iter().map(|each| switching(each, path)).collect::<Vec<_>>();
    let (switching, load_conditions) = (switchings(&description.switching), switchings(&description.load_conditions));
    let dimension = size(description.dimension);
    quote! {
        #path::Description {
            name: #name,
            type_name: #type_name,
            docs: #docs,
            declaration: #declaration,
            declaration_hash: #declaration_hash,
            coordinates: &[#(#coordinates),*],
            mixes_lengths: #mixes_lengths,
            parameters: &[#(#parameters),*],
            inputs: &[#(#inputs),*],
            constraints: &[#(#constraints),*],
            speed_constraints: &[#(#speed_constraints),*],
            norm_constraints: &[#(#norm_constraints),*],
            sparsity: &[#(#sparsity),*],
            common_column: #common_column,
            conditionals: &[#(#conditionals),*],
            events: &[#(#events),*],
            outputs: &[#(#outputs),*],
            rated_outputs: &[#(#rated),*],
            figures: &[#(#figures),*],
            optional_kernels: &[#(#optional_kernels),*],
            dimension: #dimension,
            drawing: &[#(#drawing),*],
            run: &[#(#run),*],
            switching: &[#(#switching),*],
            load_conditions: &[#(#load_conditions),*],
        }
    }
}

fn switching(each: &Switching, path: &TokenStream) -> TokenStream {
    let table = match &each.table {
        Some(table) => {
            let constant = constant(&table.name);
            quote! { ::core::option::Option::Some(&Self::#constant) }
        }
        None => quote! { ::core::option::Option::None },
    };
    let (Switching { is_affine, .. }, kind) = (each, super::ident(&format!("{:?}", each.kind)));
    quote! {
        #path::Switching { table: #table, is_affine: #is_affine, kind: #path::SwitchingKind::#kind }
    }
}

/// A coordinate with its speed and acceleration, and how it starts.
fn coordinate(c: &Coordinate, path: &TokenStream) -> TokenStream {
    let [position, speed, acceleration] = [&c.position, &c.speed, &c.acceleration].map(|each| quantity(each, path));
    let (start, speed_given) = (super::ident(&format!("{:?}", c.start)), c.speed_given);
    quote! {
        #path::Coordinate {
            position: #position, speed: #speed, acceleration: #acceleration, start: #path::Start::#start, speed_given: #speed_given,
        }
    }
}

/// A named quantity.
pub(super) fn quantity(quantity: &Quantity, path: &TokenStream) -> TokenStream {
    let Quantity { name, unit, factor, is_length, docs } = quantity;
    quote! { #path::Quantity { name: #name, unit: #unit, factor: #factor, is_length: #is_length, docs: #docs } }
}

/// A row of the constraint Jacobian's pattern.
fn sparse_row(row: &SparseRow, path: &TokenStream) -> TokenStream {
    let columns = row.columns.iter().copied().map(size);
    let [constraint, first, part] = [row.constraint, row.first, row.part].map(size);
    let [entries, diagonal] = [row.entries, row.diagonal].map(size);
    quote! {
        #path::SparseRow { constraint: #constraint, columns: &[#(#columns),*], entries: #entries, first: #first, part: #part, diagonal: #diagonal }
    }
}

fn conditional(c: &Conditional, path: &TokenStream) -> TokenStream {
    let (name, first, len, active) = (&c.name, size(c.first_row), size(c.rows), c.initially_active);
    quote! { #path::event::Conditional { name: #name, first_row: #first, rows: #len, initially_active: #active } }
}

fn run_default(default: &RunDefault, path: &TokenStream) -> TokenStream {
    let RunDefault { option, value } = default;
    quote! { #path::RunDefault { option: #option, value: #value } }
}

fn figure(figure: &Figure, path: &TokenStream) -> TokenStream {
    let (name, title, len) = (&figure.name, &figure.title, size(figure.len));
    quote! { #path::Figure { name: #name, title: #title, len: #len } }
}

fn shape(shape: Shape, path: &TokenStream) -> TokenStream {
    let shape = match shape {
        Shape::Line(points) => counted("Line", points),
        Shape::Curve(points) => counted("Curve", points),
        Shape::Ground(points) => counted("Ground", points),
        Shape::Points(points) => counted("Points", points),
        Shape::Trace(points) => counted("Trace", points),
        Shape::Spring => quote! { Spring },
        Shape::Damper => quote! { Damper },
        Shape::Slider => quote! { Slider },
        Shape::Circle => quote! { Circle },
    };
    quote! { #path::Shape::#shape }
}

/// An event with its actions.
fn event(event: &Event, path: &TokenStream) -> TokenStream {
    let Event { name, on_motion, on_forces, .. } = event;
    let direction = super::ident(&format!("{:?}", event.direction));
    let steps = event.steps.iter().map(|step| event_step(step, path));
    quote! {
        #path::event::Event {
            name: #name,
            direction: #path::event::Direction::#direction,
            on_motion: #on_motion,
            on_forces: #on_forces,
            steps: &[#(#steps),*],
        }
    }
}

fn event_step(step: &Step, path: &TokenStream) -> TokenStream {
    let step = match step {
        Step::Stop(after) => counted("Stop", *after),
        Step::Set(sets) => {
            let sets = sets.iter().map(|(target, value)| {
                let target = match target {
                    Target::Parameter(index) => counted("Parameter", *index),
                    Target::Position(index) => counted("Position", *index),
                    Target::Speed(index) => counted("Speed", *index),
                };
                let value = size(*value);
                quote! { #path::event::Assignment { target: #path::event::Target::#target, value: #value } }
            });
            quote! { Set(&[#(#sets),*]) }
        }
        Step::Switch(switches) => {
            let switches = switches.iter().map(|(index, active)| {
                let conditional = size(*index);
                quote! { #path::event::Switch { conditional: #conditional, active: #active } }
            });
            quote! { Switch(&[#(#switches),*]) }
        }
        Step::Impact(hits) => {
            let hits = hits.iter().map(|(index, restitution)| {
                let (conditional, restitution) = (size(*index), size(*restitution));
                quote! { #path::event::Hit { conditional: #conditional, restitution: #restitution } }
            });
            quote! { Impact(&[#(#hits),*]) }
        }
    };
    quote! { #path::event::Step::#step }
}

fn counted(shape: &str, points: usize) -> TokenStream {
    let (shape, points) = (super::ident(shape), size(points));
    quote! { #shape(#points) }
}
