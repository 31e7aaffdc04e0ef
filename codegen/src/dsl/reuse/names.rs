//! Which names a part of a declaration defines.

use super::words::*;
use crate::dsl::vocabulary::{Block, Word};
use proc_macro2::{Delimiter, Group, Ident, TokenStream, TokenTree};
use std::collections::BTreeMap;
use syn::{Error, Result};

/// Words that introduce a line or a clause, and those with a meaning everywhere.
const WORDS: &str = "mass inertia angle at on along radius about force torque gravity guess line slider ground point circle spring \
    damper potential dissipation length rest stretch rate from to between and through free initially active \
    released rising falling record stop set swap activate release impact restitution after if else t pi e let use \
    as repeat in sum over by linear cubic monotone natural clamped held continued periodic";

/// Refuses a name that could be taken for a word of the language.
pub(super) fn check_free(name: &Ident) -> Result<()> {
    if !WORDS.split_whitespace().any(|word| plain(name) == word) {
        return Ok(());
    }
    let message = format!("`{name}` is a word of the language and cannot name an index or anything in a fragment");
    Err(Error::new(name.span(), message))
}

/// The names given by items that no longer hold repetitions or uses.
pub(super) fn declared(tokens: &[TokenTree]) -> BTreeMap<String, Ident> {
    let mut names = BTreeMap::new();
    for (at, token) in tokens.iter().enumerate() {
        match (token, tokens.get(at + 1)) {
            (TokenTree::Ident(word), Some(TokenTree::Ident(name))) if word == "let" => add(name, &mut names),
            (TokenTree::Ident(block), Some(TokenTree::Group(lines))) if lines.delimiter() == Delimiter::Brace => {
                // In all blocks, a word before a colon is a name too, and a free body has coordinates.
                let block = Block::of(&block.to_string());
                let names_lead = block.is_some_and(Block::names_lead);
                let lines = list(lines.stream());
                let lines = if block == Some(Block::Tables) { without_rows(lines) } else { lines };
                in_block(&lines, names_lead, &mut names);
            }
            _ => {}
        }
    }
    names
}

/// Tables without their rows, which give no names.
fn without_rows(tables: Vec<TokenTree>) -> Vec<TokenTree> {
    let without = |token| match token {
        TokenTree::Group(rows) if rows.delimiter() == Delimiter::Brace => {
            TokenTree::Group(Group::new(Delimiter::Brace, TokenStream::new()))
        }
        other => other,
    };
    tables.into_iter().map(without).collect()
}

fn add(name: &Ident, names: &mut BTreeMap<String, Ident>) {
    names.entry(plain(name)).or_insert_with(|| name.clone());
}

fn in_block(tokens: &[TokenTree], names_lead: bool, names: &mut BTreeMap<String, Ident>) {
    let mut starts = true;
    let mut at = 0;
    while at < tokens.len() {
        if starts && is_punct(tokens.get(at), '#') {
            at += 2;
            continue;
        }
        if let (true, TokenTree::Ident(name)) = (starts, &tokens[at])
            && (names_lead || is_punct(tokens.get(at + 1), ':'))
        {
            add(name, names);
            if is_word(tokens.get(at + 2), "free") {
                ["x", "y", "phi"]
                    .iter()
                    .for_each(|own| add(&Ident::new(&format!("{}_{own}", plain(name)), name.span()), names));
            }
        }
        starts = is_punct(tokens.get(at), ';');
        if let Some(inner) = group(tokens.get(at), Delimiter::Brace) {
            in_block(&list(inner.stream()), names_lead, names);
            starts = true;
        }
        at += 1;
    }
}
