//! The lines of `loads`.

use super::expression::expression;
use super::words::{accept_word, docs, expect_word, keyword};
use crate::dsl::region::here;
use crate::dsl::vocabulary::{LoadWord, RestWord};
use crate::dsl::{Element, Expression, Extent, Kind, Law, Load, Region};
use syn::parse::{ParseStream, Result};
use syn::{Ident, Token};

const SPRING: &str = "spring k, length l0 from A to B;` or `spring k, rest phi0 between alpha and beta;";

pub(super) fn load(input: ParseStream) -> Result<Load> {
    docs(input)?;
    let (word, load) = keyword(input)?;
    match load {
        LoadWord::Force => force(input, &word),
        LoadWord::Torque => torque(input, &word),
        LoadWord::Gravity => Ok(Load::Gravity { keyword: (&word).into(), acceleration: expression(input)? }),
        LoadWord::Potential => Ok(Load::Potential(expression(input)?)),
        LoadWord::Dissipation => Ok(Load::Dissipation(expression(input)?)),
        LoadWord::Spring => spring(input, &word),
        LoadWord::Friction => friction(input, &word),
        LoadWord::Damper => {
            let law = Law::Damper(expression(input)?);
            element(input, &word, law, "damper c from A to B;")
        }
    }
}

fn force(input: ParseStream, word: &Ident) -> Result<Load> {
    let force = expression(input)?;
    if accept_word(input, "at")? {
        return Ok(Load::Force { force, point: expression(input)? });
    }
    match extent(input)? {
        Some(extent) => Ok(made(word, Law::Force(force), extent)),
        None => Err(here(input, "expected `at`: `force [F, 0] at P;`")),
    }
}

fn torque(input: ParseStream, word: &Ident) -> Result<Load> {
    let moment = expression(input)?;
    match extent(input)? {
        Some(Extent::Quantity(Expression { kind: Kind::Name(body), .. })) => Ok(Load::Torque { moment, body }),
        Some(extent) => Ok(made(word, Law::Force(moment), extent)),
        None => Err(here(input, "expected `on`: `torque T on body;`")),
    }
}

fn spring(input: ParseStream, word: &Ident) -> Result<Load> {
    let law = expression(input)?;
    if input.parse::<Option<Token![,]>>()?.is_none() {
        return Err(here(input, format!("a spring needs a `length` or a `rest` where it exerts no force: `{SPRING}`")));
    }
    let (word_of_rest, measure) = keyword(input)?;
    let rest = expression(input)?;
    let load = element(input, word, Law::Spring(law, rest), SPRING)?;
    let between_points = matches!(&load, Load::Element(e) if matches!(e.extent, Extent::Distance(..)));
    match (between_points, measure) {
        (true, RestWord::Rest) => {
            Err(syn::Error::new(word_of_rest.span(), format!("a spring between points has a `length`: `{SPRING}`")))
        }
        (false, RestWord::Length) => Err(syn::Error::new(
            word_of_rest.span(),
            format!("a `length` belongs to a spring between points; write `rest` here: `{SPRING}`"),
        )),
        (true, RestWord::Length) | (false, RestWord::Rest) => Ok(load),
    }
}

fn friction(input: ParseStream, word: &Ident) -> Result<Load> {
    const FORM: &str = "friction F, smooth v0 on x;";
    let force = expression(input)?;
    if input.parse::<Option<Token![,]>>()?.is_none() {
        let message =
            format!("dry friction needs the speed v0 over which it is smoothed, as in F*tanh(x'/v0): `{FORM}`");
        return Err(here(input, message));
    }
    expect_word(input, "smooth", FORM)?;
    let law = Law::Friction(force, expression(input)?);
    element(input, word, law, FORM)
}

fn element(input: ParseStream, word: &Ident, law: Law, form: &str) -> Result<Load> {
    match extent(input)? {
        Some(extent) => Ok(made(word, law, extent)),
        None => Err(here(input, format!("expected `from`, `between` or `on`: `{form}`"))),
    }
}

fn made(word: &Ident, law: Law, extent: Extent) -> Load {
    Load::Element(Box::new(Element { keyword: Region::from(word), law, extent }))
}

/// `from A to B`, `between alpha and beta`, `on x`, or none of these.
fn extent(input: ParseStream) -> Result<Option<Extent>> {
    if accept_word(input, "from")? {
        let from = expression(input)?;
        expect_word(input, "to", "from A to B")?;
        return Ok(Some(Extent::Distance(from, expression(input)?)));
    }
    if accept_word(input, "between")? {
        let from = expression(input)?;
        expect_word(input, "and", "between alpha and beta")?;
        return Ok(Some(Extent::Difference(from, expression(input)?)));
    }
    match accept_word(input, "on")? {
        true => Ok(Some(Extent::Quantity(expression(input)?))),
        false => Ok(None),
    }
}
