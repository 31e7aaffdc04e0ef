//! The items for reuse beside the blocks: `fragment Leg(hip, phi) { .. }`, `const n = 5;` and `use Leg(P, alpha) as
//! left;`, read.

use super::index::{Indices, not_whole, whole};
use super::names::check_free;
use super::places::{MECHANISM, Places};
use super::words::*;
use crate::mistakes::Mistakes;
use indexmap::IndexMap;
use proc_macro2::{Delimiter, Ident, TokenStream, TokenTree};
use syn::ext::IdentExt;
use syn::parse::{ParseStream, Parser, Result};
use syn::{Error, Token};

/// A part of a declaration with arguments.
#[derive(Clone)]
pub(super) struct Fragment {
    pub(super) name: Ident,
    pub(super) arguments: Vec<Ident>,
    pub(super) body: Vec<TokenTree>,
}

/// `use Leg(P, alpha) as left;`
pub(super) struct Use {
    pub(super) fragment: Ident,
    pub(super) arguments: Vec<Vec<TokenTree>>,
    pub(super) prefix: Ident,
}

/// Takes fragments and constants out of a declaration.
pub(super) fn collect(
    tokens: TokenStream,
    places: &Places,
    mistakes: &mut Mistakes,
) -> (IndexMap<String, Fragment>, Indices, Vec<TokenTree>) {
    let tokens = list(tokens);
    let (mut fragments, mut constants, mut rest) = (IndexMap::new(), Indices::default(), Vec::new());
    let mut at = 0;
    while at < tokens.len() {
        let starts = starts_item(&rest);
        let taken = if starts && is_word(tokens.get(at), "fragment") {
            fragment(&tokens[at..], &mut fragments)
        } else if starts && is_word(tokens.get(at), "const") {
            constant(&tokens[at..], &mut constants)
        } else {
            rest.push(tokens[at].clone());
            at += 1;
            continue;
        };
        drop_documentation(&mut rest);
        at += taken.unwrap_or_else(|all| {
            for mistake in all {
                mistakes.add(Error::new(places.place(mistake.span(), MECHANISM), mistake));
            }
            item_length(&tokens[at..])
        });
    }
    (fragments, constants, rest)
}

/// Whether a new item starts after these.
fn starts_item(before: &[TokenTree]) -> bool {
    let last = before.last();
    let documented = before.len() > 1 && is_punct(before.get(before.len() - 2), '#');
    last.is_none() || is_punct(last, ';') || group(last, Delimiter::Brace).is_some() || documented
}

/// Up to the next `;` or block.
pub(super) fn item_length(tokens: &[TokenTree]) -> usize {
    let ends = |token: &TokenTree| is_punct(Some(token), ';') || group(Some(token), Delimiter::Brace).is_some();
    tokens.iter().position(ends).map_or(tokens.len(), |end| end + 1)
}

fn fragment(tokens: &[TokenTree], fragments: &mut IndexMap<String, Fragment>) -> Result<usize> {
    const FORM: &str = "a fragment is written `fragment Leg(hip, phi) { .. }`";
    let form = |at: usize| Error::new(tokens.get(at).unwrap_or(&tokens[0]).span(), FORM);
    let name = ident(tokens.get(1)).ok_or_else(|| form(1))?;
    let arguments = group(tokens.get(2), Delimiter::Parenthesis);
    let at = if arguments.is_some() { 3 } else { 2 };
    let body = group(tokens.get(at), Delimiter::Brace).ok_or_else(|| form(at))?;
    let mut named: Vec<Ident> = Vec::new();
    for argument in split(&arguments.map_or_else(Vec::new, |arguments| list(arguments.stream()))) {
        let [TokenTree::Ident(argument)] = argument else {
            let place = argument.first().map_or_else(|| tokens[2].span(), TokenTree::span);
            return Err(Error::new(place, "the arguments of a fragment are names, separated by commas"));
        };
        check_free(argument)?;
        if named.iter().any(|known| plain(known) == plain(argument)) {
            return Err(Error::new(argument.span(), format!("there are two arguments called `{argument}`")));
        }
        named.push(argument.clone());
    }
    let fragment = Fragment { name: name.clone(), arguments: named, body: list(body.stream()) };
    if let Some(first) = fragments.get(&plain(name)) {
        let mut mistake =
            Error::new(name.span(), format!("`{name}` is defined twice; choose another name for one of them"));
        mistake.combine(Error::new(first.name.span(), format!("the first definition of `{name}` is here")));
        return Err(mistake);
    }
    fragments.insert(plain(name), fragment);
    Ok(at + 1)
}

fn constant(tokens: &[TokenTree], constants: &mut Indices) -> Result<usize> {
    const FORM: &str = "a constant is a whole number with a name: `const n = 5;`";
    let length = item_length(tokens);
    let parser = |input: ParseStream| {
        input.parse::<Token![const]>()?;
        let name = input.call(Ident::parse_any).map_err(|e| Error::new(e.span(), FORM))?;
        check_free(&name)?;
        input.parse::<Token![=]>().map_err(|e| Error::new(e.span(), FORM))?;
        let value = whole(input, constants)?;
        if input.peek(Token![;]) { input.parse::<Token![;]>().map(|_| (name, value)) } else { Err(not_whole(input)) }
    };
    let (name, value) = parser.parse2(tokens[..length].iter().cloned().collect())?;
    if constants.get(&plain(&name)).is_some() {
        return Err(Error::new(name.span(), format!("`{name}` is defined twice; choose another name for one of them")));
    }
    constants.define(&plain(&name), value);
    Ok(length)
}

/// Reads a use, and gives how many words it has.
pub(super) fn instance(tokens: &[TokenTree]) -> Result<(Use, usize)> {
    const FORM: &str = "a fragment is used by `use Leg(P, alpha) as left;`";
    let form = |at: usize| Error::new(tokens.get(at).unwrap_or(&tokens[0]).span(), FORM);
    let fragment = ident(tokens.get(1)).ok_or_else(|| form(1))?;
    let arguments = group(tokens.get(2), Delimiter::Parenthesis);
    let at = if arguments.is_some() { 3 } else { 2 };
    if !is_word(tokens.get(at), "as") {
        return Err(form(at));
    }
    let prefix = ident(tokens.get(at + 1)).ok_or_else(|| form(at + 1))?;
    if !is_punct(tokens.get(at + 2), ';') {
        return Err(form(at + 2));
    }
    let arguments = list(arguments.map(|arguments| arguments.stream()).unwrap_or_default());
    let arguments = split(&arguments).into_iter().map(<[TokenTree]>::to_vec).collect();
    Ok((Use { fragment: fragment.clone(), arguments, prefix: prefix.clone() }, at + 3))
}
