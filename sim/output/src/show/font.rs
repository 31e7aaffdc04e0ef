//! The font of figures: its measures and outlines.

use std::sync::OnceLock;

use tiny_skia::{Path, PathBuilder};
use ttf_parser::{Face, GlyphId, OutlineBuilder};

use super::ShowError;

static BYTES: &[u8] = include_bytes!("../../assets/Roboto-Regular.ttf");

/// The width of a letter in em, if the font does not define it.
const USUAL_WIDTH: f64 = 0.5;

/// The font of figures.
pub(super) struct Font {
    face: Face<'static>,
}

impl Font {
    /// The font, read with its first use.
    pub(super) fn get() -> Result<&'static Font, ShowError> {
        static FONT: OnceLock<Result<Font, String>> = OnceLock::new();
        FONT.get_or_init(|| Font::read(BYTES)).as_ref().map_err(|why| ShowError::Font(why.clone()))
    }

    fn read(bytes: &'static [u8]) -> Result<Font, String> {
        let face = Face::parse(bytes, 0).map_err(|why| why.to_string())?;
        match face.glyph_index('0') {
            Some(_) => Ok(Font { face }),
            None => Err("it has no digits".to_owned()),
        }
    }

    /// The width of a text, in em.
    pub(super) fn width(&self, text: &str) -> f64 {
        text.chars().map(|letter| self.advance(self.glyph(letter))).sum()
    }

    /// The outlines of a text whose base line begins at the origin, with downwards positive; none of spaces alone.
    pub(super) fn outlines(&self, text: &str, em: f64) -> Option<Path> {
        let scale = em / f64::from(self.face.units_per_em());
        let mut pen = Pen { path: PathBuilder::new(), begin: 0.0, scale: scale as f32 };
        let mut begin = 0.0;
        for glyph in text.chars().map(|letter| self.glyph(letter)) {
            pen.begin = (em * begin) as f32;
            self.face.outline_glyph(glyph, &mut pen);
            begin += self.advance(glyph);
        }
        pen.path.finish()
    }

    fn glyph(&self, letter: char) -> GlyphId {
        self.face.glyph_index(letter).unwrap_or_default()
    }

    fn advance(&self, glyph: GlyphId) -> f64 {
        let em = f64::from(self.face.units_per_em());
        self.face.glyph_hor_advance(glyph).map_or(USUAL_WIDTH, |units| f64::from(units) / em)
    }
}

/// Draws letters side by side, from the font's units, upwards, to those of a sheet, downwards.
struct Pen {
    path: PathBuilder,
    begin: f32,
    scale: f32,
}

impl Pen {
    fn place(&self, x: f32, y: f32) -> (f32, f32) {
        (self.begin + self.scale * x, -self.scale * y)
    }
}

impl OutlineBuilder for Pen {
    fn move_to(&mut self, x: f32, y: f32) {
        let (x, y) = self.place(x, y);
        self.path.move_to(x, y);
    }

    fn line_to(&mut self, x: f32, y: f32) {
        let (x, y) = self.place(x, y);
        self.path.line_to(x, y);
    }

    fn quad_to(&mut self, x1: f32, y1: f32, x: f32, y: f32) {
        let ((x1, y1), (x, y)) = (self.place(x1, y1), self.place(x, y));
        self.path.quad_to(x1, y1, x, y);
    }

    fn curve_to(&mut self, x1: f32, y1: f32, x2: f32, y2: f32, x: f32, y: f32) {
        let ((x1, y1), (x2, y2), (x, y)) = (self.place(x1, y1), self.place(x2, y2), self.place(x, y));
        self.path.cubic_to(x1, y1, x2, y2, x, y);
    }

    fn close(&mut self) {
        self.path.close();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn letters_of_units_are_there() {
        let font = Font::get().unwrap();
        for letter in "AZaz09αβγδεθλμπρστφψωΔΣΦΨΩ⁰¹²³⁴⁵⁶⁷⁸⁹⁻·×°−\u{2009}…".chars()
        {
            assert!(font.face.glyph_index(letter).is_some(), "{letter}");
        }
    }

    #[test]
    fn widths_are_in_em() {
        let font = Font::get().unwrap();
        assert!((font.width("0") - 1150.0 / 2048.0).abs() < 1e-3);
        assert!((font.width("W\u{2009}W") - 2.0 * font.width("W") - font.width("\u{2009}")).abs() < 1e-9);
        assert!(font.width("\u{ffff}") > 0.0 && font.width("") == 0.0);
    }

    #[test]
    fn what_is_no_font_is_refused() {
        assert!(Font::read(b"").is_err());
        assert!(Font::read(&BYTES[..2000]).is_err());
    }

    /// Letters stand on the base line, within their widths.
    #[test]
    fn outlines_are_where_letters_are() {
        let font = Font::get().unwrap();
        let bounds = font.outlines("HH", 10.0).unwrap().bounds();
        let (width, height) = (10.0 * font.width("HH"), 10.0 * 1456.0 / 2048.0);
        assert!(bounds.left() > 0.0 && f64::from(bounds.right()) < width && f64::from(bounds.right()) > 0.9 * width);
        assert!(bounds.bottom().abs() < 1e-3 && (f64::from(bounds.top()) + height).abs() < 0.01, "{bounds:?}");
        assert!(font.outlines(" ", 10.0).is_none());
    }
}
