//! The `loads` block.

use super::bodies::TurnedBody;
use super::elements::{dissipation, element, potential, turned};
use super::interpreter::Interpreter;
use super::level::{self, load_level};
use super::scope::{Names, plain};
use super::space::{Spatial, Turn};
use super::{Body, Dimension, Effort, Force, Point, Push, Pushed};
use crate::dsl::{self, Declaration, Expression, Extent, Kind, Region};
use crate::symbolic::{Expr, Symbol};
use syn::Ident;

#[derive(Default)]
pub(super) struct Loads {
    pub(super) gravity: Option<Point>,
    pub(super) forces: Vec<Force>,
    pub(super) efforts: Vec<Effort>,
    pub(super) pushes: Vec<Push>,
    /// Gravity as a vector of space.
    pub(super) falling: Option<Spatial>,
}

pub(super) fn resolve_loads(
    declaration: &Declaration,
    moving: &[(Symbol, Symbol)],
    bodies: &[Option<Body>],
    turns: &[TurnedBody],
    names: &Names<usize>,
    interpreter: &mut Interpreter,
) -> Loads {
    let mut loads = Loads::default();
    let mut gravity_at: Option<Region> = None;
    for load in &declaration.loads {
        match load {
            dsl::Load::Force { force, point } if interpreter.is_spatial() => {
                loads.pushes.extend(spatial_force(force, point, interpreter));
            }
            dsl::Load::Torque { moment, body } if turned_body(body, turns, names).is_some() => {
                let turned = turned_body(body, turns, names);
                loads.pushes.extend(turned.and_then(|(body, turn)| spatial_torque(moment, body, turn, interpreter)));
            }
            dsl::Load::Force { force, point } => {
                let value = interpreter.point_of(force, &Dimension::force(), "a force");
                let value = value.and_then(|value| load_level(force, value, interpreter));
                let at = level::position(point, "the point of a force", interpreter);
                if let (Some(force), Some(at)) = (value, at) {
                    loads.forces.push(Force { force, at });
                }
            }
            dsl::Load::Torque { moment, body } => {
                loads.efforts.extend(torque(moment, body, bodies, names, interpreter))
            }
            dsl::Load::Potential(energy) => loads.efforts.extend(potential(energy, interpreter)),
            dsl::Load::Dissipation(function) => loads.efforts.extend(dissipation(function, moving, interpreter)),
            dsl::Load::Element(load) => {
                if let Some(body) = body_instead_of_scalar(&load.extent, names, interpreter) {
                    let message = format!("`{body}` is a body; a force on it acts at a point: `force [F, 0] at P;`");
                    interpreter.mistakes.add(Region::from(body).error(message));
                    continue;
                }
                loads.efforts.extend(element(load, interpreter));
            }
            dsl::Load::Gravity { keyword, acceleration } => {
                if let Some(first) = gravity_at.replace(*keyword) {
                    let mut mistake = keyword.error("gravity is declared twice; keep one");
                    mistake.combine(first.error("it is first declared here"));
                    interpreter.mistakes.add(mistake);
                }
                loads.fall(*keyword, acceleration, declaration, interpreter);
            }
        }
    }
    loads
}

impl Loads {
    /// Gravity, which needs a mass to act on.
    fn fall(
        &mut self,
        keyword: Region,
        acceleration: &Expression,
        declaration: &Declaration,
        interpreter: &mut Interpreter,
    ) {
        let value = interpreter.point_of(acceleration, &Dimension::acceleration(), "gravity");
        let value = value.and_then(|value| load_level(acceleration, value, interpreter));
        if let Some(value) = value.as_ref().and_then(|value| <[Expr; 3]>::try_from(value.as_slice()).ok()) {
            self.falling = Some(Spatial::world(value));
        }
        self.gravity = value.or(self.gravity.take());
        let massless = declaration.bodies.iter().all(|body| body.mass.is_none());
        if massless && !declaration.bodies.is_empty() {
            interpreter.mistakes.add(
                keyword.error("gravity acts on masses, and no body has one; write `mass m at P` in a body's line"),
            );
        }
    }
}

