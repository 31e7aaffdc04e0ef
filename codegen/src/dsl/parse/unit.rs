//! Units in brackets: `[kg*m^2]`, `[m/s^2]`, `[1/s]`, `[W/(m*K)]`.

use crate::dsl::region::here;
use crate::dsl::{Region, Unit};
use proc_macro2::{Delimiter, Group, Literal, Punct, Spacing, Span, TokenStream, TokenTree};
use syn::ext::IdentExt;
use syn::parse::{ParseStream, Parser, Result};
use syn::{Ident, LitInt, Token};

/// Reads the unit that may stand in brackets next.
pub(super) fn optional_unit(input: ParseStream) -> Result<Option<Unit>> {
    if !input.peek(syn::token::Bracket) {
        return Ok(None);
    }
    let content;
    let bracket = syn::bracketed!(content in input);
    let region = Region::from(bracket.span.open()).to(bracket.span.close().into());
    if content.is_empty() {
        return Err(region.error("an empty unit; write `[m]`, or `[1]` for a pure number"));
    }
    unit(&content, region).map(Some)
}

/// Reads the unit that may follow a declared name.
pub(super) fn declared_unit(input: ParseStream, name: &Ident) -> Result<Option<Unit>> {
    if input.peek(Ident::peek_any) {
        let unit = unbracketed_unit(&input.fork()).unwrap_or_default();
        return Err(here(input, format!("a unit stands in brackets: `{name} [{unit}]`")));
    }
    optional_unit(input)
}

/// Reads a unit without brackets from text, such as `mm` or `kg*m^2`.
pub fn parse_unit(text: &str) -> Result<Unit> {
    let whole = Region::from(Span::call_site());
    let tokens = words(text).ok_or_else(|| {
        let degrees = if text.contains('\u{b0}') { "; degrees are `deg`" } else { "" };
        whole.error(format!("`{text}` is not a unit; write it like `m/s^2`{degrees}"))
    })?;
    (|input: ParseStream| unit(input, whole)).parse2(tokens)
}

/// The words of a unit. Read by proc_macro2, each text would be kept as long as its thread lives, to show its lines.
fn words(text: &str) -> Option<TokenStream> {
    let mut open: Vec<Vec<TokenTree>> = vec![Vec::new()];
    let mut rest = text.trim_start();
    while let Some(first) = rest.chars().next() {
        let belongs: fn(char) -> bool = match first {
            '0'..='9' => |c| c.is_ascii_digit(),
            first if is_letter(first) => |c| is_letter(c) || c.is_ascii_digit(),
            _ => |_| false,
        };
        let length = rest.find(|c| !belongs(c)).unwrap_or(rest.len()).max(first.len_utf8());
        let (word, after) = rest.split_at(length);
        let tree = match first {
            '(' if open.len() > DEEPEST => return None,
            '(' => {
                open.push(Vec::new());
                None
            }
            ')' => {
                let inside = TokenStream::from_iter(open.pop()?);
                Some(TokenTree::from(Group::new(Delimiter::Parenthesis, inside)))
            }
            '*' | '/' | '^' | '-' => Some(Punct::new(first, Spacing::Alone).into()),
            '0'..='9' if word.len() > 1 && first == '0' => return None,
            '0'..='9' => Some(Literal::u64_unsuffixed(word.parse().ok()?).into()),
            first if is_letter(first) => Some(Ident::new(word, Span::call_site()).into()),
            _ => return None,
        };
        open.last_mut()?.extend(tree);
        rest = after.trim_start();
    }
    let whole = open.pop()?;
    open.is_empty().then(|| whole.into_iter().collect())
}

/// Parentheses within each other.
const DEEPEST: usize = 100;

/// Of the names of units, micro as its sign and as the Greek letter among them.
fn is_letter(c: char) -> bool {
    c.is_ascii_alphabetic() || c == '_' || ['\u{b5}', '\u{3bc}'].contains(&c)
}

/// The text of a unit that stands without its brackets.
pub(super) fn unbracketed_unit(input: ParseStream) -> Option<String> {
    let mut unit = Unit { region: input.span().into(), factors: Vec::new(), text: String::new() };
    product(input, 1, &mut unit).ok().map(|()| unit.text)
}

fn unit(input: ParseStream, region: Region) -> Result<Unit> {
    let mut unit = Unit { region, factors: Vec::new(), text: String::new() };
    product(input, 1, &mut unit)?;
    if !input.is_empty() {
        return Err(mistake(input));
    }
    Ok(unit)
}

fn mistake(input: ParseStream) -> syn::Error {
    if input.peek(Token![in]) {
        return here(input, "`in` is not a unit; inches are `inch`");
    }
    here(input, "this is not a unit; units are written like `[kg*m^2]`, `[m/s^2]` or `[1/s]`")
}

/// `m`, `m*s`, `m/s/s`, each raised to `sign` times its own exponent.
fn product(input: ParseStream, sign: i32, unit: &mut Unit) -> Result<()> {
    factor(input, sign, unit)?;
    loop {
        if input.parse::<Option<Token![*]>>()?.is_some() {
            unit.text.push('*');
            factor(input, sign, unit)?;
        } else if input.parse::<Option<Token![/]>>()?.is_some() {
            unit.text.push('/');
            factor(input, -sign, unit)?;
        } else {
            return Ok(());
        }
    }
}

fn factor(input: ParseStream, sign: i32, unit: &mut Unit) -> Result<()> {
    if input.peek(syn::token::Paren) {
        let content;
        syn::parenthesized!(content in input);
        unit.text.push('(');
        product(&content, sign, unit)?;
        unit.text.push(')');
        return if content.is_empty() { Ok(()) } else { Err(mistake(&content)) };
    }
    if input.peek(LitInt) {
        let one: LitInt = input.parse()?;
        if one.to_string() != "1" {
            return Err(syn::Error::new(one.span(), "the only number in a unit is 1, as in `[1/s]`"));
        }
        unit.text.push('1');
        return Ok(());
    }
    if !input.peek(syn::Ident) {
        return Err(mistake(input));
    }
    let name: Ident = input.parse()?;
    unit.text += &name.to_string();
    let exponent = if input.parse::<Option<Token![^]>>()?.is_some() { exponent(input, unit)? } else { 1 };
    unit.factors.push((name, sign * exponent));
    Ok(())
}

fn exponent(input: ParseStream, unit: &mut Unit) -> Result<i32> {
    let negative = input.parse::<Option<Token![-]>>()?.is_some();
    let literal: LitInt = input.parse().map_err(|e| syn::Error::new(e.span(), "a unit's exponent is an integer"))?;
    let size = literal.base10_parse::<i32>().ok().filter(|size| (1..=99).contains(size) && literal.suffix().is_empty());
    let size = size.ok_or_else(|| syn::Error::new(literal.span(), "a unit's exponent is an integer from -99 to 99"))?;
    let exponent = if negative { -size } else { size };
    unit.text += &format!("^{exponent}");
    Ok(exponent)
}
