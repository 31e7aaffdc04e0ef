//! The lines of each block.

use super::expression::expression;
use super::parse::{ended, lines};
use super::region::here;
use super::unit::declared_unit;
use super::*;
use syn::ext::IdentExt;
use syn::parse::{ParseStream, Result};
use syn::{Attribute, Ident, LitStr, Token};

/// Reads the documentation in front of an item.
pub(super) fn docs(input: ParseStream) -> Result<String> {
    let mut lines = Vec::new();
    for attribute in input.call(Attribute::parse_outer)? {
        let text = match &attribute.meta {
            syn::Meta::NameValue(pair) if pair.path.is_ident("doc") => match &pair.value {
                syn::Expr::Lit(syn::ExprLit { lit: syn::Lit::Str(text), .. }) => Some(text.value()),
                _ => None,
            },
            _ => None,
        };
        match text {
            Some(text) => lines.push(text.trim().to_owned()),
            None => {
                let place = Region::from(attribute.pound_token.span);
                return Err(place.error("only documentation (`/// ..`) may stand here"));
            }
        }
    }
    Ok(lines.join("\n"))
}

/// A name that the user gives.
pub(super) fn name(input: ParseStream, what: &str) -> Result<Ident> {
    let name = Ident::parse_any(input).map_err(|e| syn::Error::new(e.span(), format!("expected {what}")))?;
    if ["self", "Self", "super", "crate", "_"].iter().any(|word| name.unraw() == word) {
        return Err(syn::Error::new(name.span(), format!("`{name}` cannot be a name in Rust; choose another")));
    }
    Ok(name)
}

pub(super) fn coordinate(input: ParseStream) -> Result<Coordinate> {
    let docs = docs(input)?;
    let name = name(input, "a coordinate: `alpha [rad];`")?;
    let unit = declared_unit(input, &name)?;
    if input.peek(Token![=]) {
        return Err(here(input, format!("a start value stands in `initial {{ {name} = ..; }}`, not here")));
    }
    Ok(Coordinate { docs, name, unit })
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
    Ok((GeneralizedSpeed { docs, name: name.clone(), unit }, Let { name, value }))
}

pub(super) fn definition(input: ParseStream) -> Result<Let> {
    input.parse::<Token![let]>()?;
    let name = name(input, "a name: `let A = ..;`")?;
    if input.peek(syn::token::Bracket) {
        return Err(here(input, "a `let` has the unit of its expression; write `let name = ..;`"));
    }
    equals(input, "`let` gives a name to an expression: `let A = ..;`")?;
    Ok(Let { name, value: expression(input)? })
}

pub(super) fn equals(input: ParseStream, advice: &str) -> Result<()> {
    if input.parse::<Option<Token![=]>>()?.is_none() {
        return Err(here(input, advice));
    }
    Ok(())
}

pub(super) fn colon(input: ParseStream, advice: &str) -> Result<()> {
    if input.parse::<Option<Token![:]>>()?.is_none() {
        return Err(here(input, advice));
    }
    Ok(())
}

/// The word that says what a clause is, one of those expected.
pub(super) fn keyword(input: ParseStream, expected: &[&str]) -> Result<Ident> {
    let list = || expected.iter().map(|word| format!("`{word}`")).collect::<Vec<_>>().join(", ");
    let word = Ident::parse_any(input).map_err(|e| syn::Error::new(e.span(), format!("expected one of {}", list())))?;
    if expected.iter().any(|e| word == e) {
        return Ok(word);
    }
    Err(syn::Error::new(word.span(), format!("`{word}` is not known here; expected one of {}", list())))
}

pub(super) fn accept_word(input: ParseStream, word: &str) -> Result<bool> {
    let ahead = input.peek(Ident::peek_any) && input.fork().call(Ident::parse_any)? == word;
    if ahead {
        input.call(Ident::parse_any)?;
    }
    Ok(ahead)
}

pub(super) fn expect_word(input: ParseStream, word: &str, form: &str) -> Result<()> {
    if accept_word(input, word)? { Ok(()) } else { Err(here(input, format!("expected `{word}`: `{form}`"))) }
}

