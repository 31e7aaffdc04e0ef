//! `if a > b then x else y`.

use super::{expression, sum};
use crate::dsl::parse::words::{accept_word, expect_word};
use crate::dsl::region::here;
use crate::dsl::{Choice, Comparison, Expression, Kind, Region};
use proc_macro2::TokenTree;
use syn::ext::IdentExt;
use syn::parse::{ParseStream, Result};
use syn::{Ident, Token};

const FORM: &str = "if a > b then x else y";

/// Whether a choice comes next.
pub(super) fn starts(input: ParseStream) -> bool {
    input.peek(Ident::peek_any) && input.fork().call(Ident::parse_any).is_ok_and(|word| word == "if")
}

pub(super) fn choice(input: ParseStream) -> Result<Expression> {
    let word = input.call(Ident::parse_any)?;
    let (left, comparison, right) = condition(input)?;
    expect_word(input, "then", FORM)?;
    let yes = expression(input)?;
    expect_word(input, "else", FORM)?;
    let no = expression(input)?;
    let region = Region::from(&word).to(no.region);
    Ok(Expression { region, kind: Kind::If(Box::new(Choice { left, comparison, right, yes, no })) })
}

/// A comparison, in parentheses or without.
fn condition(input: ParseStream) -> Result<(Expression, Comparison, Expression)> {
    if is_in_parentheses(input) {
        let content;
        syn::parenthesized!(content in input);
        let compared = compared(&content)?;
        return match content.is_empty() {
            true => Ok(compared),
            false => Err(here(&content, format!("a choice is written `{FORM}`"))),
        };
    }
    compared(input)
}

fn is_in_parentheses(input: ParseStream) -> bool {
    let ahead = input.fork();
    let group = ahead.parse::<TokenTree>();
    matches!(group, Ok(TokenTree::Group(_))) && (ahead.is_empty() || accept_word(&ahead, "then").unwrap_or(false))
}

fn compared(input: ParseStream) -> Result<(Expression, Comparison, Expression)> {
    let left = sum(input)?;
    let comparison = comparison(input)?;
    let right = sum(input)?;
    match is_comparison(input) {
        true => Err(here(input, "one comparison at a time; for a range write one `if` inside another")),
        false => Ok((left, comparison, right)),
    }
}

fn is_comparison(input: ParseStream) -> bool {
    input.peek(Token![<]) || input.peek(Token![>]) || input.peek(Token![=]) || input.peek(Token![!])
}

fn comparison(input: ParseStream) -> Result<Comparison> {
    Ok(match () {
        _ if input.parse::<Option<Token![<=]>>()?.is_some() => Comparison::AtMost,
        _ if input.parse::<Option<Token![>=]>>()?.is_some() => Comparison::AtLeast,
        _ if input.parse::<Option<Token![<]>>()?.is_some() => Comparison::Less,
        _ if input.parse::<Option<Token![>]>>()?.is_some() => Comparison::Greater,
        _ if input.peek(Token![=]) || input.peek(Token![==]) || input.peek(Token![!=]) => {
            return Err(here(
                input,
                "varying quantities are equal only for an instant; compare with `<`, `<=`, `>` or `>=`",
            ));
        }
        _ => return Err(here(input, format!("expected a comparison, `<`, `<=`, `>` or `>=`: `{FORM}`"))),
    })
}
