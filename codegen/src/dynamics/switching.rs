//! Functions at whose zeros, or at the rows of a table, expressions change their form: conditions of `if`, `min`, `max`, `abs`
//! and `sign`, the cut of `atan2`, and arguments of tables.
//!
//! A step over such a place might see nothing of what begins and ends within it. Those that depend on nothing but `t`, inputs
//! and parameters are known before the motion is, and the runtime ends steps there; conditions of loads on the state it looks at
//! after each step.

use super::rows::LoadRow;
use crate::model::{Coordinate, Dependence, Dependences, Model};
use crate::symbolic::{Expr, Function, Graph, Node, Symbol, TableId};

/// One of them.
pub struct Switching {
    /// Its value.
    pub value: Expr,
    /// The table whose rows count; if there is none, its zeros do.
    pub table: Option<TableId>,
    /// Whether it is of the first degree in time; where it is one of the state, in positions and speeds too.
    pub is_affine: bool,
    /// What is there.
    pub kind: SwitchingKind,
}

/// What is where a [`Switching`] is zero.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SwitchingKind {
    /// Expressions change their form.
    Form,
    /// A load may be infinite.
    Pole,
    /// The middle of a smooth pulse or step, which a long step might not see; expressions keep their form.
    Middle,
    /// A flank of one.
    Flank,
    /// Nothing: it is what a sine, cosine or tangent in one of the others is of, in radians. Where that changes by much in a step, the
    /// other goes to and fro.
    Phase,
    /// An output changes its form, or has the middle of a pulse or a flank of one; what acts does not.
    Output,
}

/// What expressions depend on, with each input as what its declared course is made of: one that is held is a parameter.
pub(super) fn with_inputs(graph: &Graph, model: &Model) -> Dependences {
    model.inputs.iter().fold(model.dependences.clone(), |mut dependences, input| {
        let changes = dependences.of(graph, input.course).meets(Dependence::TIME);
        let kind = if changes { Dependence::TIME.or(Dependence::INPUT) } else { Dependence::PARAMETER };
        dependences.redeclared(input.symbol, kind)
    })
}

/// Those of time alone in a graph, each once.
pub(super) fn of_time(graph: &mut Graph, model: &Model) -> Vec<Switching> {
    let all: Vec<Expr> = graph.expressions().collect();
    let switched = switched(graph, all);
    let mut dependences = with_inputs(graph, model);
    let mut found: Vec<Switching> = Vec::new();
    for (value, table) in switched {
        if is_new(&found, value, table) && is_of_time(graph, &mut dependences, value) {
            found.push(Switching {
                value,
                table,
                is_affine: is_affine(graph, &mut dependences, value, Dependence::TIME),
                kind: SwitchingKind::Form,
            });
        }
    }
    found
}

/// Those of loads that depend on positions or speeds, each once.
pub(super) fn of_loads(graph: &mut Graph, model: &Model, rows: &[LoadRow]) -> Vec<Switching> {
    let searched = graph.reachable(&searched(model, rows));
    let switched = switched(graph, searched).into_iter();
    let forms = switched.map(|(value, table)| (value, table, SwitchingKind::Form));
    let mut dependences = with_inputs(graph, model);
    let mut found: Vec<Switching> = Vec::new();
    let poles = graph.reachable(&made_of(rows)).into_iter().flat_map(|expr| denominators(graph, graph.node(expr)));
    // First, as a condition may be that of a pole: `if x > 0 then k/x^2 else 0`.
    for (value, table, kind) in poles.map(|pole| (pole, None, SwitchingKind::Pole)).chain(forms) {
        if is_new(&found, value, table)
            && dependences.of(graph, value).meets(Dependence::COORDINATE.or(Dependence::SPEED))
        {
            let is_affine = is_affine_in_state(graph, model, &mut dependences, value);
            if is_affine || kind != SwitchingKind::Pole {
                found.push(Switching { value, table, is_affine, kind });
            }
        }
    }
    found
}

/// Those of outputs that are known from positions and speeds, but for those known already, each once.
pub(super) fn of_outputs(graph: &mut Graph, model: &Model, known: &[Switching]) -> Vec<Switching> {
    let made_of = graph.reachable(&output_values(model));
    let switched = switched(graph, made_of);
    let (mut dependences, mut found) = (with_inputs(graph, model), Vec::new());
    let unknown = Dependence::ACCELERATION.or(Dependence::MULTIPLIER);
    for (value, table) in switched {
        if is_new(known, value, table)
            && is_new(&found, value, table)
            && dependences.of(graph, value).meets(Dependence::COORDINATE.or(Dependence::SPEED))
            && !dependences.of(graph, value).meets(unknown)
        {
            let is_affine = is_affine_in_state(graph, model, &mut dependences, value);
            found.push(Switching { value, table, is_affine, kind: SwitchingKind::Output });
        }
    }
    found
}

pub(super) fn output_values(model: &Model) -> Vec<Expr> {
    model.outputs.iter().map(|output| output.value).collect()
}

/// The denominators that may change their signs. Where one of the first degree is zero may be a pole, which no motion passes, but a long
/// step would; others, as of angles, mostly are never zero.
fn denominators(graph: &Graph, node: &Node) -> Vec<Expr> {
    let Node::Product { factors, .. } = node else { return Vec::new() };
    let may_be_crossed = |(base, exponent): &&(Expr, i64)| *exponent < 0 && !graph.is_nonnegative(*base);
    factors.iter().filter(may_be_crossed).map(|(base, _)| *base).collect()
}

