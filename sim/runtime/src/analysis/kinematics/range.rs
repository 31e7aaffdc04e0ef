//! The least and the greatest value of a quantity.

/// A value, and where it is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Extreme {
    /// The value, in SI units.
    pub value: f64,
    /// The driven quantity there, in SI units.
    pub at: f64,
}

/// The least and the greatest value of a quantity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Range {
    /// The least.
    pub least: Extreme,
    /// The greatest.
    pub greatest: Extreme,
}

impl Range {
    /// The one of larger magnitude.
    pub fn peak(&self) -> Extreme {
        if self.least.value.abs() > self.greatest.value.abs() { self.least } else { self.greatest }
    }

    /// From the least to the greatest: the stroke of a position.
    pub fn stroke(&self) -> f64 {
        self.greatest.value - self.least.value
    }
}
