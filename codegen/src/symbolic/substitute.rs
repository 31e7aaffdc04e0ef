//! Replacing symbols by expressions, in one graph or from one graph to another.

use super::symbols::Symbols;
use super::{Expr, Graph, Node, Symbol};
use rustc_hash::FxHashMap;

/// Each root with every listed symbol replaced, all at once.
pub fn substitute(graph: &mut Graph, roots: &[Expr], replacements: &[(Symbol, Expr)]) -> Vec<Expr> {
    let replacements: FxHashMap<_, _> = replacements.iter().copied().collect();
    let replaced = Symbols::of(replacements.keys());
    let mut done: FxHashMap<Expr, Expr> = FxHashMap::default();
    for expr in graph.reachable(roots) {
        let new = match graph.node(expr) {
            _ if !graph.may_occur(expr).meet(replaced) => expr,
            Node::Symbol(symbol) => replacements.get(symbol).copied().unwrap_or(expr),
            _ => with_operands(graph, expr, |operand| done[&operand]),
        };
        done.insert(expr, new);
    }
    roots.iter().map(|root| done[root]).collect()
}

/// Expressions of one graph in another, with every symbol replaced by its counterpart there.
pub fn transplant(from: &Graph, roots: &[Expr], to: &mut Graph, replacement: impl Fn(Symbol) -> Expr) -> Vec<Expr> {
    let mut done: FxHashMap<Expr, Expr> = FxHashMap::default();
    for expr in from.reachable(roots) {
        let new = match from.node(expr) {
            Node::Symbol(symbol) => replacement(*symbol),
            Node::Table(table, order, argument) => {
                let table = to.add_table(from.table(*table).clone());
                to.look_up(table, *order, done[argument])
            }
            node => rebuilt(to, node.clone(), |operand| done[&operand]),
        };
        done.insert(expr, new);
    }
    roots.iter().map(|root| done[root]).collect()
}

/// An expression with each of its operands replaced.
pub fn with_operands(graph: &mut Graph, expr: Expr, new: impl Fn(Expr) -> Expr) -> Expr {
    match graph.node(expr).clone() {
        Node::Number(_) | Node::Constant(_) | Node::Symbol(_) => expr,
        node => rebuilt(graph, node, new),
    }
}

/// A node rebuilt with other operands.
fn rebuilt(graph: &mut Graph, node: Node, new: impl Fn(Expr) -> Expr) -> Expr {
    match node {
        Node::Number(number) => graph.number(number),
        Node::Constant(constant) => graph.constant(constant),
        Node::Symbol(symbol) => graph.variable(symbol),
        Node::Sum { constant, terms } => {
            let mut weighted: Vec<_> = terms.iter().map(|(term, c)| (new(*term), c.clone())).collect();
            let one = graph.one();
            weighted.push((one, constant));
            graph.linear_combination(&weighted)
        }
        Node::Product { coefficient, factors } => {
            let powers: Vec<_> = factors.iter().map(|(base, e)| (new(*base), *e)).collect();
            let product = graph.product_of_powers(&powers);
            graph.scale(&coefficient, product)
        }
        Node::Power { base, exponent } => graph.power(new(base), new(exponent)),
        Node::Call(function, argument) => graph.call(function, new(argument)),
        Node::Atan2(y, x) => graph.atan2(new(y), new(x)),
        Node::Choice(difference, above, otherwise) => graph.choice(new(difference), new(above), new(otherwise)),
        Node::Table(table, order, argument) => graph.look_up(table, order, new(argument)),
    }
}
