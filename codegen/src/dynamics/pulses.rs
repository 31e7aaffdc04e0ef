//! The middles of smooth pulses and steps, as of `exp(-((t - t1)/w)^2)` and `tanh((x - x1)/w)`.
//!
//! A short one may lie between all places at which a method evaluates a long step. The runtime ends a step in its middle, which sees
//! it and is made short enough, and on its flanks, as the load may be zero in the middle. Of time, in loads and in what moves with
//! it, these places are known before the motion is; in loads by positions each step is searched for them. By speeds there are none:
//! smooth friction would end a step at each of its turns.

use super::switching::{Switching, SwitchingKind, is_affine, is_affine_in_state, is_new, is_of_time, with_inputs};
use crate::model::{Dependence, Dependences, Model};
use crate::symbolic::{Differential, Expr, Function, Graph, Node, Symbol};

/// From this power on a function is a pulse where it is largest or smallest, as `sin(t)^200`: a fifth of its period long, or less.
const SHARP: i64 = 16;

/// A function whose zeros are the middles.
enum Middle {
    At(Expr),
    /// Where this is largest or smallest.
    AtExtremum(Expr),
    /// Where this is 1 or -1: on the sides of a pulse, beside its middle. Some are zero in the middle, as the force of the potential
    /// `exp(-(x/w)^2)`; on its steepest places, where this is 1/2, a path of this form is straight.
    Flank(Expr),
}

/// What pulses are of.
#[derive(Clone, Copy, PartialEq)]
enum Course {
    Time,
    Positions,
}

impl Course {
    fn is_of(self, graph: &Graph, dependences: &mut Dependences, expr: Expr) -> bool {
        let on = dependences.of(graph, expr);
        match self {
            Course::Time => is_of_time(graph, dependences, expr),
            Course::Positions => {
                let of_time = Dependence::TIME.or(Dependence::PARAMETER).or(Dependence::INPUT);
                let allowed = Dependence::COORDINATE.or(of_time);
                on.meets(Dependence::COORDINATE) && on.or(allowed) == allowed
            }
        }
    }

    /// What changes along it.
    fn changing(self) -> Dependence {
        match self {
            Course::Time => Dependence::TIME,
            Course::Positions => Dependence::TIME.or(Dependence::COORDINATE),
        }
    }
}

/// Those of time alone in a graph that are not known already, each once.
pub(super) fn middles_in_time(graph: &mut Graph, model: &Model, known: &[Switching]) -> Vec<Switching> {
    let mut dependences = with_inputs(graph, model);
    let of_node = |node| of_node(graph, &mut dependences, node, Course::Time);
    let middles: Vec<Middle> = graph.nodes().flat_map(of_node).collect();
    let along = Differential::along(rates_in_time(graph, model));
    switchings(graph, model, dependences, (middles, along), known)
}

/// Those by positions in what is made of these, but for those known already.
pub(super) fn middles_by_positions(
    graph: &mut Graph,
    model: &Model,
    made_of: &[Expr],
    known: &[Switching],
) -> Vec<Switching> {
    let mut dependences = with_inputs(graph, model);
    let of_node = |expr| of_node(graph, &mut dependences, graph.node(expr), Course::Positions);
    let middles: Vec<Middle> = graph.reachable(made_of).into_iter().flat_map(of_node).collect();
    let mut rates = rates_in_time(graph, model);
    rates.extend(model.coordinates.iter().map(|c| (c.position, graph.variable(c.speed))));
    switchings(graph, model, dependences, (middles, Differential::along(rates)), known)
}

/// The rates of time and of the inputs.
fn rates_in_time(graph: &mut Graph, model: &Model) -> Vec<(Symbol, Expr)> {
    let mut by_time = Differential::partial(graph, model.time);
    let mut rates = vec![(model.time, graph.one())];
    rates.extend(model.inputs.iter().map(|input| (input.symbol, by_time.of(graph, input.course))));
    rates
}

