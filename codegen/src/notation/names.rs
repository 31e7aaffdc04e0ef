//! Typeset names: `theta_2` is a letter with an index, `alpha_dot` a letter with a dot.

use crate::symbolic::{Expr, Graph, Symbol, TableId};
use rustc_hash::{FxHashMap, FxHashSet};
use std::rc::Rc;

/// A name, as text and as it is set.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) struct Name {
    /// As it stands in code and in files.
    pub(super) text: String,
    pub(super) set: Setting,
}

/// A letter or word with its accents and indices.
#[derive(Clone, PartialEq, Eq, Hash, Debug)]
pub(super) struct Setting {
    pub(super) base: String,
    /// Vectors and matrices are bold.
    pub(super) bold: bool,
    /// Time derivatives.
    pub(super) dots: usize,
    pub(super) indices: Vec<String>,
}

impl Name {
    pub(super) fn dots(&self) -> usize {
        self.set.dots
    }

    /// A vector or matrix, called `text` in code.
    pub(super) fn bold(text: &str, base: &str, indices: &[&str]) -> Name {
        let indices = indices.iter().map(|index| (*index).to_owned()).collect();
        Name { text: text.to_owned(), set: Setting { base: base.to_owned(), bold: true, dots: 0, indices } }
    }

    pub(super) fn dotted(mut self, dots: usize) -> Name {
        self.set.dots = dots;
        self
    }

    /// An entry of a vector or matrix, counted from 1.
    pub(super) fn entry(&self, places: &[usize]) -> Name {
        let places: Vec<String> = places.iter().map(usize::to_string).collect();
        let mut name = self.clone();
        name.text += &format!("[{}]", places.join(", "));
        name.set.indices.extend(places);
        name
    }

    /// A name of the declaration: what follows an underscore is an index, and so is a number at the end of a word.
    fn of_word(text: &str, word: &str, dots: usize) -> Name {
        let mut parts = word.split('_').map(str::to_owned);
        let mut base = parts.next().unwrap_or_default();
        let mut indices: Vec<String> = parts.collect();
        if let Some(digit) = base.find(|c: char| c.is_ascii_digit())
            && digit > 0
        {
            indices.insert(0, base.split_off(digit));
        }
        match base.is_empty() || indices.iter().any(String::is_empty) {
            true => Name::verbatim(text),
            false => Name { text: text.to_owned(), set: Setting { base, bold: false, dots, indices } },
        }
    }

    fn verbatim(text: &str) -> Name {
        Name { text: text.to_owned(), set: Setting { base: text.to_owned(), bold: false, dots: 0, indices: vec![] } }
    }
}

/// The names of symbols and of whole expressions. No two look the same.
#[derive(Default)]
pub(super) struct Names {
    symbols: FxHashMap<Symbol, Rc<Name>>,
    expressions: FxHashMap<Expr, Rc<Name>>,
    tables: Vec<Rc<Name>>,
    taken: FxHashSet<Setting>,
}

impl Names {
    /// Names a symbol by a word of the declaration, with dots for its time derivatives.
    pub(super) fn name_symbol(&mut self, symbol: Symbol, text: &str, word: &str, dots: usize) {
        let name = self.unique(Name::of_word(text, word, dots));
        self.symbols.insert(symbol, name);
    }

    /// Names the next table by its word of the declaration.
    pub(super) fn name_table(&mut self, word: &str) {
        let name = self.unique(Name::of_word(word, word, 0));
        self.tables.push(name);
    }

    /// The name of a table.
    pub(super) fn table(&self, graph: &Graph, table: TableId) -> Rc<Name> {
        match self.tables.get(table.index()) {
            Some(name) => name.clone(),
            None => Name::verbatim(&graph.table(table).name).into(),
        }
    }

    /// Names an expression by a word of the declaration.
    pub(super) fn name_expression(&mut self, expr: Expr, word: &str) {
        let name = self.unique(Name::of_word(word, word, 0));
        self.expressions.insert(expr, name);
    }

    /// Names an expression as an entry of a matrix, which no other name looks like.
    pub(super) fn name_entry(&mut self, expr: Expr, name: Name) {
        self.expressions.insert(expr, name.into());
    }

    pub(super) fn of(&self, expr: Expr) -> Option<&Rc<Name>> {
        self.expressions.get(&expr)
    }

    pub(super) fn symbol(&self, graph: &Graph, symbol: Symbol) -> Rc<Name> {
        match self.symbols.get(&symbol) {
            Some(name) => name.clone(),
            None => Name::of_word(graph.symbol_name(symbol), graph.symbol_name(symbol), 0).into(),
        }
    }

    fn unique(&mut self, name: Name) -> Rc<Name> {
        match self.taken.insert(name.set.clone()) {
            true => name.into(),
            false => Name::verbatim(&name.text).into(),
        }
    }
}
