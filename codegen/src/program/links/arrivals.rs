//! What arrives at a link from those that follow, turned into its frame. Links that stand in one place are moved from there as one.

use super::triple::Triple;

/// Quantities about the places where links stand, in the order in which these arrive.
pub(super) struct Arrivals<T>(Vec<(Triple, T)>);

impl<T> Default for Arrivals<T> {
    fn default() -> Arrivals<T> {
        Arrivals(Vec::new())
    }
}

impl<T> Arrivals<T> {
    /// Enters a quantity about a place, or adds it to what is there.
    pub(super) fn enter(&mut self, place: Triple, own: T, add: impl FnOnce(&T, &T) -> T) {
        match self.0.iter_mut().find(|(other, _)| *other == place) {
            Some((_, sum)) => *sum = add(sum, &own),
            None => self.0.push((place, own)),
        }
    }

    pub(super) fn into_places(self) -> Vec<(Triple, T)> {
        self.0
    }
}
