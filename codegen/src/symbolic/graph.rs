//! The shared graph of expressions.

use super::facts::Facts;
use super::operands::Operands;
use super::symbols::Symbols;
use super::{Constant, Expr, Node, Number, Symbol, Table};
use indexmap::IndexSet;
use rustc_hash::{FxBuildHasher, FxHashMap};

/// The owner of expressions.
#[derive(Clone, Default)]
pub struct Graph {
    nodes: IndexSet<Node, FxBuildHasher>,
    facts: Vec<Facts>,
    /// A Bloom filter of the symbols in each expression.
    occurring: Vec<Symbols>,
    symbols: Vec<String>,
    pub(super) tables: Vec<Table>,
    /// Sums that have been a factor, each as a number times a sum.
    pub(super) contents: FxHashMap<Expr, (Number, Expr)>,
}

impl Graph {
    /// An empty graph.
    pub fn new() -> Graph {
        Graph::default()
    }

    /// The node of `expr`.
    pub fn node(&self, expr: Expr) -> &Node {
        &self.nodes[expr.index()]
    }

    /// The nodes of all expressions, operands first.
    pub fn nodes(&self) -> impl Iterator<Item = &Node> {
        self.nodes.iter()
    }

    /// The number of distinct expressions.
    pub fn len(&self) -> usize {
        self.nodes.len()
    }

    /// Whether there is no expression yet.
    pub fn is_empty(&self) -> bool {
        self.nodes.is_empty()
    }

    /// Adds a node that is already canonical. Every constructor ends here.
    pub(super) fn intern(&mut self, node: Node) -> Expr {
        let (index, new) = self.nodes.insert_full(node);
        if new {
            let facts = Facts::of(&self.nodes[index], |part| self.facts(part), |part| self.as_number(part));
            self.facts.push(facts);
            let occurring = match &self.nodes[index] {
                Node::Symbol(symbol) => Symbols::of([symbol]),
                _ => self.operands(Expr::at(index)).fold(Symbols::default(), |all, x| all.or(self.may_occur(x))),
            };
            self.occurring.push(occurring);
        }
        // A graph of 2^32 nodes would take hundreds of gigabytes; memory ends first.
        Expr::at(index)
    }

    /// A Bloom filter of the symbols in the expression.
    pub(super) fn may_occur(&self, expr: Expr) -> Symbols {
        self.occurring[expr.index()]
    }

    /// All expressions so far, operands before their results.
    pub fn expressions(&self) -> impl Iterator<Item = Expr> + use<> {
        (0..self.nodes.len()).map(Expr::at)
    }

    /// Whether it is known never to be below zero where it is defined.
    pub fn is_nonnegative(&self, expr: Expr) -> bool {
        self.facts(expr).nonnegative
    }

    pub(super) fn facts(&self, expr: Expr) -> Facts {
        self.facts[expr.index()]
    }

    /// A new free variable. The name is for printing; two symbols may share one.
    pub fn symbol(&mut self, name: &str) -> Symbol {
        self.symbols.push(name.to_owned());
        Symbol(self.symbols.len() as u32 - 1)
    }

    /// The name given to a symbol.
    pub fn symbol_name(&self, symbol: Symbol) -> &str {
        &self.symbols[symbol.0 as usize]
    }

    /// The expression that is just this variable.
    pub fn variable(&mut self, symbol: Symbol) -> Expr {
        self.intern(Node::Symbol(symbol))
    }

    /// The same, if it has been made.
    pub fn existing(&self, symbol: Symbol) -> Option<Expr> {
        self.nodes.get_index_of(&Node::Symbol(symbol)).map(Expr::at)
    }

    /// An exact rational.
    pub fn number(&mut self, value: Number) -> Expr {
        self.intern(Node::Number(value))
    }

    /// An integer.
    pub fn integer(&mut self, value: i64) -> Expr {
        self.number(value.into())
    }

    /// 0.
    pub fn zero(&mut self) -> Expr {
        self.integer(0)
    }

    /// 1.
    pub fn one(&mut self) -> Expr {
        self.integer(1)
    }

    /// pi or e.
    pub fn constant(&mut self, constant: Constant) -> Expr {
        self.intern(Node::Constant(constant))
    }

    /// The value of an expression that is a rational number.
    pub fn as_number(&self, expr: Expr) -> Option<&Number> {
        match self.node(expr) {
            Node::Number(value) => Some(value),
            _ => None,
        }
    }

    /// Whether the expression is the number 0.
    pub fn is_zero(&self, expr: Expr) -> bool {
        self.as_number(expr).is_some_and(Number::is_zero)
    }

    /// Whether an expression is known to have a value for all real values of its symbols.
    pub fn has_value_everywhere(&self, expr: Expr) -> bool {
        self.facts(expr).finite
    }

    /// Whether the numbers in an expression's own node are within the range of `f64`.
    pub fn numbers_in_range(&self, expr: Expr) -> bool {
        let in_range = |number: &Number| {
            let value = number.to_f64();
            value.is_finite() && (value != 0.0 || number.is_zero())
        };
        match self.node(expr) {
            Node::Number(value) => in_range(value),
            Node::Sum { constant, terms } => in_range(constant) && terms.iter().all(|(_, c)| in_range(c)),
            Node::Product { coefficient, .. } => in_range(coefficient),
            _ => true,
        }
    }

    /// The operands of a node, in order.
    pub fn operands(&self, expr: Expr) -> Operands<'_> {
        self.node(expr).operands()
    }

    /// The given expressions and all of their operands, operands first.
    pub fn reachable(&self, roots: &[Expr]) -> Vec<Expr> {
        if let Some(few) = self.few_reachable(roots) {
            return few;
        }
        let mut seen = vec![false; self.len()];
        let mut stack = roots.to_vec();
        while let Some(expr) = stack.pop() {
            if !std::mem::replace(&mut seen[expr.index()], true) {
                stack.extend(self.operands(expr));
            }
        }
        (0..self.len()).map(Expr::at).filter(|expr| seen[expr.index()]).collect()
    }

    /// The same, if they are few: without a look at all of the graph, which may hold the rows of large tables.
    fn few_reachable(&self, roots: &[Expr]) -> Option<Vec<Expr>> {
        const FEW: usize = 32;
        let mut found: Vec<Expr> = Vec::with_capacity(FEW);
        let mut stack = roots.to_vec();
        while let Some(expr) = stack.pop() {
            if found.contains(&expr) {
                continue;
            }
            if found.len() == FEW {
                return None;
            }
            found.push(expr);
            stack.extend(self.operands(expr));
        }
        found.sort_by_key(|expr| expr.index());
        Some(found)
    }

    /// The symbols that occur in the given expressions, sorted.
    pub fn symbols_of(&self, roots: &[Expr]) -> Vec<Symbol> {
        let mut found: Vec<Symbol> = self
            .reachable(roots)
            .into_iter()
            .filter_map(|expr| match self.node(expr) {
                Node::Symbol(symbol) => Some(*symbol),
                _ => None,
            })
            .collect();
        found.sort();
        found
    }

    /// Whether any of these symbols occurs in the expression.
    pub fn depends_on(&self, expr: Expr, symbols: &[Symbol]) -> bool {
        self.may_occur(expr).meet(Symbols::of(symbols))
            && self.symbols_of(&[expr]).iter().any(|symbol| symbols.contains(symbol))
    }
}
