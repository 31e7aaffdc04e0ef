//! Joints that are constraints, written out as equations.

use super::added_coordinates::with_suffix;
use super::frames::Frames;
use super::made::{across, binary, call, difference, direction, inner, product, zero};
use super::spatial::{self, Placed};
use crate::dsl::{Activity, Equation, Joint, JointKind, Operator, Region, Side, SpatialJoint};
use syn::{Ident, Result};

/// The equations of a joint.
pub(super) fn equations(frames: &Frames, joint: Joint) -> Result<Vec<Equation>> {
    let Joint { name, kind, initially, .. } = joint;
    let at = Region::from(&name);
    let equation = |left, right| Equation { name: name.clone(), left, right, initially, is_of_joint: true };
    Ok(match kind {
        JointKind::Pin(first, second) => vec![equation(first, second)],
        JointKind::Link(first, second, length) => {
            vec![equation(call(at, "norm", vec![difference(first, second)]), length)]
        }
        JointKind::Slot(point, guide) => vec![equation(across(at, point, &guide), zero(at))],
        JointKind::Slide(body, guide) => {
            let turned = Equation {
                name: with_suffix(&name, "turn"),
                left: frames.angle(&body)?,
                right: guide.along.clone(),
                initially,
                is_of_joint: true,
            };
            vec![equation(across(at, frames.position(&body)?, &guide), zero(at)), turned]
        }
        JointKind::Gear([(first, r), (second, s)]) => {
            let turned = [product(r, frames.angle(&first)?), product(s, frames.angle(&second)?)];
            let [left, right] = turned;
            vec![equation(binary(Operator::Add, left, right), zero(at))]
        }
        JointKind::Rack(point, guide, wheel, radius) => {
            let way = inner(at, difference(point, guide.through), direction(at, &guide.along));
            vec![equation(way, product(radius, frames.angle(&wheel)?))]
        }
        JointKind::Cam(point, guide, wheel, radius, lift) => {
            let way = inner(at, difference(point, guide.through), direction(at, &guide.along));
            vec![equation(binary(Operator::Add, radius, frames.lift(&lift, &wheel)?), way)]
        }
        JointKind::Rocker(arm, wheel, lift) => {
            vec![equation(frames.lift(&lift, &wheel)?, frames.angle(&arm)?)]
        }
        JointKind::Spatial(joint) => in_space(frames, &name, *joint, initially)?,
        JointKind::Rolling(rolling) => {
            let (centre, attitude) = (frames.position(&rolling.disc)?, frames.attitude(&rolling.disc)?);
            let spin = call(at, "angular_velocity", vec![attitude.clone()]);
            let rows = spatial::rolls(at, &rolling, centre, product(attitude, rolling.axis.clone()), spin)?;
            rows.into_iter().map(|(suffix, left, right)| spatial::named(&name, suffix, left, right)).collect()
        }
        JointKind::Roll(wheel, radius, along) => {
            let speed = inner(at, call(at, "dot", vec![frames.position(&wheel)?]), direction(at, &along));
            let turning = product(radius, call(at, "dot", vec![frames.angle(&wheel)?]));
            vec![equation(binary(Operator::Add, speed, turning), zero(at))]
        }
    })
}

/// The equations of a joint of bodies in space.
fn in_space(frames: &Frames, name: &Ident, joint: SpatialJoint, initially: Option<Activity>) -> Result<Vec<Equation>> {
    let at = Region::from(name);
    let (first, second) = (placed(frames, &joint.first)?, placed(frames, &joint.second)?);
    let mut rows = spatial::equations(at, joint.kind, &first, &second);
    if let Some(pitch) = joint.pitch {
        let spins = [frames.spin(at, &joint.first.body)?, frames.spin(at, &joint.second.body)?];
        let (left, right) = spatial::screw(at, pitch, &first, &second, spins);
        rows.push(("_screw", left, right));
    }
    let equation = |(suffix, left, right)| Equation { initially, ..spatial::named(name, suffix, left, right) };
    Ok(rows.into_iter().map(equation).collect())
}

/// A side of a joint in the world.
fn placed(frames: &Frames, side: &Side) -> Result<Placed> {
    if frames.is_ground(&side.body) {
        return Placed::new(side, side.at.clone(), |v| v);
    }
    let (position, attitude) = (frames.position(&side.body)?, frames.attitude(&side.body)?);
    let point = binary(Operator::Add, position, product(attitude.clone(), side.at.clone()));
    Placed::new(side, point, |v| product(attitude.clone(), v))
}
