//! The font of figures and its measures.

use std::convert::Infallible;
use std::sync::OnceLock;

use plotters::style::{FontDesc, FontFamily, FontStyle, register_font};

use super::ShowError;

static BYTES: &[u8] = include_bytes!("../../assets/Roboto-Regular.ttf");

/// Samples across a pixel when text is drawn, for the places of letters.
const SAMPLES: f64 = 4.0;

/// The measures of the font, in em.
pub(super) struct Font {
    /// By code point, up to the last one of the basic plane.
    glyphs: Vec<Glyph>,
    /// From the lowest to the highest point of letters: what the rasteriser calls the font's size.
    height: f64,
}

/// The measures of a letter, in em.
#[derive(Clone, Copy)]
struct Glyph {
    /// From its start to that of the next letter.
    advance: f64,
    /// From its start to its outline.
    bearing: f64,
}

impl Font {
    /// The font, registered with its first use.
    pub(super) fn get() -> Result<&'static Font, ShowError> {
        static FONT: OnceLock<Result<Font, &'static str>> = OnceLock::new();
        FONT.get_or_init(|| {
            register_font(FontFamily::SansSerif.as_str(), FontStyle::Normal, BYTES)
                .map_err(|_| "its file is no font")?;
            Font::parse(BYTES).ok_or("its file lacks the measures of letters")
        })
        .as_ref()
        .map_err(|why| ShowError::Font((*why).to_owned()))
    }

    /// How wide a text is, in em.
    pub(super) fn width(&self, text: &str) -> f64 {
        text.chars().map(|letter| self.glyph(letter).advance).sum()
    }

    /// Draws a text of this size, in pixels to the em: hands on small squares, by their middles to the right of
    /// the text's start and down from its base line, with what of them is covered, in pixels.
    ///
    /// Letter by letter, for the rasteriser puts the outline of each where its bearing should begin.
    pub(super) fn draw(&self, text: &str, size: f64, mut square: impl FnMut(f64, f64, f64)) -> Result<(), ShowError> {
        let em = size * SAMPLES;
        let scaled = em * self.height;
        let font = FontDesc::new(FontFamily::SansSerif, scaled, FontStyle::Normal);
        let mut start = 0.0;
        for letter in text.chars() {
            let glyph = self.glyph(letter);
            let left = (em * (start + glyph.bearing)).floor() as i32;
            // The rasteriser's base line is at half the size.
            let base = (scaled / 2.0).floor();
            let mut encoded = [0; 4];
            let drawn = font.draw::<Infallible, _>(letter.encode_utf8(&mut encoded), (left, 0), |x, y, cover| {
                let (x, y) = (f64::from(x) + 0.5, f64::from(y) - base + 0.5);
                square(x / SAMPLES, y / SAMPLES, f64::from(cover) / (SAMPLES * SAMPLES));
                Ok(())
            });
            match drawn {
                Ok(Ok(())) => start += glyph.advance,
                Err(why) => return Err(ShowError::Font(why.to_string())),
            }
        }
        Ok(())
    }

    fn glyph(&self, letter: char) -> Glyph {
        let missing = Glyph { advance: 0.5, bearing: 0.0 };
        self.glyphs.get(letter as usize).or(self.glyphs.first()).copied().unwrap_or(missing)
    }

    /// Reads the measures of an OpenType font.
    fn parse(bytes: &[u8]) -> Option<Font> {
        let em = f64::from(u16_at(table(bytes, b"head")?, 18)?);
        let vertical = table(bytes, b"hhea")?;
        let height = f64::from(i16_at(vertical, 4)?) - f64::from(i16_at(vertical, 6)?);
        let (horizontal, wide) = (table(bytes, b"hmtx")?, usize::from(u16_at(vertical, 34)?));
        let map = basic_plane(table(bytes, b"cmap")?)?;
        let glyphs = (0..=u16::MAX).map(|code| {
            let glyph = usize::from(mapped(map, code).unwrap_or(0));
            let advance = u16_at(horizontal, 4 * glyph.min(wide.checked_sub(1)?))?;
            let bearing = if glyph < wide { 4 * glyph + 2 } else { 4 * wide + 2 * (glyph - wide) };
            let bearing = i16_at(horizontal, bearing)?;
            Some(Glyph { advance: f64::from(advance) / em, bearing: f64::from(bearing) / em })
        });
        Some(Font { glyphs: glyphs.collect::<Option<_>>()?, height: height / em })
    }
}

