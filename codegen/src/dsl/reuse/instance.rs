//! Fragments in place of their uses.
//!
//! An instance is prepared first, which finds the names it gives, and then written: its own names get its prefix,
//! arguments are put in, and all other names are those of the mechanism. So a name never changes its meaning with the
//! place of use.

use super::fragment::{Use, instance, item_length};
use super::index::Indices;
use super::names::{check_free, declared};
use super::places::MECHANISM;
use super::repeat::regroup;
use super::words::*;
use super::{Expander, Fragment};
use crate::nearest;
use proc_macro2::{Delimiter, Group, Ident, Literal, Punct, Spacing, Span, TokenTree};
use std::collections::{BTreeMap, BTreeSet};
use syn::{Error, Result};

/// Fragments in fragments.
const DEEPEST: usize = 32;

/// Words of the mechanism or of one instance, and the uses among them.
struct Body {
    items: Vec<Item>,
    names: BTreeSet<String>,
}

impl Body {
    /// One more instance, with the names that it gives.
    fn add(&mut self, name: &str, instance: Instance) {
        let arguments = instance.arguments.iter().filter(|argument| !argument.is_put_in());
        let names = instance.body.names.iter().cloned().chain(arguments.map(|argument| plain(&argument.name)));
        self.names.extend(names.map(|inner| format!("{name}_{inner}")));
        self.items.push(Item::Use(instance));
    }
}

enum Item {
    Word(TokenTree),
    Use(Instance),
}

struct Instance {
    /// With those around it: `left_`.
    prefix: String,
    arguments: Vec<Argument>,
    body: Body,
}

/// The replacement of a name.
struct Argument {
    name: Ident,
    words: Vec<TokenTree>,
}

impl Argument {
    /// A name or a number is put in as it is, and so are plain numbers with operators, in parentheses: they are in the
    /// unit of the place. Anything else is named by a `let` of the instance.
    fn is_put_in(&self) -> bool {
        match &self.words[..] {
            [TokenTree::Ident(_) | TokenTree::Literal(_)] => true,
            [TokenTree::Literal(_), TokenTree::Group(_)] => is_unit(&self.words, 1),
            words => is_of_numbers(words),
        }
    }
}

/// The replacements of names.
#[derive(Default)]
struct Scope {
    prefix: String,
    own: BTreeSet<String>,
    arguments: BTreeMap<String, Vec<TokenTree>>,
}

