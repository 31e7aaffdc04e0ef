//! Bounds on what is parsed, so that no text can exhaust the stack.

use super::Region;
use proc_macro2::{Delimiter, TokenStream, TokenTree};

/// Words in one line of the language.
const LONGEST_LINE: usize = 1500;
/// Brackets inside brackets.
const DEEPEST: usize = 64;

/// Refuses brackets nested too deeply, and lines too long, for an expression to be taken apart recursively.
pub(super) fn check(tokens: TokenStream) -> syn::Result<()> {
    check_nesting(tokens, 0).map(|_| ())
}

/// The words in the longest line of these tokens.
fn check_nesting(tokens: TokenStream, depth: usize) -> syn::Result<usize> {
    let (mut longest, mut words) = (0, 0);
    for token in tokens {
        let span = token.span();
        let mistake = |message| Err(Region::from(span).error(message));
        match token {
            TokenTree::Punct(punct) if punct.as_char() == ';' => words = 0,
            TokenTree::Group(_) if depth == DEEPEST => {
                return mistake("brackets are nested too deeply; name inner parts with `let`");
            }
            TokenTree::Group(group) => {
                let inside = check_nesting(group.stream(), depth + 1)?;
                // A block ends its line.
                words = if group.delimiter() == Delimiter::Brace { 0 } else { words + inside };
            }
            _ => words += 1,
        }
        if words > LONGEST_LINE {
            return mistake("this line is too long; name parts of it with `let`");
        }
        longest = longest.max(words);
    }
    Ok(longest)
}
