//! Functions of time alone at whose zeros, or at the rows of a table, expressions change their form.
//!
//! A step over such a time might see nothing of what begins and ends within it: the runtime ends steps there. Only
//! conditions of `if`, `min`, `max`, `abs` and `sign`, and arguments of tables count that depend on nothing but `t` and
//! parameters, since they are known before the motion is.

use crate::model::{Dependence, Dependences, Model};
use crate::symbolic::{Expr, Function, Graph, Node, TableId};

/// A function of time alone.
pub struct Switching {
    /// Its value.
    pub value: Expr,
    /// The table whose rows count; if there is none, its zeros do.
    pub table: Option<TableId>,
    /// Whether it changes at a constant rate.
    pub is_affine: bool,
}

/// All of them in a graph, each once.
pub(super) fn switching_functions(graph: &Graph, model: &Model) -> Vec<Switching> {
    let mut dependences = model.dependences.clone();
    let mut found: Vec<Switching> = Vec::new();
    for node in graph.nodes() {
        let (value, table) = match node {
            Node::Choice(difference, _, _) => (*difference, None),
            Node::Call(Function::Abs | Function::Sign, argument) => (*argument, None),
            Node::Table(table, _, argument) => (*argument, Some(*table)),
            _ => continue,
        };
        let is_known = found.iter().any(|known| (known.value, known.table) == (value, table));
        if !is_known && is_of_time(graph, &mut dependences, value) {
            found.push(Switching { value, table, is_affine: is_affine(graph, &mut dependences, value) });
        }
    }
    found
}

fn is_of_time(graph: &Graph, dependences: &mut Dependences, expr: Expr) -> bool {
    let on = dependences.of(graph, expr);
    on == Dependence::TIME || on == Dependence::TIME.or(Dependence::PARAMETER)
}

/// Whether a function of time is written as one of the first degree.
fn is_affine(graph: &Graph, dependences: &mut Dependences, expr: Expr) -> bool {
    if !dependences.of(graph, expr).meets(Dependence::TIME) {
        return true;
    }
    match graph.node(expr) {
        Node::Symbol(_) => true,
        Node::Sum { terms, .. } => terms.iter().all(|(term, _)| is_affine(graph, dependences, *term)),
        Node::Product { factors, .. } => {
            let mut changing = factors.iter().filter(|(base, _)| dependences.of(graph, *base).meets(Dependence::TIME));
            match (changing.next(), changing.next()) {
                (Some((base, 1)), None) => is_affine(graph, dependences, *base),
                _ => false,
            }
        }
        _ => false,
    }
}
