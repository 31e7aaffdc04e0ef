//! Lines of `frames`.

use super::expression::expression;
use super::words::{colon, docs, expect_word, keyword, name};
use crate::dsl::region::here;
use crate::dsl::vocabulary::FrameWord;
use crate::dsl::{Expression, Frame, Kind, Let};
use syn::ext::IdentExt;
use syn::parse::{ParseStream, Result};
use syn::{Ident, Token};

/// A frame that moves with something, `tool: at P, attitude R;`, and the definitions of its place and attitude.
pub(super) fn frame(input: ParseStream) -> Result<(Frame, [Let; 2])> {
    const FORM: &str = "a frame is written `name: at P, attitude R;`, in the plane `name: at P, angle phi;`";
    docs(input)?;
    let name = name(input, "a frame: `tool: at P, attitude R;`")?;
    colon(input, FORM)?;
    expect_word(input, "at", FORM)?;
    let (place, place_defined) = defined(&name, "place", expression(input)?);
    if input.parse::<Option<Token![,]>>()?.is_none() {
        return Err(here(input, FORM));
    }
    let (_, word) = keyword(input)?;
    let (turned, turn_defined) = defined(&name, "attitude", expression(input)?);
    let (angle, attitude) = match word {
        FrameWord::Angle => (Some(turned), None),
        FrameWord::Attitude => (None, Some(turned)),
    };
    Ok((Frame { name, place, angle, attitude }, [place_defined, turn_defined]))
}

/// A name for an expression that belongs to a frame.
fn defined(frame: &Ident, what: &str, value: Expression) -> (Expression, Let) {
    let name = Ident::new(&format!("{what}_of_{}", frame.unraw()), frame.span());
    let named = Expression { region: value.region, kind: Kind::Name(name.clone()) };
    (named, Let { name, value, is_of_frame: true })
}
