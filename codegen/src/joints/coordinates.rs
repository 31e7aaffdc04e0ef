//! Joints as coordinates: position and attitude of one body of a joint relative to the frame of the other.
//!
//! With A1, A2 the attitudes of the bodies, B1 = [t1, t2, n] the marks in the frame of the first and B2 those in the
//! frame of the second, A2 = A1 J B1 B2', where J is the rotation of the joint, in the frame of the first. So the marks
//! of both sides are aligned where all coordinates are 0; for a universal joint whose axes are at right angles as
//! written, both frames are. The second point is shifted against the first along the marks of the first (Wittenburg,
//! Dynamics of Multibody Systems, 2008, section 5.3).

use super::added_coordinates::{AddedCoordinates, with_suffix};
use super::made::{attitude, call, difference, named, negated, number, pi, product, quotient, sum, vector, zero};
use super::marks::Marks;
use crate::dsl::{Expression, Kind, Region, SpatialJoint, SpatialKind};
use syn::ext::IdentExt;
use syn::{Ident, Result};

/// A joint that becomes coordinates.
pub(super) struct JointCoordinates<'a> {
    pub(super) name: &'a Ident,
    pub(super) docs: &'a str,
    pub(super) joint: &'a SpatialJoint,
    /// Whether the body that is placed is the first.
    pub(super) is_backward: bool,
    /// Whether the other side is the world.
    pub(super) is_grounded: bool,
}

/// The position and attitude of a body.
pub(super) struct Pose {
    /// Its centre of mass.
    pub(super) position: Expression,
    /// From its frame to the world's.
    pub(super) attitude: Expression,
}

/// The relative motion that a joint allows the second body, in the frame of the first.
struct Freedom {
    turns: Vec<Expression>,
    shift: Option<Expression>,
}

