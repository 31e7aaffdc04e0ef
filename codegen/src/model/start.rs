//! The `initial` block.

use super::interpreter::Interpreter;
use super::level::MOVING;
use super::plain::in_unit;
use super::scope::plain;
use super::{Coordinate, Dependence, Start, Unit};
use crate::dsl::{Declaration, Expression, InitialKind, Region};
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
