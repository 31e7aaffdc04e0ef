//! Failures of a motion, with place and time.

use super::readable::readable;
pub use super::what::What;
use sim_kernel::{Description, Mechanism, Scalar};
use std::fmt;

/// A failure with the time and state at which it happened.
#[derive(Clone, Debug, PartialEq)]
pub struct Failure {
    /// The kind of failure.
    pub what: What,
    /// When, in seconds.
    pub time: f64,
    /// The coordinates there, by name, in SI units.
    pub state: Vec<(&'static str, f64)>,
    /// Their declared units, with their sizes in SI units.
    pub(crate) units: Vec<(&'static str, f64)>,
}

impl Failure {
    /// A failure at a state of a mechanism.
    pub fn at<S: Scalar, M: Mechanism<S>>(mechanism: &M, what: What, time: S, q: &M::Q) -> Failure {
        Failure::of(mechanism.description(), what, time, q.as_ref())
    }

    /// A failure at a state of the mechanism of this description.
    pub(crate) fn of<S: Scalar>(description: &'static Description, what: What, time: S, q: &[S]) -> Failure {
        let coordinates = || description.coordinates.iter().map(|c| &c.position);
        let state = coordinates().map(|c| c.name).zip(q.iter().map(|value| value.first_value())).collect();
        Failure { what, time: time.first_value(), state, units: coordinates().map(|c| (c.unit, c.factor)).collect() }
    }
}

impl Failure {
    /// The same, while an event was being located.
    pub(crate) fn in_event(self, event: &'static str) -> Failure {
        Failure { what: What::InEvent { event, what: Box::new(self.what) }, ..self }
    }
}

/// The coordinates that a message shows.
const MOST_SHOWN: usize = 12;

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let coordinates = self.state.iter().zip(&self.units).take(MOST_SHOWN);
        let mut state: Vec<String> = coordinates
            .map(|((name, value), (unit, factor))| {
                let unit = if *unit == "1" { String::new() } else { format!(" {unit}") };
                format!("{name} = {}{unit}", readable(value / factor, 6))
            })
            .collect();
        if self.state.len() > MOST_SHOWN {
            state.push(format!("and {} others", self.state.len() - MOST_SHOWN));
        }
        write!(f, "at t = {} s, {}: {}", readable(self.time, 6), state.join(", "), self.what)
    }
}

impl std::error::Error for Failure {}

/// The name of a constraint row.
pub(crate) fn constraint_name<S: Scalar, M: Mechanism<S>>(mechanism: &M, row: usize) -> &'static str {
    row_name(mechanism.description(), row)
}

/// The same in a mechanism of this description.
pub(crate) fn row_name(description: &Description, row: usize) -> &'static str {
    description.constraints.get(row).map_or("?", |constraint| constraint.name)
}

/// The entry of largest magnitude, a NaN before all others. `None` for an empty vector.
pub(crate) fn largest<'a, S: Scalar>(values: impl IntoIterator<Item = &'a S>) -> Option<(usize, f64)> {
    let mut found: Option<(usize, f64)> = None;
    for (i, value) in values.into_iter().map(|value| value.first_value()).enumerate() {
        let exceeds = |best: f64| !(value.abs() <= best.abs());
        if found.is_none_or(|(_, best)| exceeds(best) && !best.is_nan()) {
            found = Some((i, value));
        }
    }
    found
}
