//! The description of the mechanism.

use super::{kebab_case, size};
use crate::dsl::{Mark, Source};
use crate::dynamics::EquationsOfMotion;
use crate::kernel_id::KernelId;
use crate::model::{Coordinate, Dimension, Direction, Event, EventStep, Level, Model, Shape, Start, Target, Unit};
use crate::program::Program;
use proc_macro2::TokenStream;
use quote::quote;

pub(super) fn description(
    equations: &EquationsOfMotion,
    program: &Program,
    source: &Source,
    path: &TokenStream,
) -> TokenStream {
    let model = &equations.model;
    let quantity = |name: &str, unit: &Unit, docs: &str| quantity(name, unit, docs, path);
    let (name, type_name, docs) = (kebab_case(&model.name), &model.name, &model.docs);
    let Source { text: declaration, hash: declaration_hash } = source;
    let (coordinates, mixes_lengths) = (coordinates(model, path), mixes_lengths(model));
    let parameters = model.parameters.iter().map(|p| quantity(&p.name, &p.unit, &p.docs));
    let inputs = model.inputs.iter().map(|input| quantity(&input.name, &input.unit, &input.docs));
    let constraints = model.constraints.iter().map(|c| quantity(&c.name, &c.unit, ""));
    let between_speeds = model.constraints.iter().enumerate().filter(|(_, c)| c.level == Level::Speeds);
    let norm_constraints = model.norm_constraints.iter().copied().map(size);
    let sparsity = sparsity(program, path);
    let speed_constraints = between_speeds.map(|(i, _)| size(i));
    let conditionals = model.conditionals.iter().map(|c| {
        let (name, first, len, active) = (&c.name, size(c.rows.start), size(c.rows.len()), c.initially_active);
        quote! { #path::event::Conditional { name: #name, first_row: #first, rows: #len, initially_active: #active } }
    });
    let events = events(model, path);
    let outputs = model.outputs.iter().map(|o| quantity(&o.name, &o.unit, &o.docs));
    let rated = equations.outputs.rated().into_iter().map(size);
    let figures = model.groups.iter().map(|group| {
        let (name, title, len) = (&group.name, &group.title, size(group.len));
        quote! { #path::Figure { name: #name, title: #title, len: #len } }
    });
    let drawing = drawing(model, path);
    let dimension = size(model.dimension);
    let is_made = |kernel: &KernelId| program.kernels.iter().any(|made| made.id == *kernel);
    let kernels = KernelId::optional().filter(is_made).map(KernelId::name);
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
            conditionals: &[#(#conditionals),*],
            events: &[#(#events),*],
            outputs: &[#(#outputs),*],
            rated_outputs: &[#(#rated),*],
            figures: &[#(#figures),*],
            optional_kernels: &[#(#kernels),*],
            dimension: #dimension,
            drawing: &[#(#drawing),*],
        }
    }
}

/// Whether some coordinates are lengths and some are not.
fn mixes_lengths(model: &Model) -> bool {
    let lengths = model.coordinates.iter().filter(|c| is_length(&c.unit)).count();
    0 < lengths && lengths < model.coordinates.len()
}

fn is_length(unit: &Unit) -> bool {
    *unit.dimension() == Dimension::length()
}

/// Coordinates with their speeds and accelerations, and how each starts.
fn coordinates(model: &Model, path: &TokenStream) -> Vec<TokenStream> {
    let quantity = |name: &str, unit: &Unit, docs: &str| quantity(name, unit, docs, path);
    let coordinate = |c: &Coordinate| {
        let position = quantity(&c.name, &c.unit, &c.docs);
        let speed = quantity(&format!("{}_dot", c.name), &c.unit.per_time(1), "");
        let acceleration = quantity(&format!("{}_ddot", c.name), &c.unit.per_time(2), "");
        let start = match c.start {
            Start::Given(_) => quote! { Given },
            Start::Guess(_) => quote! { Guess },
            Start::Free => quote! { Free },
        };
        let speed_given = c.start_speed.is_some();
        quote! {
            #path::Coordinate {
                position: #position, speed: #speed, acceleration: #acceleration, start: #path::Start::#start, speed_given: #speed_given,
            }
        }
    };
    model.coordinates.iter().map(coordinate).collect()
}

/// The pattern of the constraint Jacobian, row by row.
fn sparsity(program: &Program, path: &TokenStream) -> Vec<TokenStream> {
    let rows = program.sparsity.iter().flat_map(|sparsity| &sparsity.rows).map(|row| {
        let columns = row.columns.iter().copied().map(size);
        let [constraint, first, entries, diagonal] = [row.constraint, row.first, row.entries, row.diagonal].map(size);
        quote! {
            #path::SparseRow { constraint: #constraint, columns: &[#(#columns),*], entries: #entries, first: #first, diagonal: #diagonal }
        }
    });
    rows.collect()
}

/// The shapes that are drawn, with how many points each has.
fn drawing(model: &Model, path: &TokenStream) -> Vec<TokenStream> {
    let shapes = model.drawing.iter().map(|shape| {
        let shape = match shape {
            Shape::Points(Mark::Line, points) => counted("Line", points.len()),
            Shape::Points(Mark::Curve, points) => counted("Curve", points.len()),
            Shape::Points(Mark::Spring, _) => quote! { Spring },
            Shape::Points(Mark::Damper, _) => quote! { Damper },
            Shape::Points(Mark::Ground, points) => counted("Ground", points.len()),
            Shape::Points(Mark::Point, points) => counted("Points", points.len()),
            Shape::Points(Mark::Trace, points) => counted("Trace", points.len()),
            Shape::Slider(..) => quote! { Slider },
            Shape::Circle(..) => quote! { Circle },
        };
        quote! { #path::Shape::#shape }
    });
    shapes.collect()
}

/// A named quantity.
pub(super) fn quantity(name: &str, unit: &Unit, docs: &str, path: &TokenStream) -> TokenStream {
    let (text, factor, is_length) = (unit.text(), unit.factor(), is_length(unit));
    quote! { #path::Quantity { name: #name, unit: #text, factor: #factor, is_length: #is_length, docs: #docs } }
}

/// Events with their actions. The quantities that a step sets are numbered as in the kernel that computes them.
fn events(model: &Model, path: &TokenStream) -> Vec<TokenStream> {
    let mut values = 0..;
    let mut event = |event: &Event| {
        let (name, on_forces) = (&event.name, event.on_forces);
        let direction = match event.direction {
            None => quote! { Both },
            Some(Direction::Rising) => quote! { Rising },
            Some(Direction::Falling) => quote! { Falling },
        };
        let steps = event.steps.iter().map(|step| event_step(step, &mut values, path)).collect::<Vec<_>>();
        quote! {
            #path::event::Event {
                name: #name, direction: #path::event::Direction::#direction, on_forces: #on_forces, steps: &[#(#steps),*],
            }
        }
    };
    model.events.iter().map(&mut event).collect()
}

fn event_step(step: &EventStep, values: &mut impl Iterator<Item = usize>, path: &TokenStream) -> TokenStream {
    let mut value = || size(values.next().unwrap_or_default());
    let step = match step {
        EventStep::Stop(after) => counted("Stop", *after),
        EventStep::Set(sets) => {
            let sets = sets.iter().map(|(target, _)| {
                let target = match target {
                    Target::Parameter(index) => counted("Parameter", *index),
                    Target::Position(index) => counted("Position", *index),
                    Target::Speed(index) => counted("Speed", *index),
                };
                let value = value();
                quote! { #path::event::Assignment { target: #path::event::Target::#target, value: #value } }
            });
            quote! { Set(&[#(#sets),*]) }
        }
        EventStep::Switch(switches) => {
            let switches = switches.iter().map(|(index, active)| {
                let conditional = size(*index);
                quote! { #path::event::Switch { conditional: #conditional, active: #active } }
            });
            quote! { Switch(&[#(#switches),*]) }
        }
        EventStep::Impact(hits) => {
            let hits = hits.iter().map(|(index, _)| {
                let (conditional, restitution) = (size(*index), value());
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
