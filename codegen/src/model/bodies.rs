//! The `bodies` block.

use super::inertial::inertial;
use super::interpreter::Interpreter;
use super::level;
use super::scope::{Names, plain};
use super::space::{Spatial, Turn, norm_square, resolve_inertia};
use super::{Attitude, Body, Dependence, Dimension, Fall, Level, Norm, Point, Tensor};
use crate::dsl::{self, Declaration, Expression, Kind, Region};
use crate::symbolic::Expr;

/// The attitude of a body, its centre of mass, and the frame of that point's velocity, as far as declared.
pub(super) type TurnedBody = Option<(Turn, Option<(Spatial, Turn)>)>;

/// The bodies of a declaration.
pub(super) struct ResolvedBodies {
    /// In order, a mistaken one as `None`.
    pub(super) bodies: Vec<Option<Body>>,
    /// The attitude of each, with the place of its centre of mass.
    pub(super) turns: Vec<TurnedBody>,
    /// Their places by name.
    pub(super) names: Names<usize>,
    /// Their quaternions.
    pub(super) norms: Vec<Norm>,
}

pub(super) fn resolve_bodies(declaration: &Declaration, interpreter: &mut Interpreter) -> ResolvedBodies {
    let mut names = Names::new("body");
    let (mut bodies, mut turns, mut norms) = (Vec::new(), Vec::new(), Vec::new());
    for (at, b) in declaration.bodies.iter().enumerate() {
        names.define(&b.name, Some(at), &mut interpreter.mistakes);
        let turn = b.attitude.as_ref().map(|attitude| interpreter.attitude_of(attitude));
        let body = match turn {
            Some(None) => None,
            _ => resolve_body(b, turn.flatten(), interpreter),
        };
        if let (Some(turn), Some(attitude)) = (turn.flatten(), body.as_ref().and_then(|body| body.attitude.as_ref())) {
            add_norms(&mut norms, turn, &attitude.inertia, interpreter);
        }
        let place = body.as_ref().and(b.mass.as_ref()).and_then(|(_, place)| place.as_ref());
        let place = place.filter(|_| turn.is_some()).and_then(|place| interpreter.spatial_value(place));
        turns.push(turn.flatten().map(|turn| (turn, place.map(|(place, _)| interpreter.with_frame(place, turn)))));
        bodies.push(body);
    }
    if declaration.bodies.is_empty() {
        let place = Region::from(&declaration.head.name);
        interpreter.mistakes.add(
            place.error("a mechanism needs at least one body: `bodies { rod: mass m at G, inertia J, angle phi; }`"),
        );
    }
    ResolvedBodies { bodies, turns, names, norms }
}

/// Gives each quaternion of coordinates, with the first body that it turns, that body's mean moment of inertia.
fn add_norms(norms: &mut Vec<Norm>, turn: Turn, inertia: &Tensor, interpreter: &mut Interpreter) {
    for components in interpreter.frames.quaternions(turn) {
        let square = norm_square(&mut interpreter.graph, &components);
        if norms.iter().all(|norm| norm.square != square) {
            let sum = interpreter.graph.sum(&inertia.moments);
            let third = interpreter.graph.integer(3);
            norms.push(Norm { square, inertia: interpreter.graph.div(sum, third) });
        }
    }
}

/// Lets bodies fall, if there is gravity: in the frame of each.
pub(super) fn fall(
    bodies: &mut [Option<Body>],
    turns: &[TurnedBody],
    gravity: Option<&Spatial>,
    interpreter: &mut Interpreter,
) {
    let Some(gravity) = gravity else { return };
    let Interpreter { graph, motion, frames, .. } = interpreter;
    let up = gravity.clone().map(|x| graph.neg(x));
    for (body, turn) in bodies.iter_mut().zip(turns) {
        if let (Some(Body { attitude: Some(attitude), .. }), Some((_, Some((place, frame))))) = (body, turn) {
            let gravity = frames.resolved_in(graph, gravity, *frame);
            attitude.fall =
                Some(Fall { gravity, proper: frames.proper_acceleration(graph, motion, place, &up, *frame) });
        }
    }
}

