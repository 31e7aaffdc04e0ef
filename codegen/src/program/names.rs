//! Names of local variables, unique and without a meaning in Rust.

use super::Name;
use rustc_hash::FxHashMap;

/// Hands out names that are not taken.
#[derive(Clone, Default)]
pub(super) struct Names {
    /// Names with the last number that was added to each.
    taken: FxHashMap<Name, usize>,
}

impl Names {
    /// Only the names that generated code itself uses, and those that are patterns everywhere in Rust.
    pub(super) fn new() -> Names {
        let reserved = ["t", "q", "qd", "qdd", "lambda", "S", "refused", "found", "Some", "None", "Ok", "Err"];
        Names { taken: reserved.into_iter().map(|name| (name.into(), 1)).collect() }
    }

    /// The preferred name, or the first of `name_2`, `name_3` .. that is free.
    ///
    /// A name in the style of Rust's constants and types gets a `_`, since a binding could otherwise match the user's
    /// item.
    pub(super) fn unique(&mut self, wished: &str) -> Name {
        let is_constant = !wished.contains(char::is_lowercase);
        let is_type = wished.starts_with(char::is_uppercase) && !wished.contains('_');
        if is_constant || is_type { self.numbered(&format!("{wished}_")) } else { self.numbered(wished) }
    }

    fn numbered(&mut self, wished: &str) -> Name {
        let Some(mut number) = self.taken.get(wished).copied() else { return self.take(wished) };
        loop {
            number += 1;
            let name = format!("{wished}_{number}");
            if !self.taken.contains_key(name.as_str()) {
                self.taken.insert(wished.into(), number);
                return self.take(&name);
            }
        }
    }

    fn take(&mut self, free: &str) -> Name {
        let name = Name::from(free);
        self.taken.insert(name.clone(), 1);
        name
    }
}
