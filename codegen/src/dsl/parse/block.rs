//! The lines of each block.

use super::expression::expression;
use super::lines::{ended, lines};
use super::unit::declared_unit;
use super::words::{accept_word, colon, docs, equals, expect_word, keyword, name};
use crate::dsl::region::here;
use crate::dsl::vocabulary::{BodyWord, ShapeWord};
use crate::dsl::{
    Auxiliary, Body, Coordinate, GeneralizedSpeed, Initial, InitialKind, Let, Mark, Output, OutputGroup, Parameter,
    Region, Shape,
};
use crate::kernel_id::KernelId;
use syn::ext::IdentExt;
use syn::parse::{ParseStream, Result};
use syn::{Ident, LitStr, Token};

pub(super) fn coordinate(input: ParseStream) -> Result<Coordinate> {
    let docs = docs(input)?;
    let name = name(input, "a coordinate: `alpha [rad];`")?;
    let unit = declared_unit(input, &name)?;
    if input.peek(Token![=]) {
        return Err(here(input, format!("a start value stands in `initial {{ {name} = ..; }}`, not here")));
    }
    Ok(Coordinate { docs, name, unit, is_added: false })
}

/// A displacement that is zero: `bx [m];`
pub(super) fn auxiliary(input: ParseStream) -> Result<Auxiliary> {
    docs(input)?;
    let name = name(input, "an auxiliary displacement: `bx [m];`")?;
    let unit = declared_unit(input, &name)?;
    if input.peek(Token![=]) {
        return Err(here(input, format!("an auxiliary displacement is always zero; write `{name} [m];`")));
    }
    Ok(Auxiliary { name, unit })
}

pub(super) fn parameter(input: ParseStream) -> Result<Parameter> {
    let docs = docs(input)?;
    let name = name(input, "a parameter: `m [kg] = 0.5;`")?;
    let unit = declared_unit(input, &name)?;
    if !input.peek(Token![=]) {
        return Err(here(input, format!("parameter `{name}` needs a default: `{name} [unit] = value;`")));
    }
    input.parse::<Token![=]>()?;
    Ok(Parameter { docs, name, unit, value: expression(input)? })
}

pub(super) fn input(input: ParseStream) -> Result<Parameter> {
    let docs = docs(input)?;
    let name = name(input, "an input: `tau [N*m] = 0;`")?;
    let unit = declared_unit(input, &name)?;
    if input.parse::<Option<Token![=]>>()?.is_none() {
        let form = format!("`{name} [unit] = expression;`, of numbers, parameters and `t`");
        return Err(here(input, format!("input `{name}` needs a course, which it follows until it is set: {form}")));
    }
    Ok(Parameter { docs, name, unit, value: expression(input)? })
}

/// A generalised speed, and the definition of its name.
pub(super) fn speed(input: ParseStream) -> Result<(GeneralizedSpeed, Let)> {
    let docs = docs(input)?;
    let name = name(input, "a generalised speed: `v [m/s] = dot(x)*cos(phi) + dot(y)*sin(phi);`")?;
    let unit = declared_unit(input, &name)?;
    equals(
        input,
        &format!("generalised speed `{name}` needs a definition: `{name} [unit] = expression;`, linear in `dot(..)`"),
    )?;
    let value = expression(input)?;
    Ok((GeneralizedSpeed { docs, name: name.clone(), unit }, Let { name, value, is_of_frame: false }))
}

pub(super) fn definition(input: ParseStream) -> Result<Let> {
    input.parse::<Token![let]>()?;
    let name = name(input, "a name: `let A = ..;`")?;
    if input.peek(syn::token::Bracket) {
        return Err(here(input, "a `let` has the unit of its expression; write `let name = ..;`"));
    }
    equals(input, "`let` gives a name to an expression: `let A = ..;`")?;
    Ok(Let { name, value: expression(input)?, is_of_frame: false })
}

pub(super) fn body(input: ParseStream) -> Result<Body> {
    docs(input)?;
    let name = name(input, "a body: `rod: mass m at G, inertia J, angle phi;`")?;
    colon(input, "a body is written `name: mass m at G, inertia J, angle phi;`")?;
    let (mass, inertia, angle, attitude, free) = (None, None, None, None, None);
    let mut body = Body { name, mass, inertia, angle, attitude, free, unchecked: false };
    loop {
        let (word, clause) = keyword(input)?;
        let twice = match clause {
            BodyWord::Mass => {
                let mass = expression(input)?;
                let position = if accept_word(input, "at")? { Some(expression(input)?) } else { None };
                body.mass.replace((mass, position)).is_some()
            }
            BodyWord::Inertia => body.inertia.replace(expression(input)?).is_some(),
            BodyWord::Angle => body.angle.replace(expression(input)?).is_some(),
            BodyWord::Attitude => body.attitude.replace(expression(input)?).is_some(),
            BodyWord::Free => {
                body.free = Some(Region::from(&word));
                false
            }
            BodyWord::Unchecked => std::mem::replace(&mut body.unchecked, true),
        };
        if twice {
            return Err(syn::Error::new(word.span(), format!("body `{}` has its {word} twice", body.name)));
        }
        if input.parse::<Option<Token![,]>>()?.is_none() {
            return Ok(body);
        }
    }
}

