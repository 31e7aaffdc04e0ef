//! Descriptions and tables that live as long as the program, as those of compiled mechanisms do.
//!
//! Everything that runs a mechanism lends its names for ever. So what a declaration tells of one is kept for ever too, some
//! kilobytes, once however often the same text is read.

use codegen::description as made;
use codegen::{Derived, symbolic};
use sim_kernel::event::{Assignment, Conditional, Direction, Event, Hit, Step, Switch, Target};
use sim_kernel::{
    Coordinate, Description, Figure, Quantity, RunDefault, Shape, SparseRow, Start, Switching, SwitchingKind, Table,
};
use std::collections::BTreeMap;
use std::sync::{Mutex, PoisonError};

/// What is kept of a declaration.
#[derive(Clone, Copy, Debug)]
pub(super) struct Kept {
    pub(super) description: &'static Description,
    pub(super) tables: &'static [Table],
    /// Where generalised speeds are declared, the constraints that they leave.
    pub(super) rows_left: Option<&'static [usize]>,
}

/// By the text of the declaration, which says all of it.
static KEPT: Mutex<BTreeMap<String, Kept>> = Mutex::new(BTreeMap::new());

/// What is kept of a declaration, from now on if not before.
pub(super) fn kept(derived: &Derived) -> Kept {
    let mut kept = KEPT.lock().unwrap_or_else(PoisonError::into_inner);
    let text = derived.description.source.text.clone();
    *kept.entry(text).or_insert_with(|| {
        let tables = each(derived.equations.graph.tables(), table);
        Kept {
            description: Box::leak(Box::new(description(&derived.description, tables))),
            tables,
            rows_left: derived.equations.speeds.as_ref().map(|speeds| &*speeds.rows.clone().leak()),
        }
    })
}

/// The description in the runtime's terms.
fn description(of: &made::Description, tables: &'static [Table]) -> Description {
    Description {
        name: text(&of.name),
        type_name: text(&of.type_name),
        docs: text(&of.docs),
        declaration: text(&of.source.text),
        declaration_hash: text(&of.source.hash),
        coordinates: each(&of.coordinates, coordinate),
        mixes_lengths: of.mixes_lengths,
        parameters: each(&of.parameters, quantity),
        inputs: each(&of.inputs, quantity),
        constraints: each(&of.constraints, quantity),
        speed_constraints: of.speed_constraints.clone().leak(),
        norm_constraints: of.norm_constraints.clone().leak(),
        sparsity: each(&of.sparsity, sparse_row),
        common_column: of.common_column,
        conditionals: each(&of.conditionals, conditional),
        events: each(&of.events, event),
        outputs: each(&of.outputs, quantity),
        rated_outputs: of.rated_outputs.clone().leak(),
        figures: each(&of.figures, |figure| Figure {
            name: text(&figure.name),
            title: text(&figure.title),
            len: figure.len,
        }),
        optional_kernels: of.optional_kernels.clone().leak(),
        dimension: of.dimension,
        drawing: each(&of.drawing, |shape| self::shape(*shape)),
        run: each(&of.run, |default| RunDefault { option: default.option, value: text(&default.value) }),
        switching: each(&of.switching, |switching| self::switching(switching, tables)),
        load_conditions: each(&of.load_conditions, |switching| self::switching(switching, tables)),
    }
}

fn switching(of: &made::Switching, tables: &'static [Table]) -> Switching {
    let made::Switching { ref table, is_affine, kind } = *of;
    let kind = match kind {
        made::SwitchingKind::Form => SwitchingKind::Form,
        made::SwitchingKind::Pole => SwitchingKind::Pole,
        made::SwitchingKind::Middle => SwitchingKind::Middle,
        made::SwitchingKind::Flank => SwitchingKind::Flank,
        made::SwitchingKind::Phase => SwitchingKind::Phase,
        made::SwitchingKind::Output => SwitchingKind::Output,
    };
    Switching { table: table.as_ref().map(|table| &tables[table.index]), is_affine, kind }
}

/// A table with its pieces, as generated code has it.
fn table(table: &symbolic::Table) -> Table {
    let piece = |(place, [c0, c1, c2, c3]): (usize, &[f64; 4])| [table.start(place), *c0, *c1, *c2, *c3];
    let pieces: Vec<[f64; 5]> = table.pieces.iter().enumerate().map(piece).collect();
    Table::new(table.knots.clone().leak(), pieces.leak(), table.period().unwrap_or(0.0))
}

fn text(text: &str) -> &'static str {
    text.to_owned().leak()
}

fn each<A, B>(all: &[A], f: impl Fn(&A) -> B) -> &'static [B] {
    all.iter().map(f).collect::<Vec<B>>().leak()
}

fn quantity(of: &made::Quantity) -> Quantity {
    let made::Quantity { name, unit, factor, is_length, docs } = of;
    Quantity { name: text(name), unit: text(unit), factor: *factor, is_length: *is_length, docs: text(docs) }
}

fn coordinate(of: &made::Coordinate) -> Coordinate {
    Coordinate {
        position: quantity(&of.position),
        speed: quantity(&of.speed),
        acceleration: quantity(&of.acceleration),
        start: match of.start {
            made::Start::Given => Start::Given,
            made::Start::Guess => Start::Guess,
            made::Start::Free => Start::Free,
        },
        speed_given: of.speed_given,
    }
}

fn sparse_row(of: &made::SparseRow) -> SparseRow {
    let made::SparseRow { constraint, columns, entries, first, part, diagonal } = of;
    let columns = columns.clone().leak();
    SparseRow { constraint: *constraint, columns, entries: *entries, first: *first, part: *part, diagonal: *diagonal }
}

fn conditional(of: &made::Conditional) -> Conditional {
    let made::Conditional { name, first_row, rows, initially_active } = of;
    Conditional { name: text(name), first_row: *first_row, rows: *rows, initially_active: *initially_active }
}

fn event(of: &made::Event) -> Event {
    let direction = match of.direction {
        made::Direction::Both => Direction::Both,
        made::Direction::Rising => Direction::Rising,
        made::Direction::Falling => Direction::Falling,
    };
    let (name, steps) = (text(&of.name), each(&of.steps, step));
    Event { name, direction, on_motion: of.on_motion, on_forces: of.on_forces, steps }
}

fn step(of: &made::Step) -> Step {
    match of {
        made::Step::Stop(after) => Step::Stop(*after),
        made::Step::Set(sets) => Step::Set(each(sets, |(target, value)| {
            let target = match *target {
                made::Target::Parameter(at) => Target::Parameter(at),
                made::Target::Position(at) => Target::Position(at),
                made::Target::Speed(at) => Target::Speed(at),
            };
            Assignment { target, value: *value }
        })),
        made::Step::Switch(switches) => {
            Step::Switch(each(switches, |(conditional, active)| Switch { conditional: *conditional, active: *active }))
        }
        made::Step::Impact(hits) => Step::Impact(each(hits, |(conditional, restitution)| Hit {
            conditional: *conditional,
            restitution: *restitution,
        })),
    }
}

fn shape(of: made::Shape) -> Shape {
    match of {
        made::Shape::Line(points) => Shape::Line(points),
        made::Shape::Curve(points) => Shape::Curve(points),
        made::Shape::Spring => Shape::Spring,
        made::Shape::Damper => Shape::Damper,
        made::Shape::Slider => Shape::Slider,
        made::Shape::Ground(points) => Shape::Ground(points),
        made::Shape::Points(points) => Shape::Points(points),
        made::Shape::Trace(points) => Shape::Trace(points),
        made::Shape::Circle => Shape::Circle,
    }
}
