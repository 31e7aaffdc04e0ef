//! What a robot's file lacks or contradicts.

use codegen::mistakes::Mistake;
use std::ops::Range;

/// The code of what is wrong with a robot's file.
pub(super) const CODE: &str = "E-URDF";

/// The code of what a robot's file lacks or contradicts.
const WARNING: &str = "W-URDF";

/// So many are shown; a file that has more is not read by anyone.
const MOST: usize = 200;

/// Warnings at places of a text, by bytes.
pub(super) struct Warnings<'t> {
    text: &'t str,
    all: Vec<(Range<usize>, String)>,
}

impl<'t> Warnings<'t> {
    pub(super) fn of(text: &'t str) -> Warnings<'t> {
        Warnings { text, all: Vec::new() }
    }

    /// Warns of what stands at a place.
    pub(super) fn add(&mut self, place: &Range<usize>, message: impl Into<String>) {
        self.all.push((place.clone(), message.into()));
    }

    /// All of them, in order of their places.
    pub(super) fn all(mut self) -> Vec<Mistake> {
        self.all.sort_by_key(|(place, _)| place.start);
        if self.all.len() > MOST {
            let place = self.all[MOST].0.clone();
            let others = self.all.split_off(MOST).len();
            self.all.push((place, format!("there are {others} warnings more, from here on")));
        }
        self.all.into_iter().map(|(place, message)| Mistake::at(self.text, WARNING, place, message)).collect()
    }
}
