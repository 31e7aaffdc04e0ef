//! The `loads` block.

use super::elements::{dissipation, element, potential, turned};
use super::interpret::Interpreter;
use super::level::{self, BEYOND_SPEED};
use super::scope::{Names, plain};
use super::{Body, Dimension, Effort, Force, Point};
use crate::dsl::{self, Declaration, Expression, Extent, Kind, Region};
use crate::symbolic::{Expr, Symbol};
use syn::Ident;

#[derive(Default)]
pub(super) struct Loads {
    pub(super) gravity: Option<Point>,
    pub(super) forces: Vec<Force>,
    pub(super) efforts: Vec<Effort>,
}

pub(super) fn resolve_loads(
    declaration: &Declaration,
    moving: &[(Symbol, Symbol)],
    bodies: &[Option<Body>],
    names: &Names<usize>,
    i: &mut Interpreter,
) -> Loads {
    let mut loads = Loads::default();
    let mut gravity_at: Option<Region> = None;
    for load in &declaration.loads {
        match load {
            dsl::Load::Force { force, point } => {
                let value = i.point_of(force, &Dimension::force(), "a force");
                let value = value.and_then(|value| load_level(force, value, i));
                let at = level::position(point, "the point of a force", i);
                if let (Some(force), Some(at)) = (value, at) {
                    loads.forces.push(Force { force, at });
                }
            }
            dsl::Load::Torque { moment, body } => loads.efforts.extend(torque(moment, body, bodies, names, i)),
            dsl::Load::Potential(energy) => loads.efforts.extend(potential(energy, i)),
            dsl::Load::Dissipation(function) => loads.efforts.extend(dissipation(function, moving, i)),
            dsl::Load::Element(load) => {
                if let Some(body) = body_instead_of_scalar(&load.extent, names, i) {
                    let message = format!("`{body}` is a body; a force on it acts at a point: `force [F, 0] at P;`");
                    i.mistakes.add(Region::from(body).error(message));
                    continue;
                }
                loads.efforts.extend(element(load, i));
            }
            dsl::Load::Gravity { keyword, acceleration } => {
                if let Some(first) = gravity_at.replace(*keyword) {
                    let mut mistake = keyword.error("gravity is declared twice; keep one");
                    mistake.combine(first.error("it is first declared here"));
                    i.mistakes.add(mistake);
                }
                let value = i.point_of(acceleration, &Dimension::acceleration(), "gravity");
                let value = value.and_then(|value| load_level(acceleration, value, i));
                loads.gravity = value.or(loads.gravity);
                let massless = declaration.bodies.iter().all(|body| body.mass.is_none());
                if massless && !declaration.bodies.is_empty() {
                    i.mistakes
                        .add(keyword.error(
                            "gravity acts on masses, and no body has one; write `mass m at P` in a body's line",
                        ));
                }
            }
        }
    }
    loads
}

/// A torque on a body, about its angle; or, where no body is called so, on an angle itself.
fn torque(
    moment: &Expression,
    on: &Ident,
    bodies: &[Option<Body>],
    names: &Names<usize>,
    i: &mut Interpreter,
) -> Option<Effort> {
    let value = i.scalar_of(moment, &Dimension::energy(), "a torque").and_then(|value| load_level(moment, [value], i));
    let is_body = names.get_region(&plain(on)).is_some() || i.values.get_region(&plain(on)).is_none();
    let along = if is_body { angle_of(on, bodies, names, i) } else { turned(&named(on), i) };
    let ([force], along) = (value?, along?);
    Some(Effort { force, along })
}

/// The body that `on` names, if that is no scalar too.
fn body_instead_of_scalar<'e>(extent: &'e Extent, names: &Names<usize>, i: &Interpreter) -> Option<&'e Ident> {
    let Extent::Quantity(Expression { kind: Kind::Name(name), .. }) = extent else { return None };
    let text = plain(name);
    (names.get_region(&text).is_some() && i.values.get_region(&text).is_none()).then_some(name)
}

fn angle_of(body: &Ident, bodies: &[Option<Body>], names: &Names<usize>, i: &mut Interpreter) -> Option<Expr> {
    let at = names.find(body, &mut i.mistakes)?;
    match bodies[at].as_ref()?.rotation {
        Some((_, angle)) => Some(angle),
        None => i.refuse(
            body.into(),
            format!("a torque turns an angle, and body `{body}` has none; write `angle phi` in its line"),
        ),
    }
}

pub(super) fn named(name: &Ident) -> Expression {
    Expression { region: name.into(), kind: Kind::Name(name.clone()) }
}

pub(super) fn load_level<const N: usize>(
    expression: &Expression,
    values: [Expr; N],
    i: &mut Interpreter,
) -> Option<[Expr; N]> {
    i.restrict(
        expression.region,
        &values,
        BEYOND_SPEED,
        "a load is made of coordinates, speeds, parameters and time; `ddot()` cannot stand in it",
    )?;
    Some(values)
}
