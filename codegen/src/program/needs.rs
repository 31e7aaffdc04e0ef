//! Which names statements need, and which they give.

use super::{Columns, Name, Statement, Tree};

impl Statement {
    /// Calls `f` for each name that the statement needs, once for each occurrence.
    pub(super) fn needs<'a>(&'a self, f: &mut dyn FnMut(&'a Name)) {
        match self {
            Statement::Let { value, .. } => value.needs(f),
            Statement::SinCos(waves) => waves.iter().for_each(|wave| wave.argument.needs(f)),
            Statement::Table(look_up) => look_up.argument.needs(f),
            Statement::Columns(columns) => columns.operands().for_each(|tree| tree.needs(f)),
        }
    }

    /// The names that it gives.
    pub(super) fn gives(&self) -> Vec<&Name> {
        match self {
            Statement::Let { name, .. } => vec![name],
            Statement::SinCos(waves) => waves.iter().flat_map(|wave| wave.sin.iter().chain(&wave.cos)).collect(),
            Statement::Table(look_up) => look_up.names.iter().flatten().collect(),
            Statement::Columns(columns) => columns.names.iter().flatten().flatten().collect(),
        }
    }
}

impl Columns {
    /// All that it is computed from.
    pub(super) fn operands(&self) -> impl Iterator<Item = &Tree> {
        self.inverses.iter().chain(&self.entries).chain(self.right_hand_sides.iter().flatten())
    }
}

impl Tree {
    /// Calls `f` for each name that the expression needs, once for each occurrence.
    pub(super) fn needs<'a>(&'a self, f: &mut dyn FnMut(&'a Name)) {
        match self {
            Tree::Constant(_) | Tree::Field(_) => {}
            Tree::Name(name) => f(name),
            Tree::Sum(terms) => terms.iter().for_each(|(_, term)| term.needs(f)),
            Tree::Product(trees) | Tree::Method(_, trees) => trees.iter().for_each(|tree| tree.needs(f)),
            Tree::Quotient(above, below) => {
                above.needs(f);
                below.needs(f);
            }
            Tree::Negate(operand) => operand.needs(f),
        }
    }
}