impl JointCoordinates<'_> {
    /// Gives the joint its coordinates. The pose is that of the body that it places.
    ///
    /// # Errors
    /// Invalid axes.
    pub(super) fn pose(&self, given: &mut AddedCoordinates) -> Result<Pose> {
        let SpatialJoint { kind, first, second, .. } = self.joint;
        let crossed = if *kind == SpatialKind::Universal { Marks::crossed(first, second)? } else { None };
        let (own, other) = match (crossed, *kind) {
            (Some(crossed), _) => (crossed, None),
            (None, SpatialKind::Universal) => (Marks::of(first)?, Some(Marks::of(second)?.in_turn())),
            (None, _) => (Marks::of(first)?, Some(Marks::of(second)?)),
        };
        let frames = [Some(&own), other.as_ref()].map(|marks| marks.map(|marks| marks.frame(self.at())));
        let Freedom { mut turns, shift } = self.freedom(own, given);
        if let [Some(own), Some(other)] = frames
            && own.to_string() != other.to_string()
        {
            turns.extend([own, inverse(other)]);
        }
        let first = (&first.body, shift.into_iter().fold(first.at.clone(), sum));
        let second = (&second.body, second.at.clone());
        Ok(match self.is_backward {
            false => self.placed(first, turns, second),
            true => self.placed(second, turns.into_iter().rev().map(inverse).collect(), first),
        })
    }

    fn at(&self) -> Region {
        Region::from(self.name)
    }

    /// The pose of a body with this attitude relative to the holder, and with its point at the holder's point.
    fn placed(&self, holder: (&Ident, Expression), turns: Vec<Expression>, own: (&Ident, Expression)) -> Pose {
        let (holder, point) = (named(holder.0, holder.0.into()), holder.1);
        let (before, point) = match self.is_grounded {
            true => (None, point),
            false => {
                let before = call(self.at(), "attitude", vec![holder.clone()]);
                (Some(before), call(point.region, "on", vec![holder, point]))
            }
        };
        let rotation = before.into_iter().chain(turns).reduce(product).unwrap_or_else(|| self.unturned());
        let turned = attitude(own.1.region, own.0, rotation.clone());
        Pose { position: difference(point, product(turned, own.1)), attitude: rotation }
    }

    fn unturned(&self) -> Expression {
        let axis = vector(self.at(), vec![zero(self.at()), zero(self.at()), number(self.at(), "1")]);
        call(self.at(), "rotation", vec![axis, zero(self.at())])
    }

    fn freedom(&self, marks: Marks, given: &mut AddedCoordinates) -> Freedom {
        use SpatialKind::{Ball, Cylindrical, Planar, Prismatic, Revolute, Screw, Universal, Weld};
        let at = self.at();
        let Marks { axis, across: [t1, t2] } = marks;
        let about = |axis: &Expression, angle: &Expression| call(at, "rotation", vec![axis.clone(), angle.clone()]);
        let mut coordinate = |suffix, unit, what| self.coordinate(suffix, unit, what, given);
        match self.joint.kind {
            Weld => Freedom { turns: vec![], shift: None },
            Revolute => {
                let turn = coordinate("", "rad", "Turn");
                Freedom { turns: vec![about(&axis, &turn)], shift: None }
            }
            Universal => {
                let turns = [coordinate("1", "rad", "First turn"), coordinate("2", "rad", "Second turn")];
                Freedom { turns: vec![about(&axis, &turns[0]), about(&t1, &turns[1])], shift: None }
            }
            Ball => {
                let quaternion = given.quaternion(self.name, &self.docs("Quaternion"), at);
                Freedom { turns: vec![quaternion], shift: None }
            }
            Prismatic => {
                let shift = coordinate("", "m", "Shift");
                Freedom { turns: vec![], shift: Some(product(shift, axis)) }
            }
            Cylindrical => {
                let (turn, shift) = (coordinate("turn", "rad", "Turn"), coordinate("shift", "m", "Shift"));
                Freedom { turns: vec![about(&axis, &turn)], shift: Some(product(shift, axis)) }
            }
            Screw => {
                let turn = coordinate("", "rad", "Turn");
                let whole = product(number(at, "2"), pi(at));
                let advance = self.joint.pitch.clone().map(|pitch| product(quotient(pitch, whole), turn.clone()));
                Freedom { turns: vec![about(&axis, &turn)], shift: advance.map(|advance| product(advance, axis)) }
            }
            Planar => {
                let shifts = [coordinate("x", "m", "First shift"), coordinate("y", "m", "Second shift")];
                let turn = coordinate("turn", "rad", "Turn");
                let [x, y] = shifts;
                Freedom { turns: vec![about(&axis, &turn)], shift: Some(sum(product(x, t1), product(y, t2))) }
            }
        }
    }

    /// A coordinate with the joint's name, and a suffix if there are several.
    fn coordinate(&self, suffix: &str, unit: &str, what: &str, given: &mut AddedCoordinates) -> Expression {
        let name = if suffix.is_empty() { self.name.clone() } else { with_suffix(self.name, suffix) };
        given.coordinate(name, unit, self.docs(what), self.at())
    }

    /// The joint's documentation, and the meaning of the coordinate.
    fn docs(&self, what: &str) -> String {
        let [first, second] = [&self.joint.first, &self.joint.second].map(|side| side.body.unraw());
        let own = format!("{what} of `{second}` against `{first}`.");
        if self.docs.is_empty() { own } else { format!("{}\n{own}", self.docs) }
    }
}

/// R'.
fn inverse(rotation: Expression) -> Expression {
    match &rotation.kind {
        Kind::Call(function, arguments) => match arguments.as_slice() {
            [axis, angle] if function == "rotation" => {
                call(rotation.region, "rotation", vec![axis.clone(), negated(angle.clone())])
            }
            [inverted] if function == "transpose" => inverted.clone(),
            _ => call(rotation.region, "transpose", vec![rotation]),
        },
        _ => call(rotation.region, "transpose", vec![rotation]),
    }
}
