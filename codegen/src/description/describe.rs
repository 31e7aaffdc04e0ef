//! From equations and programs to the description.

use super::events::events;
use super::{Conditional, Coordinate, Description, Figure, NamedTable, Quantity, Shape, Start, Switching, kebab_case};
use crate::dsl::{Mark, Source};
use crate::dynamics::{self, EquationsOfMotion};
use crate::kernel_id::KernelId;
use crate::model::{self, Level, Model, Unit};
use crate::program::Program;
use crate::symbolic::TableId;

/// The description of a mechanism.
pub fn describe(equations: &EquationsOfMotion, program: &Program, source: &Source) -> Description {
    let model = &equations.model;
    let is_between_speeds = |row: &usize| model.constraints[*row].level == Level::Speeds;
    let is_made = |kernel: &KernelId| program.kernels.iter().any(|made| made.id == *kernel);
    Description {
        name: kebab_case(&model.name),
        type_name: model.name.clone(),
        docs: model.docs.clone(),
        source: source.clone(),
        coordinates: model.coordinates.iter().map(coordinate).collect(),
        mixes_lengths: mixes_lengths(model),
        parameters: model.parameters.iter().map(|p| Quantity::of(&p.name, &p.unit, &p.docs)).collect(),
        inputs: model.inputs.iter().map(|input| Quantity::of(&input.name, &input.unit, &input.docs)).collect(),
        constraints: model.constraints.iter().map(|c| Quantity::of(&c.name, &c.unit, "")).collect(),
        speed_constraints: (0..model.constraints.len()).filter(is_between_speeds).collect(),
        norm_constraints: model.norm_constraints.clone(),
        sparsity: program.sparsity.iter().flat_map(|sparsity| sparsity.rows.clone()).collect(),
        common_column: program.sparsity.as_ref().and_then(|sparsity| sparsity.common),
        conditionals: model.conditionals.iter().map(conditional).collect(),
        events: events(&model.events),
        outputs: model.outputs.iter().map(|o| Quantity::of(&o.name, &o.unit, &o.docs)).collect(),
        rated_outputs: equations.outputs.rated(),
        figures: model.groups.iter().map(figure).collect(),
        optional_kernels: KernelId::optional().filter(is_made).map(KernelId::name).collect(),
        dimension: model.dimension,
        drawing: model.drawing.iter().map(shape).collect(),
        run: model.run.clone(),
        switching: switching(equations, &equations.switching),
        load_conditions: switching(equations, &equations.load_conditions),
    }
}

fn switching(EquationsOfMotion { graph, .. }: &EquationsOfMotion, all: &[dynamics::Switching]) -> Vec<Switching> {
    let named = |id: TableId| NamedTable { index: id.index(), name: graph.table(id).name.clone() };
    let described = |each: &dynamics::Switching| {
        let dynamics::Switching { table, is_affine, kind, .. } = *each;
        Switching { table: table.map(named), is_affine, kind }
    };
    all.iter().map(described).collect()
}

impl Quantity {
    /// One by its name, unit and documentation.
    pub fn of(name: &str, unit: &Unit, docs: &str) -> Quantity {
        let (name, docs) = (name.to_owned(), docs.to_owned());
        Quantity { name, unit: unit.text().to_owned(), factor: unit.factor(), is_length: unit.is_length(), docs }
    }
}

/// Whether some coordinates are lengths and some are not.
fn mixes_lengths(model: &Model) -> bool {
    let lengths = model.coordinates.iter().filter(|c| c.unit.is_length()).count();
    0 < lengths && lengths < model.coordinates.len()
}

/// A coordinate with its speed and acceleration, and how it starts.
fn coordinate(c: &model::Coordinate) -> Coordinate {
    Coordinate {
        position: Quantity::of(&c.name, &c.unit, &c.docs),
        speed: Quantity::of(&format!("{}_dot", c.name), &c.unit.per_time(1), ""),
        acceleration: Quantity::of(&format!("{}_ddot", c.name), &c.unit.per_time(2), ""),
        start: match c.start {
            model::Start::Given(_) => Start::Given,
            model::Start::Guess(_) => Start::Guess,
            model::Start::Free => Start::Free,
        },
        speed_given: c.start_speed.is_some(),
    }
}

fn conditional(c: &model::Conditional) -> Conditional {
    let (first_row, rows) = (c.rows.start, c.rows.len());
    Conditional { name: c.name.clone(), first_row, rows, initially_active: c.initially_active }
}

fn figure(group: &model::OutputGroup) -> Figure {
    Figure { name: group.name.clone(), title: group.title.clone(), len: group.len }
}

/// A shape that is drawn, with how many points it has.
fn shape(shape: &model::Shape) -> Shape {
    match shape {
        model::Shape::Points(Mark::Line, points) => Shape::Line(points.len()),
        model::Shape::Points(Mark::Curve, points) => Shape::Curve(points.len()),
        model::Shape::Points(Mark::Spring, _) => Shape::Spring,
        model::Shape::Points(Mark::Damper, _) => Shape::Damper,
        model::Shape::Points(Mark::Ground, points) => Shape::Ground(points.len()),
        model::Shape::Points(Mark::Point, points) => Shape::Points(points.len()),
        model::Shape::Points(Mark::Trace, points) => Shape::Trace(points.len()),
        model::Shape::Slider(..) => Shape::Slider,
        model::Shape::Circle(..) => Shape::Circle,
    }
}
