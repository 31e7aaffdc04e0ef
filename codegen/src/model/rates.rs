//! What must be linear in the rates of the coordinates: constraints between speeds, and generalised speeds.

use super::Dependence;
use super::interpret::Interpreter;
use super::level::BEYOND_SPEED;
use crate::dsl::Region;
use crate::symbolic::{Differential, Expr, Node, Symbol};

/// The longest sum that multiplying out may make, to see that squares of speeds cancel.
const LONGEST: usize = 256;

/// Refuses rows in which a speed occurs otherwise than to the first power, and accelerations.
pub(super) fn linear_in_speeds(place: Region, rows: &[Expr], i: &mut Interpreter) -> Option<()> {
    i.restrict(place, rows, Dependence::MULTIPLIER, "a constraint holds between positions or speeds, not reactions")?;
    i.restrict(
        place,
        rows,
        BEYOND_SPEED,
        "a constraint holds between positions or speeds; `ddot()` cannot stand in it: write its integral, with `dot()`",
    )?;
    first_power(place, rows, "a constraint between speeds must be linear in them, `a*dot(x) + b*dot(y) = c`", i)
}

/// Refuses expressions in which a speed occurs otherwise than to the first power; `rule` says what they must be.
pub(super) fn first_power(place: Region, rows: &[Expr], rule: &str, i: &mut Interpreter) -> Option<()> {
    for row in rows {
        for speed in speeds(*row, i) {
            let slope = Differential::partial(&mut i.graph, speed).of(&mut i.graph, *row);
            if depends_on_speed(slope, i) {
                let name = i.graph.symbol_name(speed).trim_end_matches("_dot").to_owned();
                let message = format!("{rule}; `dot({name})` does not stand to the first power here");
                return i.refuse(place, message);
            }
        }
    }
    Some(())
}

/// The speeds in an expression.
fn speeds(expr: Expr, i: &mut Interpreter) -> Vec<Symbol> {
    let reachable = i.graph.reachable(&[expr]);
    let symbols = reachable.into_iter().filter_map(|expr| match i.graph.node(expr) {
        Node::Symbol(symbol) => Some((expr, *symbol)),
        _ => None,
    });
    let symbols: Vec<(Expr, Symbol)> = symbols.collect();
    let is_speed = |expr: Expr, i: &mut Interpreter| i.dependences.of(&i.graph, expr).meets(Dependence::SPEED);
    symbols.into_iter().filter(|(expr, _)| is_speed(*expr, i)).map(|(_, symbol)| symbol).collect()
}

fn depends_on_speed(expr: Expr, i: &mut Interpreter) -> bool {
    let meets = |expr: Expr, i: &mut Interpreter| i.dependences.of(&i.graph, expr).meets(Dependence::SPEED);
    meets(expr, i) && i.graph.expand(expr, LONGEST).is_none_or(|expanded| meets(expanded, i))
}
