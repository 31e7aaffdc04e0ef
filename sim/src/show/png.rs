//! A figure as PNG: its SVG, rendered.

use std::fmt::Display;
use std::fs;
use std::path::Path;

use resvg::tiny_skia::{Pixmap, Transform};
use resvg::usvg::{Options, Tree};

use super::ShowError;
use super::font::Font;

/// Pixels to a logical pixel.
const SCALE: f32 = 2.0;

/// Renders an SVG document and writes it to the file.
pub(super) fn write(document: &str, path: &Path) -> Result<(), ShowError> {
    let options = Options { fontdb: Font::get()?.database(), ..Options::default() };
    let tree = Tree::from_str(document, &options).map_err(failed)?;
    let pixels = |length: f32| (length * SCALE).round() as u32;
    let (width, height) = (pixels(tree.size().width()), pixels(tree.size().height()));
    let mut sheet = Pixmap::new(width, height).ok_or_else(|| failed("it is too large"))?;
    resvg::render(&tree, Transform::from_scale(SCALE, SCALE), &mut sheet.as_mut());
    let bytes = sheet.encode_png().map_err(failed)?;
    fs::write(path, bytes).map_err(|why| ShowError::write(path, why))
}

fn failed(why: impl Display) -> ShowError {
    ShowError::Draw(why.to_string())
}