/// Middles as functions that are zero there.
fn switchings(
    graph: &mut Graph,
    model: &Model,
    mut dependences: Dependences,
    (middles, mut along): (Vec<Middle>, Differential),
    known: &[Switching],
) -> Vec<Switching> {
    let mut found: Vec<Switching> = Vec::new();
    for middle in middles {
        let kind = if matches!(middle, Middle::Flank(_)) { SwitchingKind::Flank } else { SwitchingKind::Middle };
        let value = match middle {
            Middle::At(value) => value,
            Middle::AtExtremum(of) => along.of(graph, of),
            Middle::Flank(of) => flank(graph, of),
        };
        let changes = dependences.of(graph, value).meets(Dependence::TIME.or(Dependence::COORDINATE));
        if changes && is_new(known, value, None) && is_new(&found, value, None) {
            let is_affine = is_affine_in_state(graph, model, &mut dependences, value);
            found.push(Switching { value, table: None, is_affine, kind });
        }
    }
    found
}

/// The middle of a pulse with its flanks.
fn with_flanks(of: Expr) -> Vec<Middle> {
    vec![Middle::AtExtremum(of), Middle::Flank(of)]
}

/// What is zero where a function is 1, or -1 if it is written with a sign.
fn flank(graph: &mut Graph, of: Expr) -> Expr {
    let is_negative = match graph.node(of) {
        Node::Product { coefficient, .. } => coefficient.is_negative(),
        Node::Sum { terms, .. } => terms.iter().all(|(_, coefficient)| coefficient.is_negative()),
        _ => false,
    };
    let one = graph.integer(if is_negative { 1 } else { -1 });
    graph.add(of, one)
}

/// The middles by which a node is a pulse or a step. A logistic function has its own where its exponent is 0.
fn of_node(graph: &Graph, dependences: &mut Dependences, node: &Node, course: Course) -> Vec<Middle> {
    let changing = course.changing();
    let is_pulse = |base: Expr, dependences: &mut Dependences| {
        course.is_of(graph, dependences, base)
            && !is_affine(graph, dependences, base, changing)
            && !matches!(graph.node(base), Node::Call(..))
    };
    match node {
        Node::Call(Function::Exp, exponent) if is_pulse(*exponent, dependences) => with_flanks(*exponent),
        Node::Power { base, exponent }
            if !dependences.of(graph, *base).meets(changing) && is_pulse(*exponent, dependences) =>
        {
            with_flanks(*exponent)
        }
        // It touches zero, and does not cross it.
        Node::Call(Function::Tanh | Function::Atan, argument)
            if is_pulse(*argument, dependences) && keeps_its_sign(graph, dependences, *argument, changing) =>
        {
            with_flanks(*argument)
        }
        Node::Call(Function::Exp | Function::Tanh | Function::Atan | Function::Cosh, argument)
            if course.is_of(graph, dependences, *argument) =>
        {
            vec![Middle::At(*argument)]
        }
        // How high a power by a parameter is, is not known here.
        Node::Power { base, exponent }
            if dependences.of(graph, *exponent) == Dependence::PARAMETER
                && course.is_of(graph, dependences, *base)
                && !is_affine(graph, dependences, *base, changing) =>
        {
            vec![Middle::AtExtremum(*base)]
        }
        Node::Product { factors, .. } => {
            let is_short = |base: Expr, exponent: i64, dependences: &mut Dependences| match exponent {
                SHARP.. => course.is_of(graph, dependences, base) && !is_affine(graph, dependences, base, changing),
                // By positions distances stand below too, and what is nearest is no pulse.
                ..0 => course == Course::Time && is_pulse(base, dependences),
                _ => false,
            };
            let short = factors.iter().filter(|(base, exponent)| is_short(*base, *exponent, dependences));
            short.map(|(base, _)| Middle::AtExtremum(*base)).collect()
        }
        _ => Vec::new(),
    }
}

/// Whether a function is a product of even powers, but for what does not change.
fn keeps_its_sign(graph: &Graph, dependences: &mut Dependences, expr: Expr, changing: Dependence) -> bool {
    let Node::Product { factors, .. } = graph.node(expr) else { return false };
    factors.iter().all(|(base, exponent)| exponent % 2 == 0 || !dependences.of(graph, *base).meets(changing))
}
