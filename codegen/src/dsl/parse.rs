//! The frame of a declaration: its head and its blocks. A mistake in one line does not hide the next.

use super::block;
use super::event;
use super::region::here;
use super::*;
use crate::mistakes::Mistakes;
use proc_macro2::{TokenStream, TokenTree};
use syn::ext::IdentExt;
use syn::parse::{ParseStream, Parser, Result};
use syn::{Ident, Token, Visibility};

const BLOCKS: [&str; 15] = [
    "coordinates",
    "parameters",
    "bodies",
    "loads",
    "constraints",
    "initial",
    "events",
    "outputs",
    "drawing",
    "kernels",
    "auxiliary",
    "inputs",
    "joints",
    "tables",
    "speeds",
];

/// Documentation, visibility and name: all that is needed to stand in for a mechanism that has mistakes.
#[derive(Clone)]
pub struct Head {
    /// Documentation, one line each.
    pub docs: String,
    /// `pub` and its like.
    pub visibility: Visibility,
    /// The type's name.
    pub name: Ident,
}

/// Reads only the head.
///
/// # Errors
/// Where the head itself is not `/// docs  pub Name;`.
pub fn parse_head(tokens: TokenStream) -> Result<Head> {
    // The rest may be beyond the limits.
    let mut is_open = true;
    let ends = |token: &TokenTree| matches!(token, TokenTree::Punct(punct) if punct.as_char() == ';');
    let words = tokens.into_iter().take_while(|token| std::mem::replace(&mut is_open, !ends(token)));
    let words: TokenStream = words.collect();
    limits::check(words.clone())?;
    head.parse2(words)
}

/// Reads a whole declaration.
///
/// # Errors
/// All mistakes of form, each at the user's own word, combined into one error.
pub fn parse(tokens: TokenStream) -> Result<Declaration> {
    let mut declaration = declaration.parse2(super::reuse::expand(tokens)?)?;
    super::axes::write_out(&mut declaration);
    super::free::give_coordinates(&mut declaration)?;
    super::spanning_tree::place_bodies(&mut declaration)?;
    super::frame::write_out(declaration)
}

fn head(input: ParseStream) -> Result<Head> {
    const FORM: &str = "a declaration starts with the mechanism's name: `pub QuickReturn;`";
    let docs = block::docs(input)?;
    let visibility: Visibility = input.parse()?;
    let name = block::name(input, FORM).map_err(|e| syn::Error::new(e.span(), FORM))?;
    if BLOCKS.iter().any(|block| name == block) {
        return Err(syn::Error::new(name.span(), FORM));
    }
    let taken = match name.unraw().to_string().as_str() {
        "S" => "stands for the scalar in what is generated",
        "sim" | "sim_kernel" | "core" | "alloc" | "std" => "is a crate, which paths here would no longer find",
        _ => "",
    };
    if !taken.is_empty() {
        return Err(syn::Error::new(name.span(), format!("`{name}` {taken}; choose another name")));
    }
    if input.parse::<Option<Token![;]>>()?.is_none() {
        return Err(here(input, FORM));
    }
    Ok(Head { docs, visibility, name })
}

fn declaration(input: ParseStream) -> Result<Declaration> {
    let mut declaration = Declaration {
        head: head(input)?,
        coordinates: vec![],
        parameters: vec![],
        lets: vec![],
        bodies: vec![],
        loads: vec![],
        constraints: vec![],
        initial: vec![],
        events: vec![],
        outputs: vec![],
        drawing: vec![],
        kernels: None,
        auxiliary: vec![],
        inputs: vec![],
        joints: vec![],
        tables: vec![],
        speeds: vec![],
    };
    let mut mistakes = Mistakes::default();
    while !input.is_empty() {
        if let Err(mistake) = item(input, &mut declaration, &mut mistakes) {
            mistakes.add(mistake);
            skip_line(input)?;
        }
    }
    mistakes.or(declaration)
}

