//! Which forces and reactions have an arrow, and the outputs that define it.

use super::Vector;
use super::expressions::{binary, change, components, is_vector, name, named, output, rate};
use codegen::dsl::{Declaration, Equation, Expression, Kind, Let, Load, Operator, Output, Shape};
use proc_macro2::{Ident, Span};
use sim_kernel::Description;

/// The outputs of an arrow, from this index on: first the components of the point.
pub(super) enum Source {
    /// Then those of the force.
    Load(usize),
    /// A scalar constraint at a point: then the differences of C along the axes.
    Reaction { first: usize, row: usize },
    /// A constraint between vectors, where its left side is.
    Joint { first: usize, row: usize },
}

/// Every force that is a load, and every weight; every constraint between vectors where its left side is; every other
/// at the points named in it that are drawn, where its virtual work is that of a force. The required outputs are added.
pub(super) fn arrows(
    declaration: &mut Declaration,
    description: &Description,
    outputs: &mut Vec<Output>,
) -> Vec<(Vector, Source)> {
    let mut drawing = Arrows { dimension: description.dimension, outputs, points: Vec::new(), found: Vec::new() };
    declaration.loads.iter().for_each(|load| drawing.load(load, declaration));
    let (vectors, drawn) = (vectors_named(declaration), drawn(declaration));
    let mut row = 0;
    for constraint in &declaration.constraints {
        let difference = binary(Operator::Subtract, constraint.left.clone(), constraint.right.clone());
        let between_speeds = declaration.has_rates(constraint);
        if is_vector(&difference, &vectors) {
            if !between_speeds {
                drawing.joint(constraint, row);
            }
            row += description.dimension;
            continue;
        }
        for point in named(&difference).into_iter().filter(|name| vectors.contains(name) && drawn.contains(name)) {
            drawing.reaction(constraint, &difference, &point, between_speeds, row);
        }
        row += 1;
    }
    let Arrows { points, found, .. } = drawing;
    declaration.lets.extend(points);
    // Forces that cannot be determined here are not drawn.
    if row == description.constraints.len() { found } else { Vec::new() }
}

struct Arrows<'o> {
    dimension: usize,
    outputs: &'o mut Vec<Output>,
    /// Names for points, so that each is evaluated once for all of its components.
    points: Vec<Let>,
    found: Vec<(Vector, Source)>,
}

impl Arrows<'_> {
    /// Adds outputs; gives the index of the first.
    fn add(&mut self, values: impl IntoIterator<Item = Expression>) -> usize {
        let first = self.outputs.len();
        self.outputs.extend(values.into_iter().map(output));
        first
    }

    fn load(&mut self, load: &Load, declaration: &Declaration) {
        match load {
            Load::Force { force, point } => self.force(format!("force {force} at {point}"), force, point),
            Load::Gravity { acceleration, .. } => {
                for body in &declaration.bodies {
                    let Some((mass, Some(point))) = &body.mass else { continue };
                    let weight = binary(Operator::Multiply, mass.clone(), acceleration.clone());
                    self.force(format!("weight of {}", body.name), &weight, point);
                }
            }
            // Their forces follow from an energy, or act along two points or an angle.
            Load::Torque { .. } | Load::Potential(_) | Load::Dissipation(_) | Load::Element(_) => {}
        }
    }

    fn force(&mut self, about: String, force: &Expression, point: &Expression) {
        // No name that a user would choose.
        let name = Ident::new(&format!("arrow__{}", self.points.len()), Span::call_site());
        let named = Expression { region: point.region, kind: Kind::Name(name.clone()) };
        self.points.push(Let { name, value: point.clone(), is_of_frame: false });
        let numbers = components(&named, self.dimension).into_iter().chain(components(force, self.dimension));
        let source = Source::Load(self.add(numbers));
        self.found.push((Vector { label: String::new(), about, kind: "load" }, source));
    }

    fn joint(&mut self, constraint: &Equation, row: usize) {
        let first = self.add(components(&constraint.left, self.dimension));
        let about = format!("reaction of {}, on {}", constraint.name, constraint.left);
        let vector = Vector { label: constraint.name.to_string(), about, kind: "reaction" };
        self.found.push((vector, Source::Joint { first, row }));
    }

    fn reaction(
        &mut self,
        constraint: &Equation,
        difference: &Expression,
        point: &str,
        between_speeds: bool,
        row: usize,
    ) {
        let moved = if between_speeds { rate(point) } else { name(point) };
        let changes = (0..self.dimension).map(|axis| change(difference, &moved, axis, self.dimension));
        let numbers: Vec<Expression> = components(&name(point), self.dimension).into_iter().chain(changes).collect();
        let source = Source::Reaction { first: self.add(numbers), row };
        let about = format!("reaction of {} at {point}", constraint.name);
        self.found.push((Vector { label: constraint.name.to_string(), about, kind: "reaction" }, source));
    }
}

/// The names of what is drawn.
fn drawn(declaration: &Declaration) -> Vec<String> {
    let points = declaration.drawing.iter().flat_map(|shape| match shape {
        Shape::Points { points, .. } => points.as_slice(),
        Shape::Slider { at, .. } | Shape::Circle { at, .. } => std::slice::from_ref(at),
    });
    points.map(ToString::to_string).collect()
}

/// The `let`s that name vectors.
fn vectors_named(declaration: &Declaration) -> Vec<String> {
    let mut names: Vec<String> = Vec::new();
    for named in &declaration.lets {
        if is_vector(&named.value, &names) {
            names.push(named.name.to_string());
        }
    }
    names
}
