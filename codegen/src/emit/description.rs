//! What the mechanism says of itself.

use super::{kebab_case, size};
use crate::dynamics::EquationsOfMotion;
use crate::model::{Level, Shape, Start, Unit};
use proc_macro2::TokenStream;
use quote::quote;

pub(super) fn description(equations: &EquationsOfMotion, declaration: &str, path: &TokenStream) -> TokenStream {
    let model = &equations.model;
    let quantity = |name: &str, unit: &Unit, docs: &str| {
        let (text, factor) = (unit.text(), unit.factor());
        quote! { #path::Quantity { name: #name, unit: #text, factor: #factor, docs: #docs } }
    };
    let (name, type_name, docs) = (kebab_case(&model.name), &model.name, &model.docs);
    let coordinates = model.coordinates.iter().map(|c| {
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
    });
    let parameters = model.parameters.iter().map(|p| quantity(&p.name, &p.unit, &p.docs));
    let constraints = model.constraints.iter().map(|c| quantity(&c.name, &c.unit, ""));
    let between_speeds = model.constraints.iter().enumerate().filter(|(_, c)| c.level == Level::Speeds);
    let speed_constraints = between_speeds.map(|(i, _)| size(i));
    let events = model.events.iter().map(|event| &event.name);
    let outputs = model.outputs.iter().map(|o| quantity(&o.name, &o.unit, &o.docs));
    let rated = equations.outputs.rated().into_iter().map(size);
    let figures = model.groups.iter().map(|group| {
        let (name, title, len) = (&group.name, &group.title, size(group.len));
        quote! { #path::Figure { name: #name, title: #title, len: #len } }
    });
    let drawing = model.drawing.iter().map(|shape| {
        let shape = match shape {
            Shape::Line(points) => counted("Line", points.len()),
            Shape::Ground(points) => counted("Ground", points.len()),
            Shape::Points(points) => counted("Points", points.len()),
            Shape::Slider(..) => quote! { Slider },
            Shape::Circle(..) => quote! { Circle },
        };
        quote! { #path::Shape::#shape }
    });
    quote! {
        #path::Description {
            name: #name,
            type_name: #type_name,
            docs: #docs,
            declaration: #declaration,
            coordinates: &[#(#coordinates),*],
            parameters: &[#(#parameters),*],
            constraints: &[#(#constraints),*],
            speed_constraints: &[#(#speed_constraints),*],
            events: &[#(#events),*],
            outputs: &[#(#outputs),*],
            rated_outputs: &[#(#rated),*],
            figures: &[#(#figures),*],
            drawing: &[#(#drawing),*],
        }
    }
}

fn counted(shape: &str, points: usize) -> TokenStream {
    let (shape, points) = (super::ident(shape), size(points));
    quote! { #shape(#points) }
}
