//! Checks of expressions that must be linear in the rates of the coordinates: constraints between speeds, and
//! generalised speeds.

use super::Dependence;
use super::interpreter::Interpreter;
use super::level::BEYOND_SPEED;
use crate::dsl::Region;
use crate::symbolic::{Differential, Expr, Node, Symbol};

/// The longest sum allowed when multiplying out, to see squares of speeds cancel.
const LONGEST: usize = 256;

/// Refuses rows that are not linear in the speeds, and accelerations.
pub(super) fn linear_in_speeds(place: Region, rows: &[Expr], interpreter: &mut Interpreter) -> Option<()> {
    interpreter.restrict(
        place,
        rows,
        Dependence::MULTIPLIER,
        "a constraint holds between positions or speeds, not reactions",
    )?;
    interpreter.restrict(
        place,
        rows,
        BEYOND_SPEED,
        "a constraint holds between positions or speeds; `ddot()` cannot stand in it: write its integral, with `dot()`",
    )?;
    first_power(
        place,
        rows,
        "a constraint between speeds must be linear in them, `a*dot(x) + b*dot(y) = c`",
        interpreter,
    )
}

/// Refuses expressions that are not linear in the speeds; `rule` says what they must be.
pub(super) fn first_power(place: Region, rows: &[Expr], rule: &str, interpreter: &mut Interpreter) -> Option<()> {
    for row in rows {
        for speed in speeds(*row, interpreter) {
            let slope = Differential::partial(&mut interpreter.graph, speed).of(&mut interpreter.graph, *row);
            if depends_on_speed(slope, interpreter) {
                let name = interpreter.graph.symbol_name(speed).trim_end_matches("_dot").to_owned();
                let message = format!("{rule}; `dot({name})` is not linear here");
                return interpreter.refuse(place, message);
            }
        }
    }
    Some(())
}

/// The speeds in an expression.
fn speeds(expr: Expr, interpreter: &mut Interpreter) -> Vec<Symbol> {
    let reachable = interpreter.graph.reachable(&[expr]);
    let symbols = reachable.into_iter().filter_map(|expr| match interpreter.graph.node(expr) {
        Node::Symbol(symbol) => Some((expr, *symbol)),
        _ => None,
    });
    let symbols: Vec<(Expr, Symbol)> = symbols.collect();
    let is_speed = |expr: Expr, interpreter: &mut Interpreter| {
        interpreter.dependences.of(&interpreter.graph, expr).meets(Dependence::SPEED)
    };
    symbols.into_iter().filter(|(expr, _)| is_speed(*expr, interpreter)).map(|(_, symbol)| symbol).collect()
}

fn depends_on_speed(expr: Expr, interpreter: &mut Interpreter) -> bool {
    let meets = |expr: Expr, interpreter: &mut Interpreter| {
        interpreter.dependences.of(&interpreter.graph, expr).meets(Dependence::SPEED)
    };
    meets(expr, interpreter)
        && interpreter.graph.expand(expr, LONGEST).is_none_or(|expanded| meets(expanded, interpreter))
}
