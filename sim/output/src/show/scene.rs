//! A figure laid out: marks on a sheet, in logical pixels from its upper left corner.

use super::ShowError;
use super::font::Font;
use super::palette::Colour;

/// A place on the sheet: right, down.
pub(super) type Point = (f64, f64);

/// A figure laid out; later marks cover earlier ones.
#[derive(Debug)]
pub(super) struct Scene {
    /// Its width.
    pub(super) width: f64,
    /// Its height.
    pub(super) height: f64,
    /// The marks on it.
    pub(super) marks: Vec<Mark>,
}

/// Something on the sheet.
#[derive(Clone, Debug)]
pub(super) enum Mark {
    /// A polyline with round joins and ends.
    Line { points: Vec<Point>, width: f64, colour: Colour },
    /// A filled convex polygon.
    Area { points: Vec<Point>, colour: Colour },
    /// A filled circle.
    Disc { centre: Point, radius: f64, colour: Colour },
    /// Text.
    Label(Label),
}

/// A line of text.
#[derive(Clone, Debug)]
pub(super) struct Label {
    /// The text.
    pub(super) text: String,
    /// The place of its anchor on the base line.
    pub(super) at: Point,
    /// The font's size, its em.
    pub(super) size: f64,
    /// Its anchor.
    pub(super) anchor: Anchor,
    /// Whether it reads upwards.
    pub(super) upwards: bool,
    /// Its colour.
    pub(super) colour: Colour,
}

/// The anchor of a text.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Anchor {
    Start,
    Middle,
    End,
}

impl Scene {
    /// An empty sheet.
    pub(super) fn new(width: f64, height: f64) -> Self {
        Scene { width, height, marks: Vec::new() }
    }

    /// Draws a polyline.
    pub(super) fn line(&mut self, points: Vec<Point>, width: f64, colour: Colour) {
        self.marks.push(Mark::Line { points, width, colour });
    }

    /// Fills a convex polygon.
    pub(super) fn area(&mut self, points: Vec<Point>, colour: Colour) {
        self.marks.push(Mark::Area { points, colour });
    }

    /// Fills a circle.
    pub(super) fn disc(&mut self, centre: Point, radius: f64, colour: Colour) {
        self.marks.push(Mark::Disc { centre, radius, colour });
    }

    /// Writes level text.
    pub(super) fn text(&mut self, text: &str, at: Point, size: f64, anchor: Anchor, colour: Colour) {
        self.label(Label { text: text.to_owned(), at, size, anchor, upwards: false, colour });
    }

    /// Writes text.
    pub(super) fn label(&mut self, label: Label) {
        if !label.text.is_empty() {
            self.marks.push(Mark::Label(label));
        }
    }
}

/// Room for a text of this size, with a margin, because SVG is displayed in the reader's font.
pub(super) fn room(text: &str, size: f64) -> Result<f64, ShowError> {
    Ok(1.15 * Font::get()?.width(text) * size)
}

/// Room for the longest of several texts.
pub(super) fn most_room<'a>(texts: impl IntoIterator<Item = &'a str>, size: f64) -> Result<f64, ShowError> {
    texts.into_iter().try_fold(0.0_f64, |most, text| Ok(most.max(room(text, size)?)))
}

/// The text and the size, at most the given one and at least 14, at which it fits. Where it does not, its end is cut off, or,
/// where a unit stands there, what is before the unit.
pub(super) fn fit(text: &str, size: f64, space: f64) -> Result<(String, f64), ShowError> {
    let needed = room(text, size)?;
    if needed <= space {
        return Ok((text.to_owned(), size));
    }
    let size = (size * space / needed).max(14.0_f64.min(size));
    let unit = text.rfind(" [").filter(|start| *start > 0 && text.ends_with(']')).unwrap_or(text.len());
    let (fitted, fits) = cut(&text[..unit], &text[unit..], size, space)?;
    Ok((if fits { fitted } else { cut(text, "", size, space)?.0 }, size))
}

/// The text cut so that it fits with its unit, and whether it does.
fn cut(text: &str, unit: &str, size: f64, space: f64) -> Result<(String, bool), ShowError> {
    let mut fitted = text.to_owned();
    loop {
        let whole = fitted.clone() + unit;
        let fits = room(&whole, size)? <= space + 1e-6;
        if fits || fitted.chars().count() <= 1 {
            return Ok((whole, fits));
        }
        let end = fitted.trim_end_matches('…').char_indices().next_back().map_or(0, |(end, _)| end);
        fitted.truncate(end);
        fitted.push('…');
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn long_texts_shrink_then_lose_their_end() {
        let text = "angular speed of the rocker";
        let needed = room(text, 20.0).unwrap();
        assert_eq!(fit(text, 20.0, needed).unwrap(), (text.to_owned(), 20.0));
        let (shrunk, size) = fit(text, 20.0, 0.8 * needed).unwrap();
        assert!(shrunk == text && (15.9..16.1).contains(&size));
        let (cut, size) = fit(text, 20.0, 0.3 * needed).unwrap();
        assert!(cut.starts_with("angul") && cut.ends_with('…') && size == 14.0);
        assert!(room(&cut, size).unwrap() <= 0.3 * needed);
        assert_eq!(fit(text, 20.0, 0.0).unwrap().0, "…");
    }

    #[test]
    fn units_are_kept() {
        let text = "angular speed of the rocker [rad/s]";
        let (cut, _) = fit(text, 20.0, 0.4 * room(text, 20.0).unwrap()).unwrap();
        assert!(cut.starts_with("angul") && cut.ends_with("… [rad/s]"), "{cut}");
        assert!(fit(text, 20.0, 30.0).unwrap().0.ends_with('…'));
        assert_eq!(fit("[rad/s]", 20.0, 0.0).unwrap().0, "…");
    }
}
