//! Functions at whose zeros, or at the rows of a table, expressions change their form: conditions of `if`, `min`, `max`, `abs`
//! and `sign`, and arguments of tables.
//!
//! A step over such a place might see nothing of what begins and ends within it. Those that depend on nothing but `t` and
//! parameters are known before the motion is, and the runtime ends steps there; conditions of loads on the state it looks at
//! after each step.

use super::rows::LoadRow;
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

/// The conditions of loads on positions and speeds, each once.
pub(super) fn load_conditions(graph: &Graph, model: &Model, rows: &[LoadRow]) -> Vec<Expr> {
    let mut dependences = model.dependences.clone();
    let forces: Vec<Expr> = rows.iter().flat_map(|row| row.forces.iter().copied()).collect();
    let mut found: Vec<Expr> = Vec::new();
    for expr in graph.reachable(&forces) {
        let condition = match graph.node(expr) {
            Node::Choice(difference, _, _) => *difference,
            Node::Call(Function::Abs | Function::Sign, argument) => *argument,
            _ => continue,
        };
        let is_of_state = dependences.of(graph, condition).meets(Dependence::COORDINATE.or(Dependence::SPEED));
        if is_of_state && !found.contains(&condition) {
            found.push(condition);
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
