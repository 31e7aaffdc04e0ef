//! Expressions, by precedence climbing: sums, products, unary minus, powers (right-associative), components.
//!
//! Rust's own expression parser would put `^` below `+`.

mod choice;

use super::unit::{optional_unit, unbracketed_unit};
use crate::dsl::region::here;
use crate::dsl::vocabulary::{BodyWord, LoadWord, RestWord, ShapeWord, Word};
use crate::dsl::{Expression, Kind, Operator, Region};
use syn::ext::IdentExt;
use syn::parse::{ParseStream, Result};
use syn::{Ident, Lit, Token};

/// Words that may follow an expression in a line of the language.
const FOLLOWING_WORDS: [&str; 20] = [
    "at",
    "on",
    "along",
    "radius",
    "normal",
    "axis",
    "pitch",
    "about",
    "from",
    "to",
    "between",
    "and",
    "through",
    "initially",
    "rising",
    "falling",
    "restitution",
    "then",
    "else",
    "by",
];

/// Whether a word starts a clause or a line of the language in which expressions stand.
fn starts_clause(word: &Ident) -> bool {
    let texts = [BodyWord::texts(), LoadWord::texts(), RestWord::texts(), ShapeWord::texts()].concat();
    texts.into_iter().chain(["guess", "dot", "smooth"]).any(|text| word == text)
}

/// What to write instead of words that users would try after an equation.
const DIRECTION: &str = "crossings in one direction are written `rising` or `falling`: `top: dot(y) = 0 falling;`";
const SWITCHED: &str =
    "a constraint that events switch is written with `initially`: `contact: y = 0 initially released;`";
const ADVICE: [(&str, &str); 11] = [
    ("up", DIRECTION),
    ("down", DIRECTION),
    ("upwards", DIRECTION),
    ("downwards", DIRECTION),
    ("increasing", DIRECTION),
    ("decreasing", DIRECTION),
    ("crossing", DIRECTION),
    ("active", SWITCHED),
    ("inactive", SWITCHED),
    ("released", SWITCHED),
    ("when", SWITCHED),
];

/// Reads one expression.
pub(super) fn expression(input: ParseStream) -> Result<Expression> {
    if choice::starts(input) {
        return choice::choice(input);
    }
    let sum = sum(input)?;
    if input.peek(Token![<]) || input.peek(Token![>]) {
        return Err(here(input, "a comparison stands in a choice: `if a > b then x else y`"));
    }
    if input.peek(Token![%]) {
        return Err(here(input, "there is no operator `%`"));
    }
    if input.peek(Token![==]) {
        return Err(here(input, "an equation is written with one `=`"));
    }
    Ok(sum)
}

fn sum(input: ParseStream) -> Result<Expression> {
    let mut left = product(input)?;
    loop {
        let operator = match () {
            _ if input.parse::<Option<Token![+]>>()?.is_some() => Operator::Add,
            _ if input.parse::<Option<Token![-]>>()?.is_some() => Operator::Subtract,
            _ => return Ok(left),
        };
        left = binary(operator, left, product(input)?);
    }
}

fn product(input: ParseStream) -> Result<Expression> {
    let mut left = signed(input)?;
    loop {
        let operator = match () {
            _ if input.parse::<Option<Token![*]>>()?.is_some() => Operator::Multiply,
            _ if input.parse::<Option<Token![/]>>()?.is_some() => Operator::Divide,
            _ => return Ok(left),
        };
        if operator == Operator::Multiply && input.peek(Token![*]) {
            return Err(here(input, "a power is written `^`: `x^2`, not `x**2`"));
        }
        left = binary(operator, left, signed(input)?);
    }
}

fn signed(input: ParseStream) -> Result<Expression> {
    if input.peek(Token![-]) {
        let minus: Token![-] = input.parse()?;
        let operand = signed(input)?;
        let region = Region::from(minus.span).to(operand.region);
        return Ok(Expression { region, kind: Kind::Negate(Box::new(operand)) });
    }
    power(input)
}

fn power(input: ParseStream) -> Result<Expression> {
    let base = component(input)?;
    if input.parse::<Option<Token![^]>>()?.is_none() {
        return Ok(base);
    }
    Ok(binary(Operator::Power, base, signed(input)?))
}

fn binary(operator: Operator, left: Expression, right: Expression) -> Expression {
    let region = left.region.to(right.region);
    Expression { region, kind: Kind::Binary(operator, Box::new(left), Box::new(right)) }
}

fn component(input: ParseStream) -> Result<Expression> {
    let mut value = atom(input)?;
    while input.parse::<Option<Token![.]>>()?.is_some() {
        let name = Ident::parse_any(input).map_err(|e| syn::Error::new(e.span(), "a component is `.x` or `.y`"))?;
        if input.peek(syn::token::Paren) {
            return Err(syn::Error::new(name.span(), format!("functions stand in front: `{name}(..)`")));
        }
        let region = value.region.to((&name).into());
        value = Expression { region, kind: Kind::Component(Box::new(value), name) };
    }
    juxtaposition(input, &value)?;
    Ok(value)
}

