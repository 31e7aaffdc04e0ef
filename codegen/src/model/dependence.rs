//! The kinds of variables that an expression depends on.

use crate::symbolic::{Expr, Graph, Node, Symbol};
use rustc_hash::FxHashMap;

/// A set of kinds of variables.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Dependence(u8);

impl Dependence {
    /// On nothing: a number.
    pub const NONE: Dependence = Dependence(0);
    /// On a parameter.
    pub const PARAMETER: Dependence = Dependence(1);
    /// On explicit time.
    pub const TIME: Dependence = Dependence(2);
    /// On a coordinate.
    pub const COORDINATE: Dependence = Dependence(4);
    /// On a speed.
    pub const SPEED: Dependence = Dependence(8);
    /// On an acceleration.
    pub const ACCELERATION: Dependence = Dependence(16);
    /// On a multiplier.
    pub const MULTIPLIER: Dependence = Dependence(32);

    /// On an input.
    pub const INPUT: Dependence = Dependence(64);

    /// Either or both.
    pub const fn or(self, other: Dependence) -> Dependence {
        Dependence(self.0 | other.0)
    }

    /// Whether the two have a kind in common.
    pub const fn meets(self, other: Dependence) -> bool {
        self.0 & other.0 != 0
    }
}

/// Finds dependences, each node once.
#[derive(Clone, Default)]
pub struct Dependences {
    symbols: FxHashMap<Symbol, Dependence>,
    nodes: FxHashMap<Expr, Dependence>,
}

impl Dependences {
    /// Says what kind of variable a symbol is.
    pub fn declare(&mut self, symbol: Symbol, kind: Dependence) {
        self.symbols.insert(symbol, kind);
    }

    /// The same, with another kind for a symbol.
    pub(crate) fn redeclared(mut self, symbol: Symbol, kind: Dependence) -> Dependences {
        self.symbols.insert(symbol, kind);
        Dependences { symbols: self.symbols, nodes: FxHashMap::default() }
    }

    /// The dependence of an expression.
    pub fn of(&mut self, graph: &Graph, expr: Expr) -> Dependence {
        if let Some(known) = self.nodes.get(&expr) {
            return *known;
        }
        let found = match graph.node(expr) {
            Node::Symbol(symbol) => self.symbols.get(symbol).copied().unwrap_or_default(),
            _ => graph.operands(expr).fold(Dependence::NONE, |all, x| all.or(self.of(graph, x))),
        };
        self.nodes.insert(expr, found);
        found
    }
}
