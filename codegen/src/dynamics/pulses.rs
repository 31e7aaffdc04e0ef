//! The middles of smooth pulses and steps of time, in loads and in what moves with time, as of `exp(-((t - t1)/w)^2)` and
//! `tanh((t - t1)/w)`.
//!
//! A short one may lie between all places at which a method evaluates a long step. Its middle is known before the motion is: there
//! the runtime ends a step, which sees it and is made short enough.

use super::switching::{Switching, is_affine, is_new, is_of_time};
use crate::model::{Dependences, Model};
use crate::symbolic::{Differential, Expr, Function, Graph, Node};

/// A function of time whose zeros are the middles.
enum Middle {
    At(Expr),
    /// Where this is largest or smallest.
    AtExtremum(Expr),
}

/// Those in a graph that are not known already, each once.
pub(super) fn middles(graph: &mut Graph, model: &Model, known: &[Switching]) -> Vec<Switching> {
    let mut dependences = model.dependences.clone();
    let middles: Vec<Middle> = graph.nodes().flat_map(|node| of_node(graph, &mut dependences, node)).collect();
    let mut found: Vec<Switching> = Vec::new();
    for middle in middles {
        let value = match middle {
            Middle::At(value) => value,
            Middle::AtExtremum(of) => Differential::partial(graph, model.time).of(graph, of),
        };
        if is_of_time(graph, &mut dependences, value) && is_new(known, value, None) && is_new(&found, value, None) {
            let is_affine = is_affine(graph, &mut dependences, value);
            found.push(Switching { value, table: None, is_affine, is_smooth: true });
        }
    }
    found
}

/// The middles by which a node is a pulse or a step. A logistic function has its own where its exponent is 0.
fn of_node(graph: &Graph, dependences: &mut Dependences, node: &Node) -> Vec<Middle> {
    let is_pulse = |base: Expr, dependences: &mut Dependences| {
        is_of_time(graph, dependences, base)
            && !is_affine(graph, dependences, base)
            && !matches!(graph.node(base), Node::Call(..))
    };
    match node {
        Node::Call(Function::Exp, exponent) if is_pulse(*exponent, dependences) => vec![Middle::AtExtremum(*exponent)],
        Node::Call(Function::Exp | Function::Tanh | Function::Atan | Function::Cosh, argument)
            if is_of_time(graph, dependences, *argument) =>
        {
            vec![Middle::At(*argument)]
        }
        Node::Product { factors, .. } => {
            let below = factors.iter().filter(|(_, exponent)| *exponent < 0).map(|(base, _)| *base);
            below.filter(|base| is_pulse(*base, dependences)).map(Middle::AtExtremum).collect()
        }
        _ => Vec::new(),
    }
}
