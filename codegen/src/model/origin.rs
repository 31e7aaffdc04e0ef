//! Where the dimensions of names come from.

use indexmap::IndexMap;

/// Where the dimension of a name comes from.
#[derive(Clone)]
pub(super) enum Origin {
    /// It is declared with this unit, or without.
    Declared(Option<String>),
    /// It is a `let`, made of these.
    Defined(String),
}

/// The origin of each name, and whether it was shown. A name that is defined twice has its first origin.
#[derive(Default)]
pub(super) struct Origins(IndexMap<String, (Origin, bool)>);

impl Origins {
    pub(super) fn add(&mut self, name: String, origin: Origin) {
        self.0.entry(name).or_insert((origin, false));
    }

    pub(super) fn get(&self, name: &str) -> Option<&Origin> {
        self.0.get(name).map(|(origin, _)| origin)
    }

    /// The origin, the first time it is asked for.
    pub(super) fn show(&mut self, name: &str) -> Option<Origin> {
        let (origin, shown) = self.0.get_mut(name)?;
        (!std::mem::replace(shown, true)).then(|| origin.clone())
    }
}
