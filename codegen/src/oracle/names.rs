//! What the names of a declaration stand for.

use super::interpolation::Function;
use crate::dsl::Declaration;
use std::collections::HashMap;
use std::sync::OnceLock;
use syn::Ident;

/// A part of a declaration, by its index.
#[derive(Clone, Copy)]
pub(super) enum Meaning {
    Coordinate(usize),
    Parameter(usize),
    Input(usize),
    Auxiliary(usize),
    Let(usize),
}

/// The names of a declaration.
pub(super) struct Names {
    meanings: HashMap<String, Meaning>,
    /// The function of each table, once it was called: it is the same at all states.
    functions: Vec<OnceLock<Function>>,
}

impl Names {
    /// Of coordinates, parameters, inputs, auxiliary displacements and `let`s.
    pub(super) fn of(declaration: &Declaration) -> Names {
        let mut meanings = HashMap::new();
        let mut enter = |name: &Ident, meaning| {
            meanings.entry(name.to_string()).or_insert(meaning);
        };
        declaration.coordinates.iter().enumerate().for_each(|(i, c)| enter(&c.name, Meaning::Coordinate(i)));
        declaration.parameters.iter().enumerate().for_each(|(i, p)| enter(&p.name, Meaning::Parameter(i)));
        declaration.inputs.iter().enumerate().for_each(|(i, input)| enter(&input.name, Meaning::Input(i)));
        declaration.auxiliary.iter().enumerate().for_each(|(i, a)| enter(&a.name, Meaning::Auxiliary(i)));
        declaration.lets.iter().enumerate().for_each(|(i, l)| enter(&l.name, Meaning::Let(i)));
        Names { meanings, functions: declaration.tables.iter().map(|_| OnceLock::new()).collect() }
    }

    /// What a name stands for, if it is declared.
    pub(super) fn meaning(&self, name: &Ident) -> Option<Meaning> {
        self.meanings.get(&name.to_string()).copied()
    }

    /// The function of a table; the first time as it is made then.
    pub(super) fn function<E>(&self, table: usize, make: impl FnOnce() -> Result<Function, E>) -> Result<&Function, E> {
        let known = &self.functions[table];
        match known.get() {
            Some(function) => Ok(function),
            None => make().map(|made| known.get_or_init(|| made)),
        }
    }
}
