//! Where values, or the slopes of tables, jump while the motion goes on.

use super::interpreter::Interpreter;
use super::{Dependence, Dependences, Level};
use crate::dsl::Region;
use crate::symbolic::{Expr, Function, Graph, Node};

impl Interpreter {
    /// Refuses tables with jumping derivatives where speeds would jump with them, and positions that jump.
    pub(super) fn smooth(&mut self, place: Region, values: &[Expr], level: Level, what: &str) -> Option<()> {
        if level == Level::Positions {
            let moving = Dependence::TIME.or(Dependence::COORDINATE).or(Dependence::INPUT);
            let why = "nothing moves so far in no time: let it change within some time";
            self.no_jump(place, values, moving, &format!("{what} jumps here, and {why}"))?;
        }
        match rough(&self.graph, values, level) {
            Some(name) => {
                let message = format!(
                    "the slope of table `{name}` jumps at its rows, and speeds would jump with it: a table in {what} is `cubic`"
                );
                self.refuse(place, message)
            }
            None => Some(()),
        }
    }
}

impl Interpreter {
    /// Refuses values that jump with what is moving.
    pub(super) fn no_jump(&mut self, place: Region, values: &[Expr], moving: Dependence, why: &str) -> Option<()> {
        let jumps = values.iter().any(|value| jumps(&mut self.graph, &mut self.dependences, *value, moving));
        if jumps { self.refuse(place, why.to_owned()) } else { Some(()) }
    }
}

/// Whether a value certainly jumps: by `sign`, or by an `if` between values that differ by a constant, where nothing that moves
/// multiplies them.
fn jumps(graph: &mut Graph, dependences: &mut Dependences, expr: Expr, moving: Dependence) -> bool {
    match graph.node(expr).clone() {
        Node::Sum { terms, .. } => terms.into_iter().any(|(term, _)| jumps(graph, dependences, term, moving)),
        Node::Product { factors, .. } => {
            let mut moved = factors.into_iter().filter(|(base, _)| dependences.of(graph, *base).meets(moving));
            match (moved.next(), moved.next()) {
                (Some((base, 1)), None) => jumps(graph, dependences, base, moving),
                _ => false,
            }
        }
        Node::Call(Function::Sign, by) => dependences.of(graph, by).meets(moving),
        Node::Choice(by, above, otherwise) => {
            let apart = graph.sub(above, otherwise);
            let differs = apart != graph.integer(0) && !dependences.of(graph, apart).meets(moving);
            dependences.of(graph, by).meets(moving) && differs
                || [above, otherwise].into_iter().any(|value| jumps(graph, dependences, value, moving))
        }
        _ => false,
    }
}

/// Whether values may jump while the motion goes on: by `sign`, or by an `if` that is no `min` or `max`.
pub(super) fn may_jump(interpreter: &mut Interpreter, values: &[Expr]) -> bool {
    let moving = Dependence::TIME.or(Dependence::COORDINATE).or(Dependence::SPEED);
    let Interpreter { graph, dependences, .. } = interpreter;
    graph.reachable(values).into_iter().any(|expr| match *graph.node(expr) {
        Node::Call(Function::Sign, by) => dependences.of(graph, by).meets(moving),
        Node::Choice(by, above, otherwise) if dependences.of(graph, by).meets(moving) => {
            let apart = graph.sub(above, otherwise);
            by != apart && graph.neg(by) != apart
        }
        _ => false,
    })
}

/// A table with a jumping derivative that enters a speed.
fn rough(graph: &Graph, values: &[Expr], level: Level) -> Option<String> {
    let used = graph.reachable(values);
    let rates = u8::from(level == Level::Positions);
    let rough = graph.look_ups().into_iter().find(|(expr, table, order)| {
        graph.table(*table).smoothness < *order + rates && used.binary_search(expr).is_ok()
    });
    rough.map(|(_, table, _)| graph.table(table).name.clone())
}
