//! The equations of joints of bodies in space.
//!
//! A joint holds a point and an axis of one body to those of another, or of the `ground`. Its equations are between products
//! of axes and their marks, each fixed on its body (Nikravesh, Computer-Aided Analysis of Mechanical Systems, 1988,
//! section 7.1).

use super::made::{binary, call, difference, inner, number, pi, product, quotient, zero};
use super::marks::Marks;
use crate::dsl::{Equation, Expression, Kind, Operator, Region, Rolling, Side, SpatialKind};
use syn::ext::IdentExt;
use syn::{Ident, Result};

/// A point and an axis with its marks, in the world.
pub(super) struct Placed {
    pub(super) point: Expression,
    marks: Marks,
}

impl Placed {
    /// From the body's point in the world, and the rotation from its frame to the world.
    pub(super) fn new(side: &Side, point: Expression, turned: impl Fn(Expression) -> Expression) -> Result<Placed> {
        let Marks { axis, across } = Marks::of(side)?;
        Ok(Placed { point, marks: Marks { axis: turned(axis), across: across.map(turned) } })
    }
}

/// The suffix of an equation's name after the joint's name.
pub(super) const ADDED_TO_NAMES: [&str; 8] = ["_f", "_f1", "_f2", "_m", "_m1", "_m2", "_m3", "_screw"];

/// The equations of a joint, each with its suffix.
pub(super) fn equations(
    at: Region,
    kind: SpatialKind,
    first: &Placed,
    second: &Placed,
) -> Vec<(&'static str, Expression, Expression)> {
    use SpatialKind::{Ball, Cylindrical, Planar, Prismatic, Revolute, Screw, Universal, Weld};
    let null = |suffix, left| (suffix, left, zero(at));
    let [t1, t2] = &first.marks.across;
    let of_both = |a: &Expression, b: &Expression| inner(at, a.clone(), b.clone());
    let apart = || difference(first.point.clone(), second.point.clone());
    let mut rows = Vec::new();
    match kind {
        Ball | Revolute | Universal | Weld => rows.push(("", first.point.clone(), second.point.clone())),
        Cylindrical | Prismatic | Screw => {
            rows.extend([null("_f1", of_both(t1, &apart())), null("_f2", of_both(t2, &apart()))]);
        }
        Planar => rows.push(null("_f", of_both(&first.marks.axis, &apart()))),
    }
    match kind {
        Ball => {}
        Universal => rows.push(null("_m", of_both(&first.marks.axis, &second.marks.axis))),
        _ => {
            let tilted = of_both(t1, &second.marks.axis);
            rows.push(null("_m1", of_both(t2, &second.marks.axis)));
            rows.push(null("_m2", Expression { region: at, kind: Kind::Negate(Box::new(tilted)) }));
        }
    }
    if matches!(kind, Prismatic | Weld) {
        rows.push(null("_m3", of_both(t1, &second.marks.across[1])));
    }
    rows
}

/// Turning advances the body: n.(P2 - P1)' = pitch/(2 pi) n.(w2 - w1).
pub(super) fn screw(
    at: Region,
    pitch: Expression,
    first: &Placed,
    second: &Placed,
    spins: [Expression; 2],
) -> (Expression, Expression) {
    let [first_spin, second_spin] = spins;
    let advance = call(at, "dot", vec![difference(second.point.clone(), first.point.clone())]);
    let turn = inner(at, first.marks.axis.clone(), difference(second_spin, first_spin));
    let whole = product(number(at, "2"), pi(at));
    (inner(at, first.marks.axis.clone(), advance), product(quotient(pitch, whole), turn))
}

/// A disc that touches a plane and does not slip on it. With a the axis of the disc and k the normal, the contact is r u
/// from the centre, u = -(k - (k.a) a)/|k x a|; the disc's speed there, P' + w x r u, is that of the plane, which moves with its
/// point O and does not turn.
pub(super) fn rolls(
    at: Region,
    rolling: &Rolling,
    centre: Expression,
    axis: Expression,
    spin: Expression,
) -> Result<[(&'static str, Expression, Expression); 3]> {
    let Marks { axis: normal, across: [t1, t2] } = Marks::about(&rolling.normal)?;
    let both = |a: &Expression, b: &Expression| inner(at, a.clone(), b.clone());
    let tilt = call(at, "norm", vec![call(at, "cross", vec![normal.clone(), axis.clone()])]);
    let above = difference(centre, rolling.on.clone());
    let height = both(&normal, &above);
    let down = difference(product(both(&normal, &axis), axis), normal);
    let arm = product(quotient(rolling.radius.clone(), tilt.clone()), down);
    let swept = call(at, "cross", vec![spin, arm]);
    let slip = binary(Operator::Add, call(at, "dot", vec![above]), swept);
    Ok([
        ("", height, product(rolling.radius.clone(), tilt)),
        ("_f1", both(&t1, &slip), zero(at)),
        ("_f2", both(&t2, &slip), zero(at)),
    ])
}

/// An equation with its suffix.
pub(super) fn named(joint: &Ident, suffix: &str, left: Expression, right: Expression) -> Equation {
    let name = match suffix.is_empty() {
        true => joint.clone(),
        false => Ident::new(&format!("{}{suffix}", joint.unraw()), joint.span()),
    };
    Equation { name, left, right, initially: None, is_of_joint: true }
}
