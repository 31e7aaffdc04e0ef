//! The version of the language that a declaration is written in: `language 1;` may stand first.

use super::Region;
use proc_macro2::{TokenStream, TokenTree};
use syn::Result;

/// The language that is read here.
const LANGUAGE: u32 = 1;

/// The declaration without it.
///
/// # Errors
/// If it is another one, at its number; and if what follows the word is no version.
pub fn without(tokens: TokenStream) -> Result<TokenStream> {
    let first: Vec<TokenTree> = tokens.clone().into_iter().take(3).collect();
    match first.as_slice() {
        [TokenTree::Ident(word), rest @ ..] if word == "language" => match rest {
            [TokenTree::Literal(number), TokenTree::Punct(end)] if end.as_char() == ';' => {
                let region = Region::from(number.span());
                match number.to_string().parse::<u32>() {
                    Ok(LANGUAGE) => Ok(tokens.into_iter().skip(3).collect()),
                    Ok(newer) if newer > LANGUAGE => Err(region.error(format!(
                        "this is written in language {newer}, which this program does not know: it reads language {LANGUAGE}. Take a \
                         newer Linkwright"
                    ))),
                    _ => Err(region.error(format!("the version of the language is {LANGUAGE}: `language {LANGUAGE};`"))),
                }
            }
            _ => Err(Region::from(word.span())
                .error(format!("the version of the language is needed, and a semicolon: `language {LANGUAGE};`"))),
        },
        _ => Ok(tokens),
    }
}
