//! The font of figures and its measures.

use std::sync::{Arc, OnceLock};

use resvg::usvg::fontdb::Database;
use skrifa::charmap::Charmap;
use skrifa::instance::{LocationRef, Size};
use skrifa::metrics::GlyphMetrics;
use skrifa::{FontRef, MetadataProvider};

use super::ShowError;

static BYTES: &[u8] = include_bytes!("../../assets/Roboto-Regular.ttf");

/// The font of figures.
pub(super) struct Font {
    letters: Charmap<'static>,
    /// In em.
    measures: GlyphMetrics<'static>,
    /// Nothing but this font, for rendering.
    database: Arc<Database>,
}

impl Font {
    /// The font, read with its first use.
    pub(super) fn get() -> Result<&'static Font, ShowError> {
        static FONT: OnceLock<Result<Font, String>> = OnceLock::new();
        FONT.get_or_init(|| Font::read(BYTES)).as_ref().map_err(|why| ShowError::Font(why.clone()))
    }

    fn read(bytes: &'static [u8]) -> Result<Font, String> {
        let font = FontRef::new(bytes).map_err(|why| why.to_string())?;
        let mut database = Database::new();
        database.load_font_data(bytes.to_vec());
        if database.is_empty() {
            return Err("it has no name".to_owned());
        }
        let measures = font.glyph_metrics(Size::new(1.0), LocationRef::default());
        Ok(Font { letters: font.charmap(), measures, database: Arc::new(database) })
    }

    /// How wide a text is, in em.
    pub(super) fn width(&self, text: &str) -> f64 {
        let glyph = |letter| self.letters.map(letter).unwrap_or_default();
        text.chars().map(|letter| self.measures.advance_width(glyph(letter)).map_or(0.5, f64::from)).sum()
    }

    /// What texts are rendered with.
    pub(super) fn database(&self) -> Arc<Database> {
        Arc::clone(&self.database)
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
            assert!(font.letters.map(letter).is_some(), "{letter}");
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
}
