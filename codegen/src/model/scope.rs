//! The names of a declaration.

use super::value::Value;
use crate::dsl::Region;
use crate::mistakes::Mistakes;
use crate::nearest;
use crate::symbolic::Function;
use indexmap::IndexMap;
use syn::Ident;
use syn::ext::IdentExt;

/// Functions of the language that are not functions of the engine.
pub(super) const OTHER_FUNCTIONS: [&str; 10] =
    ["atan2", "sqrt", "min", "max", "norm", "inner", "dot", "ddot", "reaction", "on"];

/// Functions that the user's names may hide, because they were added later: rotations and vectors of space.
pub(super) const SPATIAL_FUNCTIONS: [&str; 7] =
    ["cross", "rotation", "euler", "quaternion", "axes", "transpose", "angular_velocity"];

/// The name as the user thinks of it, without Rust's `r#`.
pub(super) fn plain(ident: &Ident) -> String {
    ident.unraw().to_string()
}

/// Named things of one kind, in the order of their definition. A faulty item keeps its name, so that its uses cause no
/// further errors.
pub(super) struct Names<T> {
    /// The kind of the names, for messages: "body".
    kind: &'static str,
    entries: IndexMap<String, (Region, Option<T>)>,
}

impl<T: Clone> Names<T> {
    pub(super) fn new(kind: &'static str) -> Names<T> {
        Names { kind, entries: IndexMap::new() }
    }

    /// Adds a name; a second definition is a mistake shown with the first.
    pub(super) fn define(&mut self, name: &Ident, thing: Option<T>, mistakes: &mut Mistakes) {
        match self.check_free(name) {
            Ok(()) => drop(self.entries.insert(plain(name), (name.into(), thing))),
            Err(mistake) => mistakes.add(mistake),
        }
    }

    /// Refuses a name that is defined already, and shows where.
    pub(super) fn check_free(&self, name: &Ident) -> syn::Result<()> {
        let text = plain(name);
        let Some((first, _)) = self.entries.get(&text) else { return Ok(()) };
        let mut mistake =
            Region::from(name).error(format!("`{text}` is defined twice; choose another name for one of them"));
        mistake.combine(first.error(format!("the first definition of `{text}` is here")));
        Err(mistake)
    }

    /// Whether a name is taken.
    pub(super) fn get_region(&self, name: &str) -> Option<Region> {
        self.entries.get(name).map(|(region, _)| *region)
    }

    /// The item of that name, if there is one without mistakes.
    pub(super) fn get(&self, name: &str) -> Option<&T> {
        self.entries.get(name).and_then(|(_, thing)| thing.as_ref())
    }

    /// Changes the thing of that name.
    pub(super) fn change(&mut self, name: &str, change: impl FnOnce(&mut T)) {
        if let Some((_, Some(thing))) = self.entries.get_mut(name) {
            change(thing);
        }
    }

    /// The names, in order.
    pub(super) fn names(&self) -> impl Iterator<Item = &str> {
        self.entries.keys().map(String::as_str)
    }

    /// The item of that name; a mistake if there is none, but no message if the item itself was faulty.
    pub(super) fn find(&self, name: &Ident, mistakes: &mut Mistakes) -> Option<T> {
        let text = plain(name);
        match self.entries.get(&text) {
            Some((_, thing)) => thing.clone(),
            None => {
                mistakes.add(self.unknown(name));
                None
            }
        }
    }

    fn unknown(&self, name: &Ident) -> syn::Error {
        let text = plain(name);
        let near = nearest::suggestion(&text, self.names());
        let all: Vec<_> = self.names().map(|name| format!("`{name}`")).collect();
        let known = match (near.is_empty(), all.len()) {
            (true, 0) => format!("; no {} is declared", self.kind),
            (true, 1..=8) => format!("; declared: {}", all.join(", ")),
            _ => String::new(),
        };
        Region::from(name).error(format!("no {} is called `{text}`{near}{known}", self.kind))
    }
}

/// Refuses a name that the language itself uses.
pub(super) fn check_reserved(name: &Ident) -> syn::Result<()> {
    let text = plain(name);
    let meaning = match text.as_str() {
        "t" => "time",
        "pi" => "the circle's ratio",
        "e" => "Euler's number",
        _ if is_function(&text) => "a function",
        _ => return Ok(()),
    };
    Err(Region::from(name).error(format!("`{text}` is {meaning} in the language; choose another name")))
}

/// Whether a text can name anything, in the language and in Rust, without hiding a function of the language.
pub fn is_name(text: &str) -> bool {
    const OF_BODIES: [&str; 2] = ["attitude", "omega"];
    let is_taken = |ident: &Ident| check_reserved(ident).is_err();
    syn::parse_str::<Ident>(text).is_ok_and(|ident| ident == text && !is_taken(&ident))
        && SPATIAL_FUNCTIONS.iter().chain(&OF_BODIES).all(|function| *function != text)
}

fn is_function(name: &str) -> bool {
    reserved_functions().any(|function| function == name)
}

/// The functions a user may call.
pub(super) fn functions() -> impl Iterator<Item = &'static str> {
    reserved_functions().chain(SPATIAL_FUNCTIONS)
}

/// The ones with unique names.
pub(super) fn reserved_functions() -> impl Iterator<Item = &'static str> {
    Function::ALL.into_iter().map(Function::name).chain(OTHER_FUNCTIONS)
}

/// Coordinates, parameters and `let`s.
pub(super) type Values = Names<Value>;
