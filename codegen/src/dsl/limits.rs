//! Bounds on what is parsed, so that no text can exhaust the stack or take unreasonably long.

use super::Region;
use proc_macro2::{Delimiter, TokenStream, TokenTree};
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

/// Refuses brackets nested too deeply, and lines too long, for recursion over an expression; and absurdly long numbers.
pub(super) fn check(tokens: TokenStream) -> Result<()> {
    check_line(tokens, DEEPEST).map(|_| ())
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
            TokenTree::Punct(punct) if punct.as_char() == ';' => (words, inside) = (0, 0),
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
