//! Colours that colour-blind readers can distinguish.

use std::fmt::{self, Display, Formatter};

/// A colour: red, green, blue.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Colour(pub(super) u8, pub(super) u8, pub(super) u8);

/// Paper.
pub(super) const WHITE: Colour = Colour(255, 255, 255);
/// Titles and labels.
pub(super) const INK: Colour = Colour(0x20, 0x20, 0x20);
/// Axes and supports.
pub(super) const AXIS: Colour = Colour(0x50, 0x50, 0x50);
/// Grid lines.
pub(super) const GRID: Colour = Colour(0xE4, 0xE4, 0xE4);
/// The grid line at zero.
pub(super) const ZERO: Colour = Colour(0xB0, 0xB0, 0xB0);

/// The palette of Okabe and Ito without its yellow, which is too light for lines on white.
const SERIES: [Colour; 7] = [
    Colour(0x00, 0x72, 0xB2),
    Colour(0xD5, 0x5E, 0x00),
    Colour(0x00, 0x9E, 0x73),
    Colour(0xCC, 0x79, 0xA7),
    Colour(0xE6, 0x9F, 0x00),
    Colour(0x56, 0xB4, 0xE9),
    Colour(0x00, 0x00, 0x00),
];

/// The colour of the curve or link with this index.
pub(super) fn series(index: usize) -> Colour {
    SERIES[index % SERIES.len()]
}

/// The number of times the palette has been exhausted before this index.
pub(super) fn round(index: usize) -> usize {
    index / SERIES.len()
}

impl Colour {
    /// This much of the colour, from 0 to 1, on white paper.
    pub(super) fn on_white(self, strength: f64) -> Colour {
        let mix =
            |paper: u8, ink: u8| (f64::from(paper) + (f64::from(ink) - f64::from(paper)) * strength).round() as u8;
        Colour(mix(WHITE.0, self.0), mix(WHITE.1, self.1), mix(WHITE.2, self.2))
    }
}

impl Display for Colour {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        write!(f, "#{:02x}{:02x}{:02x}", self.0, self.1, self.2)
    }
}
