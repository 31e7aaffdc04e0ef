//! Where the slopes of tables may jump.

use super::interpreter::Interpreter;
use super::{Dependence, Level};
use crate::dsl::Region;
use crate::symbolic::{Expr, Function, Graph, Node};

impl Interpreter {
    /// Refuses tables with jumping derivatives where speeds would jump with them.
    pub(super) fn smooth(&mut self, place: Region, values: &[Expr], level: Level, what: &str) -> Option<()> {
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
