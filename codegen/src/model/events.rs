//! The `events` block: conditions and their actions.

use super::equations::equation_sides;
use super::interpreter::Interpreter;
use super::level::{MOVING, no_input};
use super::loads::named;
use super::plain::in_unit;
use super::scope::{Names, plain};
use super::value::Shape;
use super::{Conditional, Coordinate, Dependence, Dimension, Event, EventStep, Parameter, Target, Unit};
use crate::dsl::{self, Action, Activity, Declaration, Expression, Region};
use crate::nearest;
use crate::symbolic::{Expr, evaluate};
use syn::Ident;

/// The names that actions refer to.
pub(super) struct Known<'a> {
    pub(super) coordinates: &'a [Coordinate],
    pub(super) parameters: &'a [Parameter],
    pub(super) conditionals: &'a [Conditional],
}

const FORCES: Dependence = Dependence::ACCELERATION.or(Dependence::MULTIPLIER);

pub(super) fn resolve_events(declaration: &Declaration, known: &Known, interpreter: &mut Interpreter) -> Vec<Event> {
    let mut names = Names::new("event");
    let mut events = Vec::new();
    for event in &declaration.events {
        names.define(&event.condition.name, Some(()), &mut interpreter.mistakes);
        let condition = condition(&event.condition, interpreter);
        let steps = steps(event, declaration, known, interpreter);
        let Some(value) = condition else { continue };
        let dependence = interpreter.dependences.of(&interpreter.graph, value);
        let [on_motion, on_forces] = [MOVING.or(FORCES), FORCES].map(|kind| dependence.meets(kind));
        let name = plain(&event.condition.name);
        events.push(Event { name, value, direction: event.direction, on_motion, on_forces, steps });
    }
    events
}

/// left - right.
fn condition(equation: &dsl::Equation, interpreter: &mut Interpreter) -> Option<Expr> {
    let place = equation.left.region.to(equation.right.region);
    let Shape::Scalar(value) = equation_sides(equation, interpreter)?.shape else {
        return interpreter.refuse(place, "an event is an equation between scalars; take a component (`.x`, `.y`)");
    };
    no_input(place, &[value], "an event", interpreter)?;
    if !interpreter.dependences.of(&interpreter.graph, value).meets(MOVING.or(FORCES).or(Dependence::TIME)) {
        let message = format!(
            "event `{}` never changes; make it depend on a coordinate, a speed, a reaction or `t`",
            equation.name
        );
        return interpreter.refuse(Region::from(&equation.name), message);
    }
    Some(value)
}

/// The actions of an event; consecutive ones of one kind happen at once.
fn steps(
    event: &dsl::Event,
    declaration: &Declaration,
    known: &Known,
    interpreter: &mut Interpreter,
) -> Vec<EventStep> {
    let mut steps: Vec<EventStep> = Vec::new();
    let mut before = None;
    for action in &event.actions {
        // What stands between two actions of one kind separates them, `record` too.
        let kind = std::mem::discriminant(action);
        let continues = before.replace(kind) == Some(kind);
        let last = if continues { steps.last_mut() } else { None };
        match (last, step(action, declaration, known, interpreter)) {
            (Some(EventStep::Set(before)), Some((EventStep::Set(more), place))) => {
                if let Some((target, _)) = more.iter().find(|(target, _)| before.iter().any(|(b, _)| b == target)) {
                    let what = told(*target, known);
                    interpreter.mistakes.add(place.error(format!("{what} is set twice at once; keep one")));
                }
                before.extend(more);
            }
            (Some(EventStep::Switch(before)), Some((EventStep::Switch(more), place))) => {
                if more.iter().any(|(index, _)| before.iter().any(|(b, _)| b == index)) {
                    interpreter.mistakes.add(place.error("this constraint is switched twice at once; keep one"));
                }
                before.extend(more);
            }
            (Some(EventStep::Impact(before)), Some((EventStep::Impact(more), place))) => {
                if more.iter().any(|(index, _)| before.iter().any(|(b, _)| b == index)) {
                    interpreter.mistakes.add(place.error("this constraint is hit twice at once; keep one"));
                }
                before.extend(more);
            }
            (_, Some((step, _))) => steps.push(step),
            (_, None) => {}
        }
    }
    steps
}

fn told(target: Target, known: &Known) -> String {
    match target {
        Target::Parameter(index) => format!("`{}`", known.parameters[index].name),
        Target::Position(index) => format!("`{}`", known.coordinates[index].name),
        Target::Speed(index) => format!("`dot({})`", known.coordinates[index].name),
    }
}

