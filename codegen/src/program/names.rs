//! Names of local variables: never a Rust keyword's meaning, never twice.

use rustc_hash::FxHashMap;

/// Hands out names that are not taken.
#[derive(Clone, Default)]
pub(super) struct Names {
    taken: FxHashMap<String, usize>,
}

impl Names {
    /// No name but those that generated code itself uses, and those that are patterns everywhere in Rust.
    pub(super) fn new() -> Names {
        let reserved = ["t", "q", "qd", "qdd", "lambda", "S", "refused", "found", "Some", "None", "Ok", "Err"];
        Names { taken: reserved.into_iter().map(|name| (name.to_owned(), 1)).collect() }
    }

    /// The wished name, or the first of `name_2`, `name_3` .. that is free.
    ///
    /// A name in the style of Rust's constants and types gets a `_`: where it is bound, one of the user's could be meant.
    pub(super) fn unique(&mut self, wished: &str) -> String {
        let is_constant = !wished.contains(char::is_lowercase);
        let is_type = wished.starts_with(char::is_uppercase) && !wished.contains('_');
        let marked = format!("{wished}_");
        let wished = if is_constant || is_type { &marked } else { wished };
        loop {
            let count = self.taken.entry(wished.to_owned()).or_insert(0);
            *count += 1;
            let name = match *count {
                1 => return wished.to_string(),
                count => format!("{wished}_{count}"),
            };
            if !self.taken.contains_key(&name) {
                self.taken.insert(name.clone(), 1);
                return name;
            }
        }
    }
}
