//! Where the slopes of tables may jump.

use super::Level;
use super::interpreter::Interpreter;
use crate::dsl::Region;
use crate::symbolic::{Expr, Graph};

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

/// A table with a jumping derivative that enters a speed.
fn rough(graph: &Graph, values: &[Expr], level: Level) -> Option<String> {
    let used = graph.reachable(values);
    let rates = u8::from(level == Level::Positions);
    let rough = graph.look_ups().into_iter().find(|(expr, table, order)| {
        graph.table(*table).smoothness < *order + rates && used.binary_search(expr).is_ok()
    });
    rough.map(|(_, table, _)| graph.table(table).name.clone())
}
