//! The `bodies` block.

use super::interpret::Interpreter;
use super::level::{self, MOVING};
use super::scope::{Names, plain};
use super::{Body, Dependence, Dimension, Level, Point};
use crate::dsl::{self, Declaration, Expression, Region};
use crate::symbolic::Expr;

/// Bodies in order, a mistaken one as `None`, with their places by name.
pub(super) fn resolve_bodies(declaration: &Declaration, i: &mut Interpreter) -> (Vec<Option<Body>>, Names<usize>) {
    let mut names = Names::new("body");
    let mut bodies = Vec::new();
    for (at, b) in declaration.bodies.iter().enumerate() {
        names.define(&b.name, Some(at), &mut i.mistakes);
        let body = resolve_body(b, i);
        bodies.push(body);
    }
    if declaration.bodies.is_empty() {
        let place = Region::from(&declaration.head.name);
        i.mistakes.add(
            place.error("a mechanism needs at least one body: `bodies { rod: mass m at G, inertia J, angle phi; }`"),
        );
    }
    (bodies, names)
}

fn resolve_body(b: &dsl::Body, i: &mut Interpreter) -> Option<Body> {
    let name = plain(&b.name);
    let place = Region::from(&b.name);
    // Every part is looked at before the first mistake counts.
    let mass = b.mass.as_ref().map(|(mass, position)| resolve_mass(mass, position.as_ref(), &name, i));
    let angle = b.angle.as_ref().map(|angle| {
        const WHAT: &str = "the angle of a body";
        let value = level::angle(angle, WHAT, i)?;
        i.smooth(angle.region, &[value], Level::Positions, WHAT).map(|()| value)
    });
    let inertia = b.inertia.as_ref().map(|inertia| {
        let value = i.scalar_of(inertia, &Dimension::inertia(), "an inertia")?;
        inertial(inertia, value, i)
    });
    if let (Some(inertia), None) = (&b.inertia, &b.angle) {
        return i.refuse(inertia.region, format!("about which angle does `{name}` turn? Write `inertia J, angle phi`"));
    }
    let zero = i.graph.zero();
    let mass = mass.map_or(Some(None), |mass| mass.map(Some))?;
    let angle = angle.map_or(Some(None), |angle| angle.map(Some))?;
    let inertia = inertia.unwrap_or(Some(zero))?;
    let rotation = angle.map(|angle| (inertia, angle));
    let moved: Vec<Expr> = mass.iter().flat_map(|(_, p)| *p).chain(angle).collect();
    if !moved.iter().any(|x| i.dependences.of(&i.graph, *x).meets(Dependence::COORDINATE.or(Dependence::TIME))) {
        return i.refuse(
            place,
            format!(
                "no coordinate moves body `{name}`; leave it out, or let its position or angle depend on a coordinate"
            ),
        );
    }
    Some(Body { name, mass, rotation })
}

fn resolve_mass(
    mass: &Expression,
    position: Option<&Expression>,
    body: &str,
    i: &mut Interpreter,
) -> Option<(Expr, Point)> {
    let value = i.scalar_of(mass, &Dimension::mass(), "a mass").and_then(|value| inertial(mass, value, i));
    let Some(position) = position else {
        return i.refuse(
            mass.region,
            format!("where is the mass of `{body}`? Write `mass m at P`, P being its centre of mass"),
        );
    };
    const WHAT: &str = "the position of a mass";
    let at =
        level::position(position, WHAT, i).filter(|at| i.smooth(position.region, at, Level::Positions, WHAT).is_some());
    value.zip(at)
}

/// A mass or moment of inertia: made of parameters.
fn inertial(expression: &Expression, value: Expr, i: &mut Interpreter) -> Option<Expr> {
    i.restrict(
        expression.region,
        &[value],
        MOVING.or(Dependence::TIME).or(Dependence::INPUT),
        "a mass or inertia is made of numbers and parameters; it cannot change with the motion",
    )?;
    if i.graph.as_number(value).is_some_and(|number| number.is_negative()) {
        return i.refuse(expression.region, "a mass or inertia cannot be negative");
    }
    Some(value)
}
