//! The `initial` block.

use super::homogeneity::Measured;
use super::interpret::Interpreter;
use super::level::MOVING;
use super::scope::{functions, plain};
use super::{Coordinate, Dependence, Start, Unit};
use crate::dsl::{Declaration, Expression, InitialKind, Kind, Region};
use crate::symbolic::Expr;

/// Enters the start values into their coordinates.
pub(super) fn resolve_initial(
    declaration: &Declaration,
    coordinates: &mut [Coordinate],
    interpreter: &mut Interpreter,
) {
    let mut seen: Vec<(String, bool, Region)> = Vec::new();
    for line in &declaration.initial {
        let name = plain(&line.coordinate);
        let Some(at) = coordinates.iter().position(|c| c.name == name) else {
            let base = name.strip_suffix("_dot").filter(|base| coordinates.iter().any(|c| c.name == *base));
            let near = match base {
                Some(base) => format!(" (write `dot({base}) = ..;`)"),
                None if declaration.speeds.iter().any(|speed| plain(&speed.name) == name) => {
                    " (a generalised speed follows from the rates of coordinates: `dot(..) = ..;`)".to_owned()
                }
                None => crate::nearest::suggestion(&name, coordinates.iter().map(|c| c.name.as_str())),
            };
            interpreter.mistakes.add(
                Region::from(&line.coordinate)
                    .error(format!("no coordinate is called `{name}`{near}; only coordinates have start values")),
            );
            continue;
        };
        let is_speed = line.kind == InitialKind::Speed;
        let place = Region::from(&line.coordinate);
        if let Some((.., first)) = seen.iter().find(|(n, speed, _)| *n == name && *speed == is_speed) {
            let what = if is_speed { "speed" } else { "start" };
            let mut mistake = place.error(format!("the {what} of `{name}` is given twice; keep one"));
            mistake.combine(first.error("it is first given here"));
            interpreter.mistakes.add(mistake);
            continue;
        }
        seen.push((name, is_speed, place));
        let (unit, what) = match is_speed {
            true => (coordinates[at].unit.per_time(1), format!("dot({})", coordinates[at].name)),
            false => (coordinates[at].unit.clone(), coordinates[at].name.clone()),
        };
        let Some(value) = start_value(&line.value, &what, &unit, interpreter) else { continue };
        match line.kind {
            InitialKind::Position => coordinates[at].start = Start::Given(value),
            InitialKind::Guess => coordinates[at].start = Start::Guess(value),
            InitialKind::Speed => coordinates[at].start_speed = Some(value),
        }
    }
}

fn start_value(expression: &Expression, what: &str, unit: &Unit, interpreter: &mut Interpreter) -> Option<Expr> {
    let moving = MOVING.or(Dependence::TIME).or(Dependence::MULTIPLIER).or(Dependence::INPUT);
    in_unit(expression, what, unit, (moving, "a start value is made of numbers and parameters"), interpreter)
}

/// A scalar for what has the unit, with what it must not depend on and why; if it is made of plain numbers only, they
/// are in that unit.
pub(super) fn in_unit(
    expression: &Expression,
    what: &str,
    unit: &Unit,
    (forbidden, rule): (Dependence, &str),
    interpreter: &mut Interpreter,
) -> Option<Expr> {
    let (value, dimension) = interpreter.scalar_value(expression)?;
    interpreter.restrict(expression.region, &[value], forbidden, rule)?;
    if !is_plain(expression) {
        let found = Measured { expression, dimension: &dimension };
        let (name, is) = match what.strip_prefix("dot(").and_then(|rest| rest.strip_suffix(')')) {
            Some(name) => (name, "is"),
            None => (what, "is declared"),
        };
        // Whatever stands here fits if the unit of the name is mistaken.
        let is_mistaken = interpreter.values.get(name).is_some_and(|value| value.dimension.is_none());
        if !is_mistaken {
            interpreter.expect_unit(found, &format!("`{what}` {is}"), name, unit);
        }
        return Some(value);
    }
    let factor = unit.factor_expression(&mut interpreter.graph);
    let value = interpreter.graph.mul(value, factor);
    interpreter.check_constants(expression.region, &[value])?;
    Some(value)
}

/// Whether no name but pi and e occurs.
pub(super) fn is_of_numbers(expression: &Expression) -> bool {
    match &expression.kind {
        Kind::Number { .. } => true,
        Kind::Name(name) => name == "pi" || name == "e",
        // A table has its own units.
        Kind::Call(function, _) if !functions().any(|known| function == known) => false,
        _ => expression.parts().into_iter().all(is_of_numbers),
    }
}

/// Whether no unit occurs either.
pub(super) fn is_plain(expression: &Expression) -> bool {
    is_of_numbers(expression) && !has_unit(expression)
}

fn has_unit(expression: &Expression) -> bool {
    match &expression.kind {
        Kind::Number { unit, .. } => unit.is_some(),
        Kind::Name(_) => false,
        _ => expression.parts().into_iter().any(has_unit),
    }
}
