//! The state of a motion at one time.

use super::error::{Result, refuse};
use super::measured::Measured;
use crate::dsl::Declaration;

/// A state of a mechanism. Everything is in SI units and in the order of the declaration.
#[derive(Clone, Copy, Debug)]
pub struct State<'s> {
    /// t, s.
    pub time: f64,
    /// The value of each parameter.
    pub parameters: &'s [f64],
    /// The value that each input is set to; none if it follows its declared course.
    pub inputs: &'s [Option<f64>],
    /// q \[n\].
    pub coordinates: &'s [f64],
    /// q' \[n\].
    pub speeds: &'s [f64],
}

impl State<'_> {
    pub(super) fn check(&self, declaration: &Declaration) -> Result<()> {
        let lengths = [
            ("parameters", self.parameters.len(), declaration.parameters.len()),
            ("inputs", self.inputs.len(), declaration.inputs.len()),
            ("coordinates", self.coordinates.len(), declaration.coordinates.len()),
            ("speeds", self.speeds.len(), declaration.coordinates.len()),
        ];
        match lengths.iter().find(|(_, given, declared)| given != declared) {
            Some((what, given, declared)) => refuse(format!("{given} {what} given, {declared} declared")),
            None => Ok(()),
        }
    }

    /// (q', 1, 0, ..): how the variables (q, t, s) of a position change in time.
    pub(super) fn rates(&self, auxiliaries: usize) -> Vec<Measured> {
        self.speeds.iter().copied().chain([1.0]).chain(vec![0.0; auxiliaries]).map(Measured::given).collect()
    }
}