/// A force at a point: it works along the point's velocity, in the frame that the force is written in.
fn spatial_force(force: &Expression, point: &Expression, interpreter: &mut Interpreter) -> Option<Push> {
    let value = spatial_load(force, &Dimension::force(), "a force", interpreter);
    let place = level::position(point, "the point of a force", interpreter)?;
    let ((value, force), (at, _)) = (value?, interpreter.spatial_value(point)?);
    let turn = value.frame().unwrap_or(Turn::NONE);
    let Interpreter { graph, motion, frames, .. } = interpreter;
    let along = frames.point_rates(graph, motion, &at, turn);
    let in_world = Pushed::Force { force, at: place };
    Some(Push { effort: frames.resolved_in(graph, &value, turn), along, in_world })
}

/// A torque on a body: it works along the angular velocity, in the body's frame.
fn spatial_torque(moment: &Expression, body: usize, turn: Turn, interpreter: &mut Interpreter) -> Option<Push> {
    let (value, moment) = spatial_load(moment, &Dimension::energy(), "a torque", interpreter)?;
    let effort = interpreter.frames.resolved_in(&mut interpreter.graph, &value, turn);
    Some(Push { effort, along: interpreter.frames.spin_rates(turn), in_world: Pushed::Torque { moment, body } })
}

/// A load, and its components in the world's frame.
fn spatial_load(
    expression: &Expression,
    needed: &Dimension,
    what: &str,
    interpreter: &mut Interpreter,
) -> Option<(Spatial, Point)> {
    let (vector, value) = interpreter.spatial_value(expression)?;
    interpreter.expect_world(expression.region, &value.bases)?;
    interpreter.expect_in_place(value.measured(expression), needed, what);
    let components = interpreter.resolved(&vector).to_vec();
    let components = load_level(expression, components, interpreter)?;
    Some((vector, components))
}

/// A body with an attitude, by its name: its index, and the attitude.
fn turned_body(body: &Ident, turns: &[TurnedBody], names: &Names<usize>) -> Option<(usize, Turn)> {
    names.get(&plain(body)).and_then(|at| turns[*at].as_ref().map(|(turn, _)| (*at, *turn)))
}

/// A torque on a body, about its angle; or, if no body has that name, on an angle itself.
fn torque(
    moment: &Expression,
    on: &Ident,
    bodies: &[Option<Body>],
    names: &Names<usize>,
    interpreter: &mut Interpreter,
) -> Option<Effort> {
    let value = interpreter
        .scalar_of(moment, &Dimension::energy(), "a torque")
        .and_then(|value| load_level(moment, vec![value], interpreter));
    let is_body = names.get_region(&plain(on)).is_some() || interpreter.values.get_region(&plain(on)).is_none();
    let along = if is_body { angle_of(on, bodies, names, interpreter) } else { turned(&named(on), interpreter) };
    let (value, along) = (value?, along?);
    Some(Effort { force: value[0], along })
}

/// The body that `on` names, unless it is a scalar too.
fn body_instead_of_scalar<'e>(
    extent: &'e Extent,
    names: &Names<usize>,
    interpreter: &Interpreter,
) -> Option<&'e Ident> {
    let Extent::Quantity(Expression { kind: Kind::Name(name), .. }) = extent else { return None };
    let text = plain(name);
    (names.get_region(&text).is_some() && interpreter.values.get_region(&text).is_none()).then_some(name)
}

fn angle_of(
    body: &Ident,
    bodies: &[Option<Body>],
    names: &Names<usize>,
    interpreter: &mut Interpreter,
) -> Option<Expr> {
    let at = names.find(body, &mut interpreter.mistakes)?;
    match bodies[at].as_ref()?.rotation {
        Some((_, angle)) => Some(angle),
        None => interpreter.refuse(
            body.into(),
            format!("a torque turns an angle, and body `{body}` has none; write `angle phi` in its line"),
        ),
    }
}

pub(super) fn named(name: &Ident) -> Expression {
    Expression { region: name.into(), kind: Kind::Name(name.clone()) }
}
