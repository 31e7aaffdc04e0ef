//! Joints of bodies in space, after their names and kinds.

use super::expression::expression;
use super::words::{accept_word, expect_word, name};
use crate::dsl::{Expression, Rolling, Side, SpatialJoint, SpatialKind};
use syn::Ident;
use syn::parse::{ParseStream, Result};

pub(super) fn spatial_joint(input: ParseStream, kind: SpatialKind) -> Result<SpatialJoint> {
    let first = side(input)?;
    expect_word(input, "to", FORM)?;
    let second = side(input)?;
    let pitch = match kind {
        SpatialKind::Screw => {
            expect_word(input, "pitch", "screw nut at P axis n to bolt at Q axis n pitch p;")?;
            Some(expression(input)?)
        }
        SpatialKind::Ball
        | SpatialKind::Revolute
        | SpatialKind::Cylindrical
        | SpatialKind::Prismatic
        | SpatialKind::Universal
        | SpatialKind::Planar
        | SpatialKind::Weld => None,
    };
    Ok(SpatialJoint { kind, first, second, pitch })
}

const FORM: &str = "revolute a at [u, v, w] axis [0, 0, 1] to b at [u, v, w] axis [0, 0, 1];";

fn side(input: ParseStream) -> Result<Side> {
    let body = name(input, "a body, by its name, or `ground`")?;
    expect_word(input, "at", FORM)?;
    let at = expression(input)?;
    let axis = if accept_word(input, "axis")? { Some(expression(input)?) } else { None };
    Ok(Side { body, at, axis })
}

/// The rest of `roll disc radius r axis n on O normal k;`.
pub(super) fn rolling(input: ParseStream, disc: Ident, radius: Expression) -> Result<Rolling> {
    const FORM: &str = "roll disc radius r axis n on O normal [0, 0, 1];";
    expect_word(input, "axis", FORM)?;
    let axis = expression(input)?;
    expect_word(input, "on", FORM)?;
    let on = expression(input)?;
    expect_word(input, "normal", FORM)?;
    Ok(Rolling { disc, radius, axis, on, normal: expression(input)? })
}