pub(super) fn body(input: ParseStream) -> Result<Body> {
    docs(input)?;
    let name = name(input, "a body: `rod: mass m at G, inertia J, angle phi;`")?;
    colon(input, "a body is written `name: mass m at G, inertia J, angle phi;`")?;
    let mut body = Body { name, mass: None, inertia: None, angle: None, attitude: None, free: None };
    loop {
        let word = keyword(input, &["mass", "inertia", "angle", "attitude", "free"])?;
        if word == "free" {
            body.free = Some(Region::from(&word));
            match input.parse::<Option<Token![,]>>()? {
                Some(_) => continue,
                None => return Ok(body),
            }
        }
        let value = expression(input)?;
        let twice = match word.to_string().as_str() {
            "mass" => {
                let position = if accept_word(input, "at")? { Some(expression(input)?) } else { None };
                body.mass.replace((value, position)).is_some()
            }
            "inertia" => body.inertia.replace(value).is_some(),
            "attitude" => body.attitude.replace(value).is_some(),
            _ => body.angle.replace(value).is_some(),
        };
        if twice {
            return Err(syn::Error::new(word.span(), format!("body `{}` has its {word} twice", body.name)));
        }
        if input.parse::<Option<Token![,]>>()?.is_none() {
            return Ok(body);
        }
    }
}

pub(super) fn equation(input: ParseStream) -> Result<Equation> {
    docs(input)?;
    let name = name(input, "a named equation: `closure: left = right;`")?;
    colon(input, "an equation has a name: `closure: left = right;`")?;
    let left = expression(input)?;
    equals(input, "an equation has two sides: `closure: left = right;`")?;
    Ok(Equation { name, left, right: expression(input)?, initially: None, is_of_joint: false })
}

/// An equation, and whether it holds at the start if events switch it.
pub(super) fn constraint(input: ParseStream) -> Result<Equation> {
    let equation = equation(input)?;
    Ok(Equation { initially: initially(input)?, ..equation })
}

/// `initially active`, or `initially released`.
pub(super) fn initially(input: ParseStream) -> Result<Option<Activity>> {
    if !accept_word(input, "initially")? {
        return Ok(None);
    }
    let word = keyword(input, &["active", "released"])?;
    Ok(Some(if word == "active" { Activity::Active } else { Activity::Released }))
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
            return Err(here(&content, "the speed of a coordinate is given, `dot(alpha) = ..;`, not of an expression"));
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
    let word = keyword(input, &["line", "slider", "ground", "point", "circle", "curve", "spring", "damper"])?;
    let first = expression(input)?;
    match word.to_string().as_str() {
        "slider" => {
            expect_word(input, "along", "slider A along beta;")?;
            Ok(Shape::Slider { at: first, along: expression(input)? })
        }
        "circle" => {
            expect_word(input, "radius", "circle O radius r;")?;
            let radius = expression(input)?;
            let normal = if accept_word(input, "normal")? { Some(expression(input)?) } else { None };
            Ok(Shape::Circle { at: first, radius, normal })
        }
        name => {
            let mut points = vec![first];
            while input.parse::<Option<Token![,]>>()?.is_some() {
                points.push(expression(input)?);
            }
            let mark = mark(name);
            if matches!(mark, Mark::Spring | Mark::Damper) && points.len() != 2 {
                return Err(syn::Error::new(word.span(), format!("a drawn {name} has two ends: `{name} A, B;`")));
            }
            Ok(Shape::Points { mark, points })
        }
    }
}

fn mark(name: &str) -> Mark {
    match name {
        "line" => Mark::Line,
        "curve" => Mark::Curve,
        "spring" => Mark::Spring,
        "damper" => Mark::Damper,
        "ground" => Mark::Ground,
        _ => Mark::Point,
    }
}

pub(super) fn kernel(input: ParseStream) -> Result<OptionalKernel> {
    let name = keyword(input, &["dynamics_jacobian", "dynamics_sensitivity", "inverse_dynamics"])?;
    Ok(match name.to_string().as_str() {
        "dynamics_jacobian" => OptionalKernel::DynamicsJacobian,
        "dynamics_sensitivity" => OptionalKernel::DynamicsSensitivity,
        _ => OptionalKernel::InverseDynamics,
    })
}