impl Expander<'_> {
    /// Puts fragments in place of their uses in a text without repetitions.
    pub(super) fn instantiate(&mut self, tokens: &[TokenTree]) -> Result<Vec<TokenTree>> {
        let body = self.prepare(tokens, "", &mut Vec::new(), MECHANISM)?;
        let mut out = Vec::new();
        self.write(&body, &Scope::default(), &mut out);
        Ok(out)
    }

    fn prepare(&mut self, tokens: &[TokenTree], prefix: &str, inside: &mut Vec<String>, number: usize) -> Result<Body> {
        let mut body = Body { items: Vec::new(), names: BTreeSet::new() };
        let mut words = Vec::new();
        let mut at = 0;
        while at < tokens.len() {
            if is_word(tokens.get(at), "use") {
                let read = instance(&tokens[at..]).and_then(|(used, length)| {
                    self.prepare_instance(used, prefix, inside).map(|(name, instance)| {
                        body.add(&name, instance);
                        length
                    })
                });
                at += read.unwrap_or_else(|mistake| {
                    self.mistakes.add(mistake);
                    item_length(&tokens[at..])
                });
                continue;
            }
            check_item(tokens, at)?;
            words.push(tokens[at].clone());
            body.items.push(Item::Word(tokens[at].clone()));
            at += 1;
        }
        let own = declared(&words);
        if number != MECHANISM {
            own.values().try_for_each(check_free)?;
        }
        body.names.extend(own.into_keys());
        Ok(body)
    }

    /// One use: the name it gives to the instance, and the instance.
    fn prepare_instance(&mut self, used: Use, outer: &str, inside: &mut Vec<String>) -> Result<(String, Instance)> {
        let fragment = self.find(&used.fragment)?.clone();
        let Use { fragment: name, arguments, prefix } = used;
        self.used.insert(plain(&name));
        if inside.contains(&plain(&name)) || inside.len() == DEEPEST {
            let path = inside.iter().chain([&plain(&name)]).cloned().collect::<Vec<_>>().join(" -> ");
            return Err(Error::new(name.span(), format!("fragments cannot use themselves: {path}")));
        }
        check_arguments(&name, &fragment, &arguments)?;
        let full = format!("{outer}{}", plain(&prefix));
        if !self.instances.insert(full.clone()) {
            return Err(Error::new(
                prefix.span(),
                format!("`{full}` is used twice; choose another name for one of them"),
            ));
        }
        let number = self.places.enter_named(format!("in `{full}`"));
        let indices = bound(&self.constants, &fragment, &arguments);
        let flat = self.unroll(&fragment.body, &indices, number)?;
        let prefix_ = format!("{full}_");
        inside.push(plain(&name));
        let body = self.prepare(&flat, &prefix_, inside, number);
        inside.pop();
        let body = body?;
        if let Some(argument) = fragment.arguments.iter().find(|argument| body.names.contains(&plain(argument))) {
            let message = format!(
                "`{argument}` is an argument of `{name}` and defined in it as well; choose another name for one of them"
            );
            return Err(Error::new(argument.span(), message));
        }
        let named = fragment.arguments.into_iter().zip(arguments);
        let arguments = named.map(|(name, words)| Argument { name, words }).collect();
        Ok((plain(&prefix), Instance { prefix: prefix_, arguments, body }))
    }

    fn find(&self, name: &Ident) -> Result<&Fragment> {
        self.fragments.get(&plain(name)).ok_or_else(|| {
            let near = nearest::suggestion(&plain(name), self.fragments.keys().map(String::as_str));
            Error::new(name.span(), format!("no fragment is called `{name}`{near}: `fragment {name}(..) {{ .. }}`"))
        })
    }

    fn write(&mut self, body: &Body, scope: &Scope, out: &mut Vec<TokenTree>) {
        let words = |items: &[Item]| -> Vec<TokenTree> {
            items
                .iter()
                .filter_map(|item| if let Item::Word(word) = item { Some(word.clone()) } else { None })
                .collect()
        };
        // Words between two uses are renamed together, as the meaning of a word depends on its neighbours.
        for items in body.items.chunk_by(|a, b| matches!((a, b), (Item::Word(_), Item::Word(_)))) {
            match items {
                [Item::Use(instance)] => self.write_instance(instance, scope, out),
                _ => out.extend(self.rename(&words(items), scope)),
            }
        }
    }

    fn write_instance(&mut self, instance: &Instance, outer: &Scope, out: &mut Vec<TokenTree>) {
        let mut scope =
            Scope { prefix: instance.prefix.clone(), own: instance.body.names.clone(), arguments: BTreeMap::new() };
        for argument in &instance.arguments {
            let words = self.rename(&argument.words, outer);
            if let [TokenTree::Ident(name)] = &words[..] {
                self.arguments.push(name.clone());
            }
            let put_in = match (argument.is_put_in(), words.first()) {
                (true, Some(first)) if words.len() > 1 && is_of_numbers(&words) => {
                    let mut numbers = Group::new(Delimiter::Parenthesis, words.iter().cloned().collect());
                    numbers.set_span(first.span());
                    vec![numbers.into()]
                }
                (false, Some(first)) => {
                    let place = first.span();
                    let name = Ident::new(&format!("{}{}", instance.prefix, plain(&argument.name)), place);
                    let [equals, end] = ['=', ';'].map(|mark| {
                        let mut mark = Punct::new(mark, Spacing::Alone);
                        mark.set_span(place);
                        TokenTree::from(mark)
                    });
                    out.extend([Ident::new("let", place).into(), name.clone().into(), equals]);
                    out.extend(words);
                    out.push(end);
                    vec![name.into()]
                }
                _ => words,
            };
            scope.arguments.insert(plain(&argument.name), put_in);
        }
        self.write(&instance.body, &scope, out);
    }

    /// Own names with their prefix, arguments put in.
    fn rename(&mut self, tokens: &[TokenTree], scope: &Scope) -> Vec<TokenTree> {
        if scope.prefix.is_empty() {
            self.refuse_uses(tokens);
            return tokens.to_vec();
        }
        let mut out = Vec::new();
        for (at, token) in tokens.iter().enumerate() {
            match token {
                TokenTree::Group(_) if is_unit(tokens, at) => out.push(token.clone()),
                TokenTree::Group(group) => {
                    let inner = list(group.stream());
                    self.refuse_uses(tokens);
                    let renamed = self.rename(&inner, scope);
                    out.push(regroup(group, renamed, group.span()));
                }
                TokenTree::Ident(name) if is_name(tokens, at) => match scope.arguments.get(&plain(name)) {
                    // A mistake in an argument shows where the argument is used.
                    Some(words) => out.extend(words.iter().map(|word| placed(word, name.span()))),
                    None if scope.own.contains(&plain(name)) => {
                        out.push(Ident::new(&format!("{}{}", scope.prefix, plain(name)), name.span()).into());
                    }
                    None => out.push(token.clone()),
                },
                TokenTree::Literal(title) if is_title(tokens, at) => out.push(titled(title, &scope.prefix)),
                _ => out.push(token.clone()),
            }
        }
        out
    }

    /// A use stands beside blocks.
    fn refuse_uses(&mut self, tokens: &[TokenTree]) {
        for token in tokens {
            let TokenTree::Group(block) = token else { continue };
            let inner = list(block.stream());
            if let Some(misplaced) = inner.iter().find(|token| is_word(Some(token), "use")) {
                self.mistakes.add(Error::new(misplaced.span(), "`use` stands beside blocks, not inside one"));
            }
        }
    }
}