/// One `let` or one block.
fn item(input: ParseStream, declaration: &mut Declaration, mistakes: &mut Mistakes) -> Result<()> {
    block::docs(input)?;
    if input.peek(Token![let]) {
        declaration.lets.push(ended(block::definition)(input)?);
        return Ok(());
    }
    let list = || BLOCKS.map(|word| format!("`{word}`")).join(", ");
    let word = Ident::parse_any(input)
        .map_err(|e| syn::Error::new(e.span(), format!("expected `let` or a block: {}", list())))?;
    if !BLOCKS.iter().any(|block| word == block) {
        let near = crate::nearest::block(&word.to_string(), &BLOCKS);
        return Err(syn::Error::new(word.span(), format!("`{word}` is not a block{near}; blocks are {}", list())));
    }
    if !input.peek(syn::token::Brace) {
        return Err(here(input, format!("expected `{{`: `{word} {{ .. }}`")));
    }
    let content;
    syn::braced!(content in input);
    let d = declaration;
    match word.to_string().as_str() {
        "coordinates" => {
            d.coordinates.extend(mistakes.note(lines(&content, ended(block::coordinate))).into_iter().flatten())
        }
        "parameters" => {
            d.parameters.extend(mistakes.note(lines(&content, ended(block::parameter))).into_iter().flatten())
        }
        "bodies" => d.bodies.extend(mistakes.note(lines(&content, ended(block::body))).into_iter().flatten()),
        "loads" => d.loads.extend(mistakes.note(lines(&content, ended(super::load::load))).into_iter().flatten()),
        "constraints" => {
            d.constraints.extend(mistakes.note(lines(&content, ended(block::constraint))).into_iter().flatten())
        }
        "initial" => d.initial.extend(mistakes.note(lines(&content, ended(block::initial))).into_iter().flatten()),
        "events" => d.events.extend(mistakes.note(lines(&content, event::event)).into_iter().flatten()),
        "outputs" => d.outputs.extend(mistakes.note(lines(&content, block::output_group)).into_iter().flatten()),
        "inputs" => d.inputs.extend(mistakes.note(lines(&content, ended(block::input))).into_iter().flatten()),
        "kernels" => {
            let kernels = mistakes.note(lines(&content, ended(block::kernel))).into_iter().flatten();
            d.kernels.get_or_insert_default().extend(kernels);
        }
        "tables" => d.tables.extend(mistakes.note(lines(&content, super::table::table)).into_iter().flatten()),
        "joints" => d.joints.extend(mistakes.note(lines(&content, ended(super::joint::joint))).into_iter().flatten()),
        "auxiliary" => {
            d.auxiliary.extend(mistakes.note(lines(&content, ended(block::auxiliary))).into_iter().flatten())
        }
        "speeds" => {
            for (speed, definition) in mistakes.note(lines(&content, ended(block::speed))).into_iter().flatten() {
                d.speeds.push(speed);
                d.lets.push(definition);
            }
        }
        _ => d.drawing.extend(mistakes.note(lines(&content, ended(block::shape))).into_iter().flatten()),
    }
    Ok(())
}

/// The lines of a block. All of their mistakes come together.
pub(super) fn lines<T>(content: ParseStream, parse: impl Fn(ParseStream) -> Result<T>) -> Result<Vec<T>> {
    let mut parsed = Vec::new();
    let mut mistakes = Mistakes::default();
    while !content.is_empty() {
        match parse(content) {
            Ok(item) => parsed.push(item),
            Err(mistake) => {
                mistakes.add(mistake);
                skip_line(content)?;
            }
        }
    }
    mistakes.or(parsed)
}

/// An item and the `;` after it.
pub(super) fn ended<T>(parse: impl Fn(ParseStream) -> Result<T>) -> impl Fn(ParseStream) -> Result<T> {
    move |input| {
        let item = parse(input)?;
        match input.parse::<Option<Token![;]>>()? {
            Some(_) => Ok(item),
            None => Err(here(input, "expected `;` at the end of this line")),
        }
    }
}

/// Drops tokens up to and including the next `;` or block.
fn skip_line(input: ParseStream) -> Result<()> {
    while !input.is_empty() {
        match input.parse::<TokenTree>()? {
            TokenTree::Punct(punct) if punct.as_char() == ';' => break,
            TokenTree::Group(group) if group.delimiter() == proc_macro2::Delimiter::Brace => break,
            _ => {}
        }
    }
    Ok(())
}