fn u16_at(bytes: &[u8], at: usize) -> Option<u16> {
    bytes.get(at..at + 2)?.try_into().ok().map(u16::from_be_bytes)
}

fn i16_at(bytes: &[u8], at: usize) -> Option<i16> {
    bytes.get(at..at + 2)?.try_into().ok().map(i16::from_be_bytes)
}

fn u32_at(bytes: &[u8], at: usize) -> Option<usize> {
    bytes.get(at..at + 4)?.try_into().ok().map(u32::from_be_bytes)?.try_into().ok()
}

/// A table of the font.
fn table<'a>(bytes: &'a [u8], tag: &[u8; 4]) -> Option<&'a [u8]> {
    let records = 12..12 + 16 * usize::from(u16_at(bytes, 4)?);
    let record = bytes.get(records)?.chunks_exact(16).find(|record| record.starts_with(tag))?;
    let start = u32_at(record, 8)?;
    bytes.get(start..start.checked_add(u32_at(record, 12)?)?)
}

/// The map from code points of the basic plane to glyphs, in format 4.
fn basic_plane(maps: &[u8]) -> Option<&[u8]> {
    let count = usize::from(u16_at(maps, 2)?);
    let starts = (0..count).filter_map(|index| u32_at(maps, 8 + 8 * index));
    starts.filter_map(|start| maps.get(start..)).find(|map| u16_at(map, 0) == Some(4))
}

/// The glyph of a code point.
fn mapped(map: &[u8], code: u16) -> Option<u16> {
    let doubled = usize::from(u16_at(map, 6)?);
    let (ends, starts) = (14, 16 + doubled);
    let (deltas, offsets) = (starts + doubled, starts + 2 * doubled);
    let segment = (0..doubled).step_by(2).find(|at| u16_at(map, ends + at).is_some_and(|end| end >= code))?;
    let (start, delta) = (u16_at(map, starts + segment)?, u16_at(map, deltas + segment)?);
    let within = usize::from(code.checked_sub(start)?);
    match usize::from(u16_at(map, offsets + segment)?) {
        0 => Some(code.wrapping_add(delta)),
        offset => match u16_at(map, offsets + segment + offset + 2 * within)? {
            0 => None,
            glyph => Some(glyph.wrapping_add(delta)),
        },
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn measures_agree_with_the_rasteriser() {
        let font = Font::get().unwrap();
        let desc = FontDesc::new(FontFamily::SansSerif, 1000.0 * font.height, FontStyle::Normal);
        for text in ["l", "W", "0", "\u{2212}", "\u{b7}", "²", "⁻", "⁹", "φ", "Ω", "\u{2009}"] {
            let (width, _) = desc.box_size(text).unwrap();
            assert!((f64::from(width) - 1000.0 * font.width(text)).abs() <= 1.0, "{text}");
        }
    }

    #[test]
    fn letters_of_units_are_there() {
        let map = basic_plane(table(BYTES, b"cmap").unwrap()).unwrap();
        for letter in "AZaz09αβγδεθλμπρστφψωΔΣΦΨΩ⁰¹²³⁴⁵⁶⁷⁸⁹⁻·×°−\u{2009}…".chars()
        {
            let code = u16::try_from(u32::from(letter)).unwrap();
            assert!(mapped(map, code).is_some_and(|glyph| glyph != 0), "{letter}");
        }
    }

    #[test]
    fn what_is_no_font_is_refused() {
        assert!(Font::parse(b"").is_none());
        assert!(Font::parse(&BYTES[..2000]).is_none());
    }
}