/// Refuses items that belong only in the mechanism itself.
fn check_item(tokens: &[TokenTree], at: usize) -> Result<()> {
    match (&tokens[at], tokens.get(at + 1)) {
        (TokenTree::Ident(word), Some(TokenTree::Ident(_))) if word == "fragment" || word == "const" => {
            let message = format!("`{word}` stands beside the blocks of the mechanism, not inside one");
            Err(Error::new(word.span(), message))
        }
        _ => Ok(()),
    }
}

fn check_arguments(name: &Ident, fragment: &Fragment, arguments: &[Vec<TokenTree>]) -> Result<()> {
    if let Some(empty) = arguments.iter().position(Vec::is_empty) {
        return Err(Error::new(name.span(), format!("argument {} of `{name}` is missing", empty + 1)));
    }
    if arguments.len() == fragment.arguments.len() {
        return Ok(());
    }
    let named = fragment.arguments.iter().map(plain).collect::<Vec<_>>().join(", ");
    let message = match fragment.arguments.len() {
        0 => format!("`{name}` takes no arguments"),
        1 => format!("`{name}` takes one argument, ({named}), not {}", arguments.len()),
        count => format!("`{name}` takes {count} arguments, ({named}), not {}", arguments.len()),
    };
    Err(Error::new(name.span(), message))
}

/// Arguments that are whole numbers can be indices and bounds as well.
fn bound(constants: &Indices, fragment: &Fragment, arguments: &[Vec<TokenTree>]) -> Indices {
    let mut indices = constants.clone();
    for (name, words) in fragment.arguments.iter().zip(arguments) {
        if let Some(value) = whole_number(words) {
            indices.define(&plain(name), value);
        }
    }
    indices
}

/// Whether a word is a name: not a component, and not the keyword after a label, as in `elbow: pin A to B;`.
fn is_name(tokens: &[TokenTree], at: usize) -> bool {
    let labelled = at > 0 && is_punct(tokens.get(at - 1), ':');
    let next = tokens.get(at + 1);
    let says_what = labelled && (ident(next).is_some() || group(next, Delimiter::Bracket).is_some());
    !is_component(tokens, at) && !says_what
}

/// The same word at another place.
fn placed(word: &TokenTree, place: Span) -> TokenTree {
    if let TokenTree::Group(group) = word {
        return regroup(group, list(group.stream()).iter().map(|word| placed(word, place)).collect(), place);
    }
    let mut word = word.clone();
    word.set_span(place);
    word
}

/// The title of a group of outputs.
fn is_title(tokens: &[TokenTree], at: usize) -> bool {
    at > 0 && ident(tokens.get(at - 1)).is_some() && group(tokens.get(at + 1), Delimiter::Brace).is_some()
}

/// The titles of figures name their instance.
fn titled(title: &Literal, prefix: &str) -> TokenTree {
    let Some(text) = text(title) else { return title.clone().into() };
    let mut titled = Literal::string(&format!("{text}, {}", prefix.trim_end_matches('_').replace('_', " ")));
    titled.set_span(title.span());
    titled.into()
}
