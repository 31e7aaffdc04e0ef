//! Symbols that stand for expressions. As sums are flat, a sum within a sum is not computed once: unless a symbol stands for it.

use crate::symbolic::{Differential, Expr, Graph, Node, Symbol, substitute};
use rustc_hash::FxHashMap;
use std::ops::Range;

/// Symbols with what they stand for, which may contain those before them.
#[derive(Default)]
pub(super) struct Shorthands {
    definitions: Vec<(Symbol, Expr)>,
    places: FxHashMap<Symbol, usize>,
    /// The variables of what is named.
    names: FxHashMap<Expr, Expr>,
}

impl Shorthands {
    /// How many there are.
    pub(super) fn len(&self) -> usize {
        self.definitions.len()
    }

    /// All of them, with what they stand for.
    pub(super) fn definitions(&self) -> &[(Symbol, Expr)] {
        &self.definitions
    }

    /// What a symbol stands for, if it is a shorthand.
    pub(super) fn definition(&self, symbol: Symbol) -> Option<Expr> {
        self.places.get(&symbol).map(|at| self.definitions[*at].1)
    }

    /// A symbol for an expression.
    pub(super) fn symbol(&mut self, graph: &mut Graph, expr: Expr) -> Symbol {
        let symbol = graph.symbol("shorthand");
        self.places.insert(symbol, self.definitions.len());
        self.definitions.push((symbol, expr));
        symbol
    }

    /// The variable for a sum; what is no sum stays as it is.
    pub(super) fn named(&mut self, graph: &mut Graph, expr: Expr) -> Expr {
        if !matches!(graph.node(expr), Node::Sum { .. }) {
            return expr;
        }
        if let Some(name) = self.names.get(&expr) {
            return *name;
        }
        let symbol = self.symbol(graph, expr);
        let name = graph.variable(symbol);
        self.names.insert(expr, name);
        name
    }

    /// The derivatives of expressions in which these shorthands change like what they stand for.
    pub(super) fn derivatives(
        &mut self,
        graph: &mut Graph,
        changing: Range<usize>,
        by: &mut Differential,
        exprs: &[Expr],
    ) -> Vec<Expr> {
        for at in changing {
            let (symbol, definition) = self.definitions[at];
            let rate = by.of(graph, definition);
            if !graph.is_zero(rate) {
                by.extend(symbol, self.named(graph, rate));
            }
        }
        exprs.iter().map(|expr| by.of(graph, *expr)).collect()
    }

    /// Expressions with symbols replaced, in what shorthands stand for too.
    pub(super) fn substitute(
        &mut self,
        graph: &mut Graph,
        exprs: &[Expr],
        mut replaced: Vec<(Symbol, Expr)>,
    ) -> Vec<Expr> {
        for at in 0..self.definitions.len() {
            let (symbol, definition) = self.definitions[at];
            let new = substitute(graph, &[definition], &replaced)[0];
            if new != definition {
                replaced.push((symbol, self.named(graph, new)));
            }
        }
        substitute(graph, exprs, &replaced)
    }
}
