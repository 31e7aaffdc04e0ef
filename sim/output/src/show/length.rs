//! The unit that lengths of a mechanism are drawn in.

use sim_kernel::Description;

/// A unit of length.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Length<'a> {
    /// Its name.
    pub name: &'a str,
    /// Its size in metres.
    pub metres: f64,
}

impl Length<'static> {
    /// The metre.
    pub const METRE: Length<'static> = Length { name: "m", metres: 1.0 };

    /// The unit of all parameters that are lengths, or, without such parameters, of all coordinates that are; metres where they
    /// have several.
    pub fn of(description: &Description) -> Self {
        let parameters = description.parameters.iter();
        let coordinates = description.coordinates.iter().map(|coordinate| &coordinate.position);
        let mut lengths: Vec<_> = parameters.filter(|parameter| parameter.is_length).collect();
        if lengths.is_empty() {
            lengths.extend(coordinates.filter(|coordinate| coordinate.is_length));
        }
        match lengths.as_slice() {
            [first, others @ ..] if others.iter().all(|other| other.unit == first.unit) => {
                Length { name: first.unit, metres: first.factor }
            }
            _ => Length::METRE,
        }
    }
}
