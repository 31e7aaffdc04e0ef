//! The blocks of a declaration. A mistake in one line does not hide the next.

mod block;
mod equation;
mod event;
mod expression;
mod frame;
mod head;
mod joint;
mod lines;
mod load;
mod run_line;
mod spatial_joint;
mod table_lines;
mod unit;
mod words;

pub use head::parse_head;
pub use unit::parse_unit;

use super::region::here;
use super::vocabulary::{Block, Word};
use super::{Declaration, Frame, Let};
use crate::mistakes::Mistakes;
use crate::nearest;
use head::head;
use lines::{ended, lines, skip_line};
use proc_macro2::TokenStream;
use syn::ext::IdentExt;
use syn::parse::{ParseStream, Parser, Result};
use syn::{Ident, Token};

/// Reads a declaration in which nothing is repeated or used.
pub(super) fn declaration(tokens: TokenStream) -> Result<Declaration> {
    read.parse2(tokens)
}

fn read(input: ParseStream) -> Result<Declaration> {
    let mut declaration = Declaration {
        head: head(input)?,
        coordinates: vec![],
        parameters: vec![],
        lets: vec![],
        bodies: vec![],
        frames: vec![],
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
        run: vec![],
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
    words::docs(input)?;
    if input.peek(Token![let]) {
        declaration.lets.push(ended(block::definition)(input)?);
        return Ok(());
    }
    let list = || words::list::<Block>();
    let word = Ident::parse_any(input)
        .map_err(|e| syn::Error::new(e.span(), format!("expected `let` or a block: {}", list())))?;
    let Some(block) = Block::of(&word.to_string()) else {
        let near = near(&word.to_string());
        return Err(syn::Error::new(word.span(), format!("`{word}` is not a block{near}; blocks are {}", list())));
    };
    if !input.peek(syn::token::Brace) {
        return Err(here(input, format!("expected `{{`: `{word} {{ .. }}`")));
    }
    let content;
    syn::braced!(content in input);
    let d = declaration;
    match block {
        Block::Coordinates => {
            d.coordinates.extend(mistakes.note(lines(&content, ended(block::coordinate))).into_iter().flatten())
        }
        Block::Parameters => {
            d.parameters.extend(mistakes.note(lines(&content, ended(block::parameter))).into_iter().flatten())
        }
        Block::Bodies => d.bodies.extend(mistakes.note(lines(&content, ended(block::body))).into_iter().flatten()),
        Block::Frames => frames(mistakes.note(lines(&content, ended(frame::frame))).into_iter().flatten(), d),
        Block::Loads => d.loads.extend(mistakes.note(lines(&content, ended(load::load))).into_iter().flatten()),
        Block::Constraints => {
            d.constraints.extend(mistakes.note(lines(&content, ended(equation::constraint))).into_iter().flatten())
        }
        Block::Initial => d.initial.extend(mistakes.note(lines(&content, ended(block::initial))).into_iter().flatten()),
        Block::Events => d.events.extend(mistakes.note(lines(&content, event::event)).into_iter().flatten()),
        Block::Outputs => d.outputs.extend(mistakes.note(lines(&content, block::output_group)).into_iter().flatten()),
        Block::Inputs => d.inputs.extend(mistakes.note(lines(&content, ended(block::input))).into_iter().flatten()),
        Block::Kernels => {
            let kernels = mistakes.note(lines(&content, ended(block::kernel))).into_iter().flatten();
            d.kernels.get_or_insert_default().extend(kernels);
        }
        Block::Tables => d.tables.extend(mistakes.note(lines(&content, table_lines::table)).into_iter().flatten()),
        Block::Run => d.run.extend(mistakes.note(lines(&content, ended(run_line::setting))).into_iter().flatten()),
        Block::Joints => d.joints.extend(mistakes.note(lines(&content, ended(joint::joint))).into_iter().flatten()),
        Block::Auxiliary => {
            d.auxiliary.extend(mistakes.note(lines(&content, ended(block::auxiliary))).into_iter().flatten())
        }
        Block::Speeds => {
            for (speed, definition) in mistakes.note(lines(&content, ended(block::speed))).into_iter().flatten() {
                d.speeds.push(speed);
                d.lets.push(definition);
            }
        }
        Block::Drawing => d.drawing.extend(mistakes.note(lines(&content, ended(block::shape))).into_iter().flatten()),
    }
    Ok(())
}

fn frames(lines: impl Iterator<Item = (Frame, [Let; 2])>, declaration: &mut Declaration) {
    for (frame, definitions) in lines {
        declaration.frames.push(frame);
        declaration.lets.extend(definitions);
    }
}

/// ` (did you mean `bodies`?)`, or nothing where no block is near.
fn near(word: &str) -> String {
    match Block::often_called(word) {
        Some(usual) => format!(" (did you mean `{}`?)", usual.text()),
        None => nearest::suggestion(word, Block::texts()),
    }
}