/// A body that turns in space: its inertia, its attitude, and the motion of its centre of mass in its own frame.
fn resolve_attitude(b: &dsl::Body, turn: Turn, has_place: bool, interpreter: &mut Interpreter) -> Option<Attitude> {
    let Some(inertia) = &b.inertia else {
        let message = format!(
            "the inertia of `{}` is missing: `inertia [A, B, C]`, its principal moments, stands with an attitude",
            b.name
        );
        return interpreter.refuse(Region::from(&b.name), message);
    };
    let inertia = resolve_inertia(inertia, b.unchecked, interpreter)?;
    let place = match &b.mass {
        Some((_, Some(place))) if has_place => Some(interpreter.spatial_value(place)?.0),
        _ => None,
    };
    let place = place.map(|place| interpreter.with_frame(place, turn));
    let Interpreter { graph, motion, frames, .. } = interpreter;
    let centre = place.map(|(place, frame)| frames.point_rates(graph, motion, &place, frame));
    let spin = frames.spin_rates(turn);
    Some(Attitude { inertia, matrix: *frames.matrix(turn), spin, centre, fall: None })
}

fn resolve_body(b: &dsl::Body, turn: Option<Turn>, interpreter: &mut Interpreter) -> Option<Body> {
    let name = plain(&b.name);
    let place = Region::from(&b.name);
    if let (Some(attitude), Some(_)) = (&b.attitude, &b.angle) {
        return interpreter
            .refuse(attitude.region, format!("body `{name}` has an angle and an attitude; keep one of them"));
    }
    // Every part is checked before the first mistake is returned.
    let mass = b.mass.as_ref().map(|(mass, position)| resolve_mass(mass, position.as_ref(), &name, interpreter));
    let angle = b.angle.as_ref().map(|angle| {
        const WHAT: &str = "the angle of a body";
        let value = level::angle(angle, WHAT, interpreter)?;
        interpreter.smooth(angle.region, &[value], Level::Positions, WHAT).map(|()| value)
    });
    let has_place = matches!(mass, Some(Some(_)));
    let attitude = turn.map(|turn| resolve_attitude(b, turn, has_place, interpreter));
    let inertia = b.inertia.as_ref().filter(|_| turn.is_none()).map(|inertia| {
        if let Kind::Vector(_) = inertia.kind {
            let message = format!(
                "body `{name}` needs an attitude, as its inertia has several moments: \
                 `inertia [A, B, C], attitude R`"
            );
            return interpreter.refuse(inertia.region, message);
        }
        let value = interpreter.scalar_of(inertia, &Dimension::inertia(), "an inertia")?;
        inertial(inertia, value, interpreter)
    });
    if let (Some(inertia), None, None) = (&b.inertia, &b.angle, turn) {
        if let Kind::Vector(_) = inertia.kind {
            return None;
        }
        return interpreter
            .refuse(inertia.region, format!("body `{name}` needs the angle that it turns by: `inertia J, angle phi`"));
    }
    let zero = interpreter.graph.zero();
    let mass = mass.map_or(Some(None), |mass| mass.map(Some))?;
    let angle = angle.map_or(Some(None), |angle| angle.map(Some))?;
    let inertia = inertia.unwrap_or(Some(zero))?;
    let attitude = attitude.map_or(Some(None), |attitude| attitude.map(Some))?;
    let rotation = angle.map(|angle| (inertia, angle));
    let turned = attitude.iter().flat_map(|attitude| attitude.matrix.concat());
    let moved: Vec<Expr> = mass.iter().flat_map(|(_, p)| p.clone()).chain(angle).chain(turned).collect();
    if !moved
        .iter()
        .any(|x| interpreter.dependences.of(&interpreter.graph, *x).meets(Dependence::COORDINATE.or(Dependence::TIME)))
    {
        return interpreter.refuse(
            place,
            format!(
                "no coordinate moves body `{name}`; leave it out, or make its position or angle depend on a coordinate"
            ),
        );
    }
    Some(Body { name, mass, rotation, attitude })
}

fn resolve_mass(
    mass: &Expression,
    position: Option<&Expression>,
    body: &str,
    interpreter: &mut Interpreter,
) -> Option<(Expr, Point)> {
    let value =
        interpreter.scalar_of(mass, &Dimension::mass(), "a mass").and_then(|value| inertial(mass, value, interpreter));
    let Some(position) = position else {
        return interpreter.refuse(
            mass.region,
            format!("the mass of body `{body}` needs a position: write `mass m at P`, P being its centre of mass, or make the body `free`"),
        );
    };
    const WHAT: &str = "the position of a mass";
    let at = level::position(position, WHAT, interpreter)
        .filter(|at| interpreter.smooth(position.region, at, Level::Positions, WHAT).is_some());
    value.zip(at)
}
