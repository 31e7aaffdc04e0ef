//! Lines of the `joints` block: joints by name.

use super::block::{accept_word, colon, docs, expect_word, initially, keyword, name};
use super::expression::expression;
use super::region::here;
use super::spatial_joint::{rolling, spatial_joint};
use super::{Activity, Expression, Kind, Rolling, SpatialJoint, SpatialKind};
use syn::Ident;
use syn::ext::IdentExt;
use syn::parse::{ParseStream, Result};

/// `pin_A: pin P to Q;`
pub struct Joint {
    /// Documentation.
    pub docs: String,
    /// Its name, which its constraints take, or its coordinates.
    pub name: Ident,
    /// What it is.
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

const FORM: &str =
    "a joint is written `name: pin P to Q;`, with `pin`, `link`, `slot`, `slide`, `gear`, `rack`, `cam` or `roll`";

/// Reads a joint.
pub(super) fn joint(input: ParseStream) -> Result<Joint> {
    let docs = docs(input)?;
    let name = name(input, FORM)?;
    colon(input, FORM)?;
    let known = ["pin", "link", "slot", "slide", "gear", "rack", "cam", "roll"];
    let word = keyword(input, &[&known, SpatialKind::WORDS.as_slice()].concat())?;
    if let Some(kind) = SpatialKind::of(&word.to_string()) {
        let joint = spatial_joint(input, kind)?;
        return Ok(Joint { docs, name, kind: JointKind::Spatial(Box::new(joint)), initially: initially(input)? });
    }
    let kind = match word.to_string().as_str() {
        "pin" => pin(input)?,
        "link" => link(input)?,
        "slot" => JointKind::Slot(expression(input)?, guide(input, "slot P through O along beta;")?),
        "slide" => JointKind::Slide(body(input)?, guide(input, "slide rod through O along beta;")?),
        "gear" => gear(input)?,
        "rack" => rack(input)?,
        "cam" => cam(input)?,
        _ => roll(input)?,
    };
    Ok(Joint { docs, name, kind, initially: initially(input)? })
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