pub(super) fn initial(input: ParseStream) -> Result<Initial> {
    const FORM: &str = "a start value: `alpha = 0;`, `dot(alpha) = 75 [rpm];` or `guess gamma = 2.6;`";
    docs(input)?;
    let first = name(input, FORM)?;
    let (kind, coordinate) = if first == "dot" && input.peek(syn::token::Paren) {
        let content;
        syn::parenthesized!(content in input);
        let coordinate = name(&content, "a coordinate: `dot(alpha) = ..;`")?;
        if !content.is_empty() {
            return Err(here(
                &content,
                "only the speed of a coordinate can be given, `dot(alpha) = ..;`, not that of an expression",
            ));
        }
        (InitialKind::Speed, coordinate)
    } else if first == "guess" && input.peek(Ident::peek_any) {
        let coordinate = name(input, FORM)?;
        if coordinate == "dot" && input.peek(syn::token::Paren) {
            return Err(syn::Error::new(coordinate.span(), "speeds need no guess: they follow from linear equations"));
        }
        (InitialKind::Guess, coordinate)
    } else {
        (InitialKind::Position, first)
    };
    equals(input, FORM)?;
    Ok(Initial { coordinate, kind, value: expression(input)? })
}

/// One output and its `;`, or a named group of outputs in braces.
pub(super) fn output_group(input: ParseStream) -> Result<OutputGroup> {
    let (docs, name) = output_name(input)?;
    if !input.peek(LitStr) && !input.peek(syn::token::Brace) {
        let output = ended(|line| output_after_name(line, docs.clone(), name.clone()))(input)?;
        return Ok(OutputGroup { name: None, title: None, outputs: vec![output] });
    }
    let title = if input.peek(LitStr) { Some(input.parse::<LitStr>()?.value()) } else { None };
    if !input.peek(syn::token::Brace) {
        return Err(here(input, format!("a group of outputs is written `{name} \"Title\" {{ .. }}`")));
    }
    let content;
    syn::braced!(content in input);
    let line = |line: ParseStream| {
        let (docs, name) = output_name(line)?;
        output_after_name(line, docs, name)
    };
    let outputs = lines(&content, ended(line))?;
    input.parse::<Option<Token![;]>>()?;
    Ok(OutputGroup { name: Some(name), title, outputs })
}

fn output_name(input: ParseStream) -> Result<(String, Ident)> {
    Ok((docs(input)?, name(input, "an output: `speed [m/s] = dot(C.x);`")?))
}

fn output_after_name(input: ParseStream, docs: String, name: Ident) -> Result<Output> {
    let unit = declared_unit(input, &name)?;
    equals(input, "an output is written `name [unit] = expression;`")?;
    Ok(Output { docs, name, unit, value: expression(input)? })
}

pub(super) fn shape(input: ParseStream) -> Result<Shape> {
    docs(input)?;
    let (word, shape) = keyword(input)?;
    let first = expression(input)?;
    let (mark, ends) = match shape {
        ShapeWord::Slider => {
            expect_word(input, "along", "slider A along beta;")?;
            return Ok(Shape::Slider { at: first, along: expression(input)? });
        }
        ShapeWord::Circle => {
            expect_word(input, "radius", "circle O radius r;")?;
            let radius = expression(input)?;
            let normal = if accept_word(input, "normal")? { Some(expression(input)?) } else { None };
            return Ok(Shape::Circle { at: first, radius, normal });
        }
        ShapeWord::Line => (Mark::Line, None),
        ShapeWord::Curve => (Mark::Curve, None),
        ShapeWord::Ground => (Mark::Ground, None),
        ShapeWord::Point => (Mark::Point, None),
        ShapeWord::Trace => (Mark::Trace, None),
        ShapeWord::Spring => (Mark::Spring, Some(2)),
        ShapeWord::Damper => (Mark::Damper, Some(2)),
    };
    let mut points = vec![first];
    while input.parse::<Option<Token![,]>>()?.is_some() {
        points.push(expression(input)?);
    }
    if ends.is_some_and(|ends| points.len() != ends) {
        return Err(syn::Error::new(word.span(), format!("a drawn {word} has two ends: `{word} A, B;`")));
    }
    Ok(Shape::Points { mark, points })
}

pub(super) fn kernel(input: ParseStream) -> Result<KernelId> {
    Ok(keyword(input)?.1)
}