fn atom(input: ParseStream) -> Result<Expression> {
    if input.peek(Lit) {
        return number(input);
    }
    if input.peek(syn::token::Paren) {
        let content;
        let paren = syn::parenthesized!(content in input);
        let mut inner = expression(&content)?;
        if content.peek(Token![,]) {
            return Err(here(&content, "a vector is written in square brackets: `[x, y]`"));
        }
        finish(&content, "`)`")?;
        inner.region = Region::from(paren.span.open()).to(paren.span.close().into());
        return Ok(inner);
    }
    if input.peek(syn::token::Bracket) {
        let content;
        let bracket = syn::bracketed!(content in input);
        let region = Region::from(bracket.span.open()).to(bracket.span.close().into());
        return Ok(Expression { region, kind: Kind::Vector(list(&content, "`]`")?) });
    }
    if choice::starts(input) {
        return Err(here(input, "a choice inside an operation stands in parentheses: `a + (if b > c then x else y)`"));
    }
    if input.peek(Ident::peek_any) {
        let name = Ident::parse_any(input)?;
        return if input.peek(syn::token::Paren) { call(input, name) } else { Ok(named(name)) };
    }
    if input.peek(Token![.]) {
        return Err(here(input, "a decimal number has a digit before its point: `0.5`"));
    }
    Err(here(input, "an expression is missing here: a number, a name, a vector `[x, y]` or `(..)`"))
}

fn named(name: Ident) -> Expression {
    Expression { region: (&name).into(), kind: Kind::Name(name) }
}

fn call(input: ParseStream, name: Ident) -> Result<Expression> {
    let content;
    let paren = syn::parenthesized!(content in input);
    let region = Region::from(&name).to(paren.span.close().into());
    Ok(Expression { region, kind: Kind::Call(name, list(&content, "`)`")?) })
}

/// Expressions between commas, up to the end of the brackets.
fn list(content: ParseStream, closing: &str) -> Result<Vec<Expression>> {
    let mut items = Vec::new();
    while !content.is_empty() {
        items.push(expression(content)?);
        if !content.is_empty() && content.parse::<Option<Token![,]>>()?.is_none() {
            return Err(here(content, format!("expected `,` or {closing}")));
        }
    }
    Ok(items)
}

fn finish(content: ParseStream, closing: &str) -> Result<()> {
    if content.is_empty() { Ok(()) } else { Err(here(content, format!("expected an operator or {closing}"))) }
}

fn number(input: ParseStream) -> Result<Expression> {
    let literal: Lit = input.parse()?;
    let (digits, suffix) = match &literal {
        Lit::Int(int) => (int.base10_digits().to_owned(), int.suffix().to_owned()),
        Lit::Float(float) => (float.base10_digits().to_owned(), float.suffix().to_owned()),
        _ => return Err(syn::Error::new(literal.span(), "a number is written like `9.81` or `1.5e-3`")),
    };
    if !suffix.is_empty() {
        let message =
            format!("a unit stands in brackets: `{digits} [{suffix}]`; a product is written `{digits}*{suffix}`");
        return Err(syn::Error::new(literal.span(), message));
    }
    if literal
        .span()
        .source_text()
        .is_some_and(|text| text.starts_with("0x") || text.starts_with("0b") || text.starts_with("0o"))
    {
        return Err(syn::Error::new(literal.span(), "numbers are decimal, like `9.81` or `1.5e-3`"));
    }
    let mut region = Region::from(literal.span());
    let unit = optional_unit(input)?;
    if let Some(unit) = &unit {
        region = region.to(unit.region);
    }
    Ok(Expression { region, kind: Kind::Number { literal: digits, unit } })
}

/// Refuses two operands side by side, with the advice that fits.
fn juxtaposition(input: ParseStream, left: &Expression) -> Result<()> {
    if input.peek(syn::token::Bracket) && matches!(left.kind, Kind::Name(_)) {
        return Err(here(
            input,
            "a unit stands after a number or in a declaration; a name has the unit it was declared with. \
             For a product with a vector write `*` before `[`",
        ));
    }
    // syn takes a minus sign and a number as one literal.
    let number = input.peek(Lit) && !input.peek(Token![-]);
    if input.peek(syn::token::Bracket) || input.peek(syn::token::Paren) || number {
        return Err(here(input, "an operator is missing here; a product is written `a*b`"));
    }
    if !input.peek(Ident::peek_any) {
        return Ok(());
    }
    let word = input.fork().call(Ident::parse_any)?;
    if FOLLOWING_WORDS.iter().any(|following| word == following) {
        return Ok(());
    }
    if word.span().start().line > left.region.end().end().line {
        return Err(syn::Error::new(word.span(), format!("`;` is missing at the end of the line above `{word}`")));
    }
    if let Some((_, advice)) = ADVICE.iter().find(|(tried, _)| word == tried) {
        return Err(syn::Error::new(word.span(), *advice));
    }
    if starts_clause(&word) {
        return Err(syn::Error::new(word.span(), format!("`,` or `;` is missing before `{word}`")));
    }
    match &left.kind {
        Kind::Number { literal, unit: None } => {
            let unit = unbracketed_unit(&input.fork()).unwrap_or_else(|| word.to_string());
            let message =
                format!("a unit stands in brackets: `{literal} [{unit}]`; a product is written `{literal}*{word}`");
            Err(syn::Error::new(word.span(), message))
        }
        _ => Err(syn::Error::new(word.span(), format!("an operator or `;` is missing before `{word}`"))),
    }
}
