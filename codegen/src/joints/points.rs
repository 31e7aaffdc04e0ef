//! Points fixed on bodies, written out as ordinary expressions.
//!
//! A body with a position P and an angle phi is a frame: the point `on(body, [u, v])` is P + R(phi) [u, v].

use super::frames::{Frame, Frames};
use super::made::{binary, call, component, product};
use crate::dsl::{self, Body, Declaration, Expression, Kind, Operator, Region};
use syn::Result;

/// The declared frames, and those of the bodies, each expressed by those before it.
pub(super) fn frames(declaration: &Declaration) -> Result<Frames> {
    let tables = declaration.tables.iter().map(|table| table.name.to_string()).collect();
    let declared = declaration.frames.iter().map(|dsl::Frame { name, place, angle, attitude }| Frame {
        name: name.clone(),
        position: Some(place.clone()),
        angle: angle.clone(),
        attitude: attitude.clone(),
        is_named: true,
    });
    let mut frames = Frames { bodies: declared.collect(), tables };
    for Body { name, mass, angle, attitude, .. } in &declaration.bodies {
        let position = mass.as_ref().and_then(|(_, position)| position.as_ref()).cloned();
        let (angle, attitude) = (angle.clone(), attitude.clone());
        let mut frame = Frame { name: name.clone(), position, angle, attitude, is_named: false };
        for expression in frame.position.iter_mut().chain(&mut frame.angle).chain(&mut frame.attitude) {
            write_out(&frames, expression)?;
        }
        frames.bodies.push(frame);
    }
    Ok(frames)
}

/// Writes out the points on bodies, and their attitudes, in an expression.
pub(super) fn write_out(frames: &Frames, expression: &mut Expression) -> Result<()> {
    match &mut expression.kind {
        Kind::Number { .. } | Kind::Name(_) => Ok(()),
        Kind::Negate(part) | Kind::Component(part, _) => write_out(frames, part),
        Kind::Binary(_, left, right) => write_out(frames, left).and_then(|()| write_out(frames, right)),
        Kind::Vector(parts) => parts.iter_mut().try_for_each(|part| write_out(frames, part)),
        Kind::Call(function, parts) if function == "on" => {
            let parts = std::mem::take(parts);
            *expression = point(frames, expression.region, parts)?;
            Ok(())
        }
        Kind::Call(function, parts) if function == "attitude" || function == "omega" => {
            if let [Expression { kind: Kind::Name(body), .. }] = parts.as_slice()
                && let Ok(turned) = frames.attitude(body)
            {
                let mut turned = Expression { region: expression.region, ..turned };
                if function == "omega" {
                    turned = call(expression.region, "angular_velocity", vec![turned]);
                }
                *expression = turned;
                return Ok(());
            }
            parts.iter_mut().try_for_each(|part| write_out(frames, part))
        }
        Kind::Attitude(_, rotation) => write_out(frames, rotation),
        Kind::Call(_, parts) => parts.iter_mut().try_for_each(|part| write_out(frames, part)),
        Kind::If(choice) => {
            let parts = [&mut choice.left, &mut choice.right, &mut choice.yes, &mut choice.no];
            parts.into_iter().try_for_each(|part| write_out(frames, part))
        }
    }
}

/// P + [u cos(phi) - v sin(phi), u sin(phi) + v cos(phi)].
fn point(frames: &Frames, region: Region, parts: Vec<Expression>) -> Result<Expression> {
    let form = || region.error("a point on a body is written `on(body, [u, v])`, in space `on(body, [u, v, w])`");
    let [body, mut place] = <[Expression; 2]>::try_from(parts).map_err(|_| form())?;
    write_out(frames, &mut place)?;
    let Kind::Name(body) = body.kind else { return Err(form()) };
    if frames.find(&body)?.attitude.is_some() {
        let turned = product(frames.attitude(&body)?, place);
        let mut point = binary(Operator::Add, frames.position(&body)?, turned);
        point.region = region;
        return Ok(point);
    }
    let (position, angle) = (frames.position(&body)?, frames.angle(&body)?);
    let of_angle = |function| call(region, function, vec![angle.clone()]);
    let [u, v] = ["x", "y"].map(|axis| component(&place, axis));
    let x = binary(Operator::Subtract, product(u.clone(), of_angle("cos")), product(v.clone(), of_angle("sin")));
    let y = binary(Operator::Add, product(u, of_angle("sin")), product(v, of_angle("cos")));
    let arm = Expression { region, kind: Kind::Vector(vec![x, y]) };
    let mut point = binary(Operator::Add, position, arm);
    point.region = region;
    Ok(point)
}
