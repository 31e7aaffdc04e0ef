//! Reuse: fragments and repetition, written out as ordinary blocks before anything is parsed.
//!
//! Words are copied with their places, so that every later mistake shows where the user wrote it. Two passes make a text
//! ordinary: [`repeat`] writes repetitions out and turns indices into numbers and names, [`instance`] puts fragments in
//! place of their uses, with their own names under a prefix. Later stages know of neither.

mod attribute;
mod fragment;
mod index;
mod instance;
mod names;
mod places;
mod repeat;
mod words;

pub use attribute::attributed;

use crate::dsl::limits;
use crate::mistakes::Mistakes;
use crate::nearest;
use fragment::Fragment;
use index::Indices;
use indexmap::IndexMap;
use places::Places;
use proc_macro2::{Ident, Span, TokenStream, TokenTree};
use std::collections::{BTreeMap, BTreeSet};

/// The largest number of words of a declaration when it is written out, without rows of numbers that are written once.
const MOST_WORDS: usize = 50_000;

/// Writes out all fragments and repetitions of a declaration. Input and output are within the limits.
pub(super) fn expand(tokens: TokenStream) -> syn::Result<TokenStream> {
    limits::check(tokens.clone())?;
    if is_written_out(tokens.clone()) {
        return Ok(tokens);
    }
    let written = expand_at(tokens, &mut Places::default())?;
    limits::check(written.clone())?;
    Ok(written)
}

/// Whether there can be nothing to write out, as in most declarations: no word of reuse, and no name that an index may
/// follow.
fn is_written_out(tokens: TokenStream) -> bool {
    let (mut blocks, mut words) = (vec![tokens], 0);
    while let Some(block) = blocks.pop() {
        for token in block {
            words += 1;
            match token {
                TokenTree::Group(group) if limits::is_of_literals(&group) => {}
                TokenTree::Group(group) => blocks.push(group.stream()),
                TokenTree::Ident(word) => {
                    let word = word.to_string();
                    if word.ends_with('_') || ["fragment", "const", "use", "repeat", "sum"].contains(&word.as_str()) {
                        return false;
                    }
                }
                _ => {}
            }
        }
    }
    words <= MOST_WORDS
}

/// Writes out, with control over the places of words.
fn expand_at(tokens: TokenStream, places: &mut Places) -> syn::Result<TokenStream> {
    if is_written_out(tokens.clone()) {
        return Ok(tokens);
    }
    let mut mistakes = Mistakes::default();
    let (fragments, constants, rest) = fragment::collect(tokens, places, &mut mistakes);
    if !mistakes.is_empty() {
        return mistakes.or(TokenStream::new());
    }
    let mut expander = Expander {
        fragments,
        constants,
        places,
        instances: BTreeSet::new(),
        indices: BTreeMap::new(),
        used: BTreeSet::new(),
        arguments: Vec::new(),
        mistakes,
    };
    let expanded = expander.declaration(&rest);
    let Expander { mut mistakes, .. } = expander;
    let expanded = mistakes.note(expanded);
    mistakes.or(expanded.unwrap_or_default().into_iter().collect())
}

/// The state while a declaration is written out.
struct Expander<'p> {
    fragments: IndexMap<String, Fragment>,
    /// The values of `const`s.
    constants: Indices,
    places: &'p mut Places,
    /// Prefixes of the instances so far.
    instances: BTreeSet<String>,
    /// The counters of repetitions and sums, and where they were first named.
    indices: BTreeMap<String, Span>,
    /// Fragments with an instance.
    used: BTreeSet<String>,
    /// Names that are arguments of uses.
    arguments: Vec<Ident>,
    mistakes: Mistakes,
}

impl Expander<'_> {
    fn declaration(&mut self, tokens: &[TokenTree]) -> syn::Result<Vec<TokenTree>> {
        let constants = self.constants.clone();
        let flat = self.unroll(tokens, &constants, places::MECHANISM)?;
        let expanded = self.instantiate(&flat)?;
        let declared = names::declared(&expanded);
        for (name, place) in self.indices.iter().filter(|(name, _)| declared.contains_key(*name)) {
            let message = format!("`{name}` is declared as well; choose another name for the index");
            self.mistakes.add(syn::Error::new(*place, message));
        }
        for argument in self.arguments.iter().filter(|argument| !is_known(argument, &declared)) {
            let near = nearest::suggestion(&words::plain(argument), declared.keys().map(String::as_str));
            self.mistakes.add(syn::Error::new(argument.span(), format!("nothing is called `{argument}`{near}")));
        }
        for (name, fragment) in &self.fragments {
            if !self.used.contains(name) && self.mistakes.is_empty() {
                let message = format!("fragment `{name}` is never used: `use {name}(..) as a_name;`");
                self.mistakes.add(syn::Error::new(fragment.name.span(), message));
            }
        }
        Ok(expanded)
    }

    /// Counts one more word.
    fn count(&mut self, token: &TokenTree, instance: usize) -> syn::Result<()> {
        self.places.words += 1;
        if self.places.words <= MOST_WORDS {
            return Ok(());
        }
        let message = format!("written out, this declaration has more than {MOST_WORDS} words; repeat less often");
        Err(syn::Error::new(self.places.place(token.span(), instance), message))
    }
}

/// Whether something of that name is declared, or has a meaning of its own.
fn is_known(name: &Ident, declared: &BTreeMap<String, Ident>) -> bool {
    declared.contains_key(&words::plain(name)) || ["t", "pi", "e"].iter().any(|known| name == known)
}
