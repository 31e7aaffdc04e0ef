//! Lines of the `joints` block: joints by name.

use super::equation::initially;
use super::expression::expression;
use super::spatial_joint::{rolling, spatial_joint};
use super::words::{accept_word, colon, docs, expect_word, keyword, name};
use crate::dsl::region::here;
use crate::dsl::vocabulary::JointWord;
use crate::dsl::{Expression, Guide, Joint, JointKind, Kind, SpatialKind};
use syn::Ident;
use syn::ext::IdentExt;
use syn::parse::{ParseStream, Result};

const FORM: &str =
    "a joint is written `name: pin P to Q;`, with `pin`, `link`, `slot`, `slide`, `gear`, `rack`, `cam` or `roll`";

/// Reads a joint.
pub(super) fn joint(input: ParseStream) -> Result<Joint> {
    let docs = docs(input)?;
    let name = name(input, FORM)?;
    colon(input, FORM)?;
    let kind = match keyword(input)?.1 {
        JointWord::Pin => pin(input)?,
        JointWord::Link => link(input)?,
        JointWord::Slot => JointKind::Slot(expression(input)?, guide(input, "slot P through O along beta;")?),
        JointWord::Slide => JointKind::Slide(body(input)?, guide(input, "slide rod through O along beta;")?),
        JointWord::Gear => gear(input)?,
        JointWord::Rack => rack(input)?,
        JointWord::Cam => cam(input)?,
        JointWord::Roll => roll(input)?,
        JointWord::Ball => spatial(input, SpatialKind::Ball)?,
        JointWord::Revolute => spatial(input, SpatialKind::Revolute)?,
        JointWord::Cylindrical => spatial(input, SpatialKind::Cylindrical)?,
        JointWord::Prismatic => spatial(input, SpatialKind::Prismatic)?,
        JointWord::Universal => spatial(input, SpatialKind::Universal)?,
        JointWord::Planar => spatial(input, SpatialKind::Planar)?,
        JointWord::Screw => spatial(input, SpatialKind::Screw)?,
        JointWord::Weld => spatial(input, SpatialKind::Weld)?,
    };
    Ok(Joint { docs, name, kind, initially: initially(input)? })
}

fn spatial(input: ParseStream, kind: SpatialKind) -> Result<JointKind> {
    Ok(JointKind::Spatial(Box::new(spatial_joint(input, kind)?)))
}

fn body(input: ParseStream) -> Result<Ident> {
    name(input, "a body, by its name")
}

fn pin(input: ParseStream) -> Result<JointKind> {
    let first = expression(input)?;
    expect_word(input, "to", "pin P to Q;")?;
    Ok(JointKind::Pin(first, expression(input)?))
}

fn link(input: ParseStream) -> Result<JointKind> {
    const FORM: &str = "link P to Q, length l;";
    let first = expression(input)?;
    expect_word(input, "to", FORM)?;
    let second = expression(input)?;
    if input.parse::<Option<syn::Token![,]>>()?.is_none() {
        return Err(here(input, format!("expected `, length l`: `{FORM}`")));
    }
    expect_word(input, "length", FORM)?;
    Ok(JointKind::Link(first, second, expression(input)?))
}

fn guide(input: ParseStream, form: &str) -> Result<Guide> {
    expect_word(input, "through", form)?;
    let through = expression(input)?;
    expect_word(input, "along", form)?;
    Ok(Guide { through, along: expression(input)? })
}

fn radius(input: ParseStream, form: &str) -> Result<Expression> {
    expect_word(input, "radius", form)?;
    expression(input)
}

fn gear(input: ParseStream) -> Result<JointKind> {
    const FORM: &str = "gear sun radius r to planet radius s;";
    let first = (body(input)?, radius(input, FORM)?);
    expect_word(input, "to", FORM)?;
    Ok(JointKind::Gear([first, (body(input)?, radius(input, FORM)?)]))
}

fn rack(input: ParseStream) -> Result<JointKind> {
    const FORM: &str = "rack P through O along beta on wheel radius r;";
    let point = expression(input)?;
    let guide = guide(input, FORM)?;
    expect_word(input, "on", FORM)?;
    Ok(JointKind::Rack(point, guide, body(input)?, radius(input, FORM)?))
}

/// A follower that slides, or one that turns.
fn cam(input: ParseStream) -> Result<JointKind> {
    const FORM: &str = "cam P through O along beta on wheel radius r by lift;";
    const ROCKER: &str = "cam arm on wheel by lift;";
    let follower = expression(input)?;
    match follower.kind {
        Kind::Name(arm) if accept_word(input, "on")? => Ok(JointKind::Rocker(arm, body(input)?, by(input, ROCKER)?)),
        _ => {
            let guide = guide(input, FORM)?;
            expect_word(input, "on", FORM)?;
            let (wheel, radius) = (body(input)?, radius(input, FORM)?);
            Ok(JointKind::Cam(follower, guide, wheel, radius, by(input, FORM)?))
        }
    }
}

fn by(input: ParseStream, form: &str) -> Result<Ident> {
    expect_word(input, "by", form)?;
    name(input, "a table, by its name")
}

fn next_is(input: ParseStream, word: &str) -> bool {
    input.peek(Ident::peek_any) && input.fork().call(Ident::parse_any).is_ok_and(|next| next == word)
}

fn roll(input: ParseStream) -> Result<JointKind> {
    const FORM: &str = "roll wheel radius r along beta;";
    let (wheel, radius) = (body(input)?, radius(input, FORM)?);
    if next_is(input, "axis") {
        return Ok(JointKind::Rolling(Box::new(rolling(input, wheel, radius)?)));
    }
    expect_word(input, "along", FORM)?;
    Ok(JointKind::Roll(wheel, radius, expression(input)?))
}
