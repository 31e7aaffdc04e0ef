//! Which module imports which.
//!
//! Every path that begins with `crate`, `self` or `super` counts, in `use` as in expressions. A name that a module passes on by
//! `pub use` stands for the module that it comes from.

use super::source::Source;
use proc_macro2::{Delimiter, TokenTree};
use std::collections::{BTreeMap, BTreeSet};

/// For each module those that it imports, by path.
pub type Imports = BTreeMap<String, BTreeSet<String>>;

/// A path as it is written, part by part.
type Written = Vec<String>;

/// A chain of names that are passed on is followed so far.
const MOST_PASSED_ON: usize = 8;

/// Which module imports which; what lies between a module and one inside it is no import.
pub fn imports(source: &Source) -> Imports {
    let passed_on: BTreeMap<&str, BTreeMap<String, Written>> =
        source.modules.iter().map(|(path, module)| (path.as_str(), passed_on(&module.tokens))).collect();
    let of = |(path, tokens): (&String, &Vec<TokenTree>)| {
        let mut written = Vec::new();
        paths(tokens, &mut written);
        let found = written.iter().filter_map(|written| target(source, &passed_on, path, written));
        let others: BTreeSet<String> = found.filter(|other| !are_nested(path, other)).collect();
        (path.clone(), others)
    };
    source.modules.iter().map(|(path, module)| of((path, &module.tokens))).collect()
}

/// Whether one of two modules is inside the other, or they are the same.
fn are_nested(a: &str, b: &str) -> bool {
    let is_inside = |inner: &str, outer: &str| {
        outer.is_empty() || inner == outer || inner.strip_prefix(outer).is_some_and(|rest| rest.starts_with("::"))
    };
    is_inside(a, b) || is_inside(b, a)
}

/// All paths that begin in this crate.
fn paths(tokens: &[TokenTree], found: &mut Vec<Written>) {
    let mut i = 0;
    while i < tokens.len() {
        match &tokens[i] {
            TokenTree::Ident(word) if ["crate", "self", "super"].contains(&word.to_string().as_str()) => {
                i += tree(&tokens[i..], &[], found);
            }
            TokenTree::Group(group) => {
                paths(&group.stream().into_iter().collect::<Vec<_>>(), found);
                i += 1;
            }
            _ => i += 1,
        }
    }
}

/// The paths of a tree, `a::b::{c, d::e}`, that follows others; gives how many tokens it has.
fn tree(tokens: &[TokenTree], before: &[String], found: &mut Vec<Written>) -> usize {
    let (mut path, mut i) = (before.to_vec(), 0);
    loop {
        match tokens.get(i) {
            Some(TokenTree::Ident(word)) => path.push(word.to_string()),
            Some(TokenTree::Group(group)) if group.delimiter() == Delimiter::Brace && i > 0 => {
                let inside: Vec<TokenTree> = group.stream().into_iter().collect();
                let is_comma = |token: &TokenTree| matches!(token, TokenTree::Punct(mark) if mark.as_char() == ',');
                inside.split(is_comma).filter(|part| !part.is_empty()).for_each(|part| {
                    tree(part, &path, found);
                });
                return i + 1;
            }
            _ => break,
        }
        i += 1;
        let is_colon = |at: usize| matches!(tokens.get(at), Some(TokenTree::Punct(mark)) if mark.as_char() == ':');
        if !(is_colon(i) && is_colon(i + 1)) {
            break;
        }
        i += 2;
    }
    found.push(path);
    i.max(1)
}

/// What a module passes on by `pub use`: the name with the path that it comes from.
fn passed_on(tokens: &[TokenTree]) -> BTreeMap<String, Written> {
    let mut names = BTreeMap::new();
    let is_word = |at: usize, word: &str| tokens.get(at).is_some_and(|token| token.to_string() == word);
    for i in 0..tokens.len() {
        let after = match tokens.get(i + 1) {
            Some(TokenTree::Group(_)) => i + 2,
            _ => i + 1,
        };
        if is_word(i, "pub") && is_word(after, "use") {
            let mut written = Vec::new();
            tree(&tokens[after + 1..], &[], &mut written);
            written.into_iter().for_each(|path| {
                names.extend(path.last().cloned().map(|name| (name, path)));
            });
        }
    }
    names
}

/// The module that a path leads to from another, if it is of this crate.
fn target(
    source: &Source,
    passed_on: &BTreeMap<&str, BTreeMap<String, Written>>,
    from: &str,
    written: &[String],
) -> Option<String> {
    let (mut at, mut rest) = (from.to_owned(), written.to_vec());
    for _ in 0..MOST_PASSED_ON {
        (at, rest) = entered(source, &at, &rest)?;
        let Some(path) = rest.first().and_then(|name| passed_on.get(at.as_str())?.get(name)) else { return Some(at) };
        // `pub use child::Name`: as from the module itself.
        rest = path.iter().cloned().chain(rest.into_iter().skip(1)).collect();
        let known = ["crate", "self", "super"].contains(&rest[0].as_str());
        if !known && !source.modules.contains_key(&joined(&at, &rest[0])) {
            return Some(at);
        }
    }
    Some(at)
}

/// The module as deep as a path goes in modules, and what is left of the path.
fn entered(source: &Source, from: &str, written: &[String]) -> Option<(String, Written)> {
    let mut at = from.to_owned();
    for (i, part) in written.iter().enumerate() {
        match part.as_str() {
            "crate" => at.clear(),
            "self" => {}
            "super" => at = at.rsplit_once("::").map_or(String::new(), |(parent, _)| parent.to_owned()),
            name if source.modules.contains_key(&joined(&at, name)) => at = joined(&at, name),
            _ => return Some((at, written[i..].to_vec())),
        }
    }
    Some((at, Vec::new()))
}

fn joined(module: &str, name: &str) -> String {
    if module.is_empty() { name.to_owned() } else { format!("{module}::{name}") }
}