/// One action with its place; nothing for `record`, which is the default.
fn step(
    action: &Action,
    declaration: &Declaration,
    known: &Known,
    interpreter: &mut Interpreter,
) -> Option<(EventStep, Region)> {
    match action {
        Action::Record => None,
        Action::Stop { after, place } => Some((EventStep::Stop(*after), *place)),
        Action::Set { name, is_speed, value } => {
            let (target, unit) = target(name, *is_speed, known, interpreter)?;
            let value = assigned(value, target, &unit, known, interpreter)?;
            Some((EventStep::Set(vec![(target, value)]), name.into()))
        }
        Action::Swap(first, second) => {
            let (a, b) = (coordinate(first, known, interpreter), coordinate(second, known, interpreter));
            let (a, b) = (a?, b?);
            if a == b {
                return interpreter.refuse(second.into(), "a coordinate is swapped with another one, not with itself");
            }
            let (one, other) = (named(first), named(second));
            let (of_one, of_other) = (interpreter.value(&one)?, interpreter.value(&other)?);
            interpreter.common_dimension(
                of_one.measured(&one),
                of_other.measured(&other),
                "only quantities of one dimension are swapped",
            );
            let of = |index: usize| (known.coordinates[index].position, known.coordinates[index].speed);
            let mut sets = Vec::new();
            for (to, from) in [(a, b), (b, a)] {
                let (position, speed) = of(from);
                sets.push((Target::Position(to), interpreter.graph.variable(position)));
                sets.push((Target::Speed(to), interpreter.graph.variable(speed)));
            }
            Some((EventStep::Set(sets), first.into()))
        }
        Action::Switch { constraint, to } => {
            let index = conditional(constraint, declaration, known, interpreter)?;
            Some((EventStep::Switch(vec![(index, *to == Activity::Active)]), constraint.into()))
        }
        Action::Impact { constraint, restitution } => {
            let index = conditional(constraint, declaration, known, interpreter);
            let coefficient = match restitution {
                Some(expression) => coefficient(expression, interpreter),
                None => Some(interpreter.graph.zero()),
            };
            Some((EventStep::Impact(vec![(index?, coefficient?)]), constraint.into()))
        }
    }
}

/// A coordinate, its speed or a parameter, with the unit that plain numbers are in.
fn target(name: &Ident, is_speed: bool, known: &Known, interpreter: &mut Interpreter) -> Option<(Target, Unit)> {
    let text = plain(name);
    let parameter = known.parameters.iter().position(|p| p.name == text);
    if let Some(index) = parameter {
        if is_speed {
            return interpreter
                .refuse(name.into(), format!("`{text}` is a parameter and has no speed: `set {text} = ..;`"));
        }
        return Some((Target::Parameter(index), known.parameters[index].unit.clone()));
    }
    if !is_speed && !known.coordinates.iter().any(|c| c.name == text) {
        let base = text.strip_suffix("_dot").filter(|base| known.coordinates.iter().any(|c| c.name == *base));
        let names = known.coordinates.iter().map(|c| c.name.as_str());
        let near = match base {
            Some(base) => format!(" (write `set dot({base}) = ..;`)"),
            None => nearest::suggestion(&text, names.chain(known.parameters.iter().map(|p| p.name.as_str()))),
        };
        let message = format!(
            "no coordinate or parameter is called `{text}`{near}; coordinates, their speeds and parameters are set"
        );
        return interpreter.refuse(name.into(), message);
    }
    let index = coordinate(name, known, interpreter)?;
    let unit = &known.coordinates[index].unit;
    Some(match is_speed {
        true => (Target::Speed(index), unit.per_time(1)),
        false => (Target::Position(index), unit.clone()),
    })
}

fn coordinate(name: &Ident, known: &Known, interpreter: &mut Interpreter) -> Option<usize> {
    let text = plain(name);
    let found = known.coordinates.iter().position(|c| c.name == text);
    if found.is_none() {
        let near = nearest::suggestion(&text, known.coordinates.iter().map(|c| c.name.as_str()));
        return interpreter.refuse(name.into(), format!("no coordinate is called `{text}`{near}"));
    }
    found
}

/// A constraint that events may switch.
fn conditional(name: &Ident, declaration: &Declaration, known: &Known, interpreter: &mut Interpreter) -> Option<usize> {
    let text = plain(name);
    if let Some(index) = known.conditionals.iter().position(|c| c.name == text) {
        return Some(index);
    }
    if declaration.constraints.iter().any(|c| c.name == *name) {
        let message = format!(
            "constraint `{text}` always holds; one that events switch or hit is declared `{text}: .. initially released;` \
             or `initially active`"
        );
        return interpreter.refuse(name.into(), message);
    }
    let names: Vec<String> = declaration.constraints.iter().map(|c| plain(&c.name)).collect();
    let whole = names.iter().find(|whole| ["x", "y", "z"].iter().any(|row| text == format!("{whole}_{row}")));
    let near = match whole {
        Some(whole) => format!(" (did you mean `{whole}`? Its rows are switched together)"),
        None => nearest::suggestion(&text, names.iter().map(String::as_str)),
    };
    interpreter.refuse(name.into(), format!("no constraint is called `{text}`{near}"))
}

/// A value computed from the state before: plain numbers are in the unit of the target.
fn assigned(
    expression: &Expression,
    target: Target,
    unit: &Unit,
    known: &Known,
    interpreter: &mut Interpreter,
) -> Option<Expr> {
    let rule = "an event sets values made of coordinates, speeds, parameters and `t`; accelerations and reactions are \
                not known there";
    in_unit(expression, told(target, known).trim_matches('`'), unit, (FORCES, rule), interpreter)
}

/// A ratio of speeds.
fn coefficient(expression: &Expression, interpreter: &mut Interpreter) -> Option<Expr> {
    let value = interpreter.scalar_of(expression, &Dimension::none(), "a coefficient of restitution")?;
    let rule = "a coefficient of restitution follows from coordinates, speeds, parameters and `t`";
    interpreter.restrict(expression.region, &[value], FORCES, rule)?;
    let is_number = interpreter.dependences.of(&interpreter.graph, value) == Dependence::NONE;
    if is_number && evaluate(&interpreter.graph, &[value], |_| f64::NAN)[0] < 0.0 {
        return interpreter.refuse(
            expression.region,
            "a coefficient of restitution is not negative: 0 for no rebound, 1 for a full one",
        );
    }
    Some(value)
}
