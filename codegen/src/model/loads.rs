//! The `loads` block.

use super::interpret::Interpreter;
use super::level::{self, BEYOND_SPEED};
use super::scope::Names;
use super::{Body, Dimension, Force, Point, Torque};
use crate::dsl::{self, Declaration, Expression, Region};
use crate::symbolic::Expr;

#[derive(Default)]
pub(super) struct Loads {
    pub(super) gravity: Option<Point>,
    pub(super) forces: Vec<Force>,
    pub(super) torques: Vec<Torque>,
}

pub(super) fn resolve_loads(
    declaration: &Declaration,
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
            dsl::Load::Torque { moment, body } => {
                let value = i
                    .scalar_of(moment, &Dimension::energy(), "a torque")
                    .and_then(|value| load_level(moment, [value], i));
                let body_at = names.find(body, &mut i.mistakes);
                let (Some([value]), Some(at)) = (value, body_at) else { continue };
                let Some(found) = &bodies[at] else { continue };
                match found.rotation {
                    Some((_, angle)) => loads.torques.push(Torque { moment: value, angle }),
                    None => i.mistakes.add(Region::from(body).error(format!(
                        "a torque turns an angle, and body `{body}` has none; write `angle phi` in its line"
                    ))),
                }
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

fn load_level<const N: usize>(expression: &Expression, values: [Expr; N], i: &mut Interpreter) -> Option<[Expr; N]> {
    i.restrict(
        expression.region,
        &values,
        BEYOND_SPEED,
        "a load is made of coordinates, speeds, parameters and time; `ddot()` cannot stand in it",
    )?;
    Some(values)
}