/// What sines, cosines and tangents in these conditions are of, each once: where that changes by much in a step, the conditions go to and fro in
/// it. Angles themselves, and the sums of two, change little more than the coordinates, which the runtime knows.
pub(super) fn phases(graph: &Graph, model: &Model, conditions: &[Switching]) -> Vec<Switching> {
    let mut dependences = with_inputs(graph, model);
    let values: Vec<Expr> = conditions.iter().map(|condition| condition.value).collect();
    let mut found: Vec<Switching> = Vec::new();
    for expr in graph.reachable(&values) {
        if let Node::Call(Function::Sin | Function::Cos | Function::Tan, argument) = graph.node(expr)
            && is_new(&found, *argument, None)
            && dependences.of(graph, *argument).meets(Dependence::COORDINATE)
            && !is_of_two_angles(graph, model, *argument)
        {
            let value = *argument;
            found.push(Switching { value, table: None, is_affine: false, kind: SwitchingKind::Phase });
        }
    }
    found
}

/// Whether it is an angle, or a sum or a difference of two, one of which may be a parameter, but for a number.
fn is_of_two_angles(graph: &Graph, model: &Model, expr: Expr) -> bool {
    let is_known = |term: Expr| match graph.node(term) {
        Node::Symbol(symbol) => {
            let is_angle = |coordinate: &Coordinate| coordinate.position == *symbol && !coordinate.unit.is_length();
            model.coordinates.iter().any(is_angle)
                || model.parameters.iter().any(|parameter| parameter.symbol == *symbol)
        }
        _ => false,
    };
    match graph.node(expr) {
        Node::Sum { terms, .. } => {
            terms.len() <= 2 && terms.iter().all(|(term, times)| is_known(*term) && times.abs().is_one())
        }
        _ => is_known(expr),
    }
}

/// Whether a condition is of the first degree in time, positions and speeds, with nothing else in it but parameters.
pub(super) fn is_affine_in_state(graph: &Graph, model: &Model, dependences: &mut Dependences, value: Expr) -> bool {
    let of_state = Dependence::TIME.or(Dependence::COORDINATE).or(Dependence::SPEED);
    let is_known = |symbol: Symbol| {
        let mut coordinates = model.coordinates.iter();
        symbol == model.time
            || coordinates.any(|coordinate| [coordinate.position, coordinate.speed].contains(&symbol))
            || model.parameters.iter().any(|parameter| parameter.symbol == symbol)
    };
    graph.symbols_of(&[value]).into_iter().all(is_known) && is_affine(graph, dependences, value, of_state)
}

/// All that forces and what they act along are made of, since a potential is one of -1 along itself, and constraints.
pub(super) fn searched(model: &Model, rows: &[LoadRow]) -> Vec<Expr> {
    made_of(rows).into_iter().chain(model.constraints.iter().map(|constraint| constraint.value)).collect()
}

/// Forces, and what they act along.
fn made_of(rows: &[LoadRow]) -> Vec<Expr> {
    rows.iter().flat_map(|row| row.forces.iter().copied().chain([row.quantity()])).collect()
}

/// What expressions change their form by.
fn switched(graph: &mut Graph, exprs: Vec<Expr>) -> Vec<(Expr, Option<TableId>)> {
    let by = |graph: &mut Graph, expr: Expr| match *graph.node(expr) {
        Node::Atan2(y, x) => Some((cut(graph, y, x), None)),
        ref node => switched_by(node),
    };
    exprs.into_iter().filter_map(|expr| by(graph, expr)).collect()
}

/// What is zero at the cut of `atan2(y, x)` alone: y, where x is negative, and -1 elsewhere. The sign changes at x = 0 too, where y is
/// positive, and nothing jumps.
fn cut(graph: &mut Graph, y: Expr, x: Expr) -> Expr {
    let (behind, elsewhere) = (graph.neg(x), graph.integer(-1));
    graph.choice(behind, y, elsewhere)
}

/// What a node changes its form by.
fn switched_by(node: &Node) -> Option<(Expr, Option<TableId>)> {
    match node {
        Node::Choice(difference, _, _) => Some((*difference, None)),
        Node::Call(Function::Abs | Function::Sign, argument) => Some((*argument, None)),
        Node::Table(table, _, argument) => Some((*argument, Some(*table))),
        _ => None,
    }
}

pub(super) fn is_new(found: &[Switching], value: Expr, table: Option<TableId>) -> bool {
    !found.iter().any(|known| (known.value, known.table) == (value, table))
}

pub(super) fn is_of_time(graph: &Graph, dependences: &mut Dependences, expr: Expr) -> bool {
    let (on, allowed) = (dependences.of(graph, expr), Dependence::TIME.or(Dependence::PARAMETER).or(Dependence::INPUT));
    on.meets(Dependence::TIME) && on.or(allowed) == allowed
}

/// Whether a function is written as one of the first degree in what changes.
pub(super) fn is_affine(graph: &Graph, dependences: &mut Dependences, expr: Expr, changing: Dependence) -> bool {
    if !dependences.of(graph, expr).meets(changing) {
        return true;
    }
    match graph.node(expr) {
        // What course an input follows is not known here.
        Node::Symbol(_) => !dependences.of(graph, expr).meets(Dependence::INPUT),
        Node::Sum { terms, .. } => terms.iter().all(|(term, _)| is_affine(graph, dependences, *term, changing)),
        Node::Product { factors, .. } => {
            let mut of_those = factors.iter().filter(|(base, _)| dependences.of(graph, *base).meets(changing));
            match (of_those.next(), of_those.next()) {
                (Some((base, 1)), None) => is_affine(graph, dependences, *base, changing),
                _ => false,
            }
        }
        _ => false,
    }
}
