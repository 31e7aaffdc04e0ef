//! Bounds on what is parsed, so that no text can exhaust the stack or take unreasonably long.

use super::Region;
use proc_macro2::{Delimiter, Group, Span, TokenStream, TokenTree};
use syn::{Error, Result};

/// Words of one line in the same brackets, with those of the brackets around and inside: a bound of an expression's
/// depth.
const LONGEST_LINE: usize = 1500;
/// Brackets inside brackets.
const DEEPEST: usize = 64;
/// Brackets inside brackets of a Rust file, with those of its modules and functions.
const DEEPEST_IN_FILE: usize = 200;
/// Characters of a number. One of `f64` has at most 767 digits that count.
const LONGEST_NUMBER: usize = 1000;

/// Rows of tables in one declaration.
const MOST_ROWS: usize = 100_000;

/// Refuses brackets nested too deeply, and lines too long, for recursion over an expression; absurdly long numbers; and too
/// many rows of tables.
pub(super) fn check(tokens: TokenStream) -> Result<()> {
    check_line(tokens.clone(), DEEPEST)?;
    let start = tokens.clone().into_iter().next().map_or_else(Span::call_site, |first| first.span());
    check_rows(rows(tokens)).map_err(|message| Region::from(start).error(message))
}

/// Refuses so many rows of tables.
pub(super) fn check_rows(count: usize) -> std::result::Result<(), String> {
    match count > MOST_ROWS {
        true => Err(format!("the tables of a declaration have at most {MOST_ROWS} rows altogether; give fewer")),
        false => Ok(()),
    }
}

/// Rows of numbers: the ends of lines in blocks that hold nothing else.
fn rows(tokens: TokenStream) -> usize {
    let of_group = |group: Group| match is_of_literals(&group) {
        true => group.stream().into_iter().filter(is_end).count().saturating_sub(usize::from(is_headed(&group))),
        false => rows(group.stream()),
    };
    let groups = tokens.into_iter().filter_map(|token| match token {
        TokenTree::Group(group) => Some(group),
        _ => None,
    });
    groups.map(of_group).sum()
}

/// Whether the first row is a heading.
fn is_headed(rows: &Group) -> bool {
    rows.stream().into_iter().next().is_some_and(|first| first.to_string().starts_with('"'))
}

fn is_end(token: &TokenTree) -> bool {
    matches!(token, TokenTree::Punct(punct) if punct.as_char() == ';')
}

/// Whether a block holds numbers and texts alone, as the rows of a table do.
pub(super) fn is_of_literals(block: &Group) -> bool {
    let is_of_them = |token| matches!(token, TokenTree::Literal(_) | TokenTree::Punct(_));
    block.delimiter() == Delimiter::Brace && block.stream().into_iter().all(is_of_them)
}

/// Refuses brackets nested too deeply in a Rust file.
pub(super) fn check_file(tokens: TokenStream) -> Result<()> {
    check_nesting(tokens, DEEPEST_IN_FILE)
}

/// The largest depth of an expression made of these tokens, in words.
fn check_line(tokens: TokenStream, levels: usize) -> Result<usize> {
    let (mut deepest, mut words, mut inside) = (0, 0, 0);
    for token in tokens {
        let region = Region::from(token.span());
        match token {
            token if is_end(&token) => (words, inside) = (0, 0),
            TokenTree::Group(_) if levels == 0 => return Err(nested(region)),
            TokenTree::Group(group) => {
                inside = check_line(group.stream(), levels - 1)?.max(inside);
                // A block ends its line.
                if group.delimiter() == Delimiter::Brace {
                    (words, inside) = (0, 0);
                }
            }
            TokenTree::Literal(literal) => {
                words += 1;
                let text = literal.to_string();
                if text.len() > LONGEST_NUMBER && text.starts_with(|first: char| first.is_ascii_digit()) {
                    return Err(region.error(format!("a number has at most {LONGEST_NUMBER} characters")));
                }
            }
            _ => words += 1,
        }
        if words + inside > LONGEST_LINE {
            return Err(region.error("this line is too long; name parts of it with `let`"));
        }
        deepest = deepest.max(words + inside);
    }
    Ok(deepest)
}

fn check_nesting(tokens: TokenStream, levels: usize) -> Result<()> {
    let groups = tokens.into_iter().filter_map(|token| match token {
        TokenTree::Group(group) => Some(group),
        _ => None,
    });
    for group in groups {
        match levels {
            0 => return Err(nested(group.span().into())),
            _ => check_nesting(group.stream(), levels - 1)?,
        }
    }
    Ok(())
}

fn nested(place: Region) -> Error {
    place.error("brackets are nested too deeply; name inner parts with `let`")
}
