//! Joints by name, as they are written.

use super::Activity;
use crate::dsl::Expression;
use syn::Ident;

/// `pin_A: pin P to Q;`
pub struct Joint {
    /// Documentation.
    pub docs: String,
    /// Its name, which its constraints take, or its coordinates.
    pub name: Ident,
    /// Its kind.
    pub kind: JointKind,
    /// `initially released`, on a joint that events switch.
    pub initially: Option<Activity>,
}

/// A kind of joint, with what it joins.
pub enum JointKind {
    /// `pin P to Q`: the points coincide.
    Pin(Expression, Expression),
    /// `link P to Q, length l`: the points keep their distance.
    Link(Expression, Expression, Expression),
    /// `slot P through O along beta`: the point stays on a line.
    Slot(Expression, Guide),
    /// `slide body through O along beta`: the body's centre stays on a line, and its angle is that of the line.
    Slide(Ident, Guide),
    /// `gear a radius r to b radius s`: angles turn against each other.
    Gear([(Ident, Expression); 2]),
    /// `rack P through O along beta on wheel radius r`: the point moves along a line as the wheel turns.
    Rack(Expression, Guide, Ident, Expression),
    /// `cam P through O along beta on wheel radius r by lift`: the point moves along a line as a table says.
    Cam(Expression, Guide, Ident, Expression, Ident),
    /// `cam arm on wheel by lift`: the body turns as a table says.
    Rocker(Ident, Ident, Ident),
    /// `roll wheel radius r along beta`: the wheel does not slip on ground of that direction.
    Roll(Ident, Expression, Expression),
    /// `revolute a at u axis n to b at v axis m` and its like, in space.
    Spatial(Box<SpatialJoint>),
    /// `roll disc radius r axis n on O normal k`, in space.
    Rolling(Box<Rolling>),
}

/// `through O along beta`: a line.
pub struct Guide {
    /// A point on it.
    pub through: Expression,
    /// Its direction.
    pub along: Expression,
}

/// `hinge: revolute arm at [l, 0, 0] axis [0, 0, 1] to ground at [0, 0, 0] axis [0, 0, 1];`
pub struct SpatialJoint {
    /// Its kind.
    pub kind: SpatialKind,
    /// The body that holds.
    pub first: Side,
    /// The body that is held.
    pub second: Side,
    /// `pitch p`, of a screw.
    pub pitch: Option<Expression>,
}

/// A kind of joint of bodies in space.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum SpatialKind {
    /// Points coincide.
    Ball,
    /// And axes are parallel.
    Revolute,
    /// Axes coincide.
    Cylindrical,
    /// And nothing turns.
    Prismatic,
    /// Points coincide and axes are at right angles.
    Universal,
    /// A plane moves on a plane.
    Planar,
    /// Axes coincide, and turning advances the body.
    Screw,
    /// Nothing moves.
    Weld,
}

/// A body with a point and an axis, in its own frame.
pub struct Side {
    /// The body, or `ground`.
    pub body: Ident,
    /// A point on it.
    pub at: Expression,
    /// An axis on it; z if none is given.
    pub axis: Option<Expression>,
}

/// `roll disc radius r axis n on O normal k`: a thin disc rolls on a plane.
pub struct Rolling {
    /// The disc, whose centre is its centre of mass.
    pub disc: Ident,
    /// Its radius.
    pub radius: Expression,
    /// Its axis, in its own frame.
    pub axis: Expression,
    /// A point of the plane.
    pub on: Expression,
    /// The plane's normal, in numbers.
    pub normal: Expression,
}
