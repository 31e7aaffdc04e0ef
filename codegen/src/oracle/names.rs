//! What the names of a declaration stand for.

use crate::dsl::Declaration;
use std::collections::HashMap;
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
pub(super) struct Names(HashMap<String, Meaning>);

impl Names {
    /// Of coordinates, parameters, inputs, auxiliary displacements and `let`s.
    pub(super) fn of(declaration: &Declaration) -> Names {
        let mut names = HashMap::new();
        let mut enter = |name: &Ident, meaning| {
            names.entry(name.to_string()).or_insert(meaning);
        };
        declaration.coordinates.iter().enumerate().for_each(|(i, c)| enter(&c.name, Meaning::Coordinate(i)));
        declaration.parameters.iter().enumerate().for_each(|(i, p)| enter(&p.name, Meaning::Parameter(i)));
        declaration.inputs.iter().enumerate().for_each(|(i, input)| enter(&input.name, Meaning::Input(i)));
        declaration.auxiliary.iter().enumerate().for_each(|(i, a)| enter(&a.name, Meaning::Auxiliary(i)));
        declaration.lets.iter().enumerate().for_each(|(i, l)| enter(&l.name, Meaning::Let(i)));
        Names(names)
    }

    /// What a name stands for, if it is declared.
    pub(super) fn meaning(&self, name: &Ident) -> Option<Meaning> {
        self.0.get(&name.to_string()).copied()
    }
}
