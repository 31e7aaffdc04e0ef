//! Coordinates, parameters and `let`s: the names of scalars and vectors.

use super::interpreter::Interpreter;
use super::level::MOVING;
use super::origin::Origin;
use super::plain::in_unit;
use super::scope::{check_reserved, plain};
use super::value::{Shape, Value};
use super::{Body, Constraint, Coordinate, Dependence, Input, Parameter, Start, Unit};
use crate::dsl::{self, Declaration, Expression, Region};
use crate::symbolic::{Expr, Symbol};
use syn::Ident;

/// The meaning of a declared unit; `None` if it is a recorded mistake.
pub(super) fn resolve_unit(unit: &Option<dsl::Unit>, interpreter: &mut Interpreter) -> Option<Unit> {
    match unit {
        Some(unit) => interpreter.mistakes.note(Unit::resolve(unit)),
        None => Some(Unit::none()),
    }
}

/// Defines a coordinate or parameter. One with an invalid unit has a dimension that fits everywhere.
fn define_symbol(
    name: &Ident,
    symbol: Symbol,
    written: &Option<dsl::Unit>,
    unit: Option<&Unit>,
    interpreter: &mut Interpreter,
) {
    let origin = Origin::Declared(written.as_ref().map(|unit| unit.text.clone()));
    interpreter.origins.add(plain(name), origin);
    let variable = interpreter.graph.variable(symbol);
    define(name, Some(Value::scalar(variable, unit.map(|unit| unit.dimension().clone()))), interpreter);
}

pub(super) fn define(name: &Ident, value: Option<Value>, interpreter: &mut Interpreter) {
    if let Err(mistake) = check_reserved(name) {
        interpreter.mistakes.add(mistake);
        interpreter.misnamed.push(plain(name));
        return;
    }
    match interpreter.tables.check_free(name) {
        Ok(()) => interpreter.values.define(name, value, &mut interpreter.mistakes),
        Err(mistake) => interpreter.mistakes.add(mistake),
    }
}

pub(super) fn resolve_coordinates(declaration: &Declaration, interpreter: &mut Interpreter) -> Vec<Coordinate> {
    let mut coordinates: Vec<Coordinate> = Vec::new();
    for c in &declaration.coordinates {
        let name = plain(&c.name);
        refuse_rate(&c.name, declaration, interpreter);
        let unit = resolve_unit(&c.unit, interpreter);
        let position = interpreter.graph.symbol(&name);
        let speed = interpreter.graph.symbol(&format!("{name}_dot"));
        let acceleration = interpreter.graph.symbol(&format!("{name}_ddot"));
        interpreter.dependences.declare(position, Dependence::COORDINATE);
        interpreter.dependences.declare(speed, Dependence::SPEED);
        interpreter.dependences.declare(acceleration, Dependence::ACCELERATION);
        define_symbol(&c.name, position, &c.unit, unit.as_ref(), interpreter);
        let unit = unit.unwrap_or_else(Unit::none);
        let (docs, start, start_speed) = (c.docs.clone(), Start::Free, None);
        coordinates.push(Coordinate { name, docs, unit, position, speed, acceleration, start, start_speed });
    }
    coordinates
}

/// Refuses a name that the speed or acceleration of a coordinate has already.
pub(super) fn refuse_rate(name: &Ident, declaration: &Declaration, interpreter: &mut Interpreter) {
    let text = plain(name);
    let base = text.strip_suffix("_dot").or_else(|| text.strip_suffix("_ddot"));
    let coordinate = declaration.coordinates.iter().map(|c| plain(&c.name)).find(|c| Some(c.as_str()) == base);
    if let Some(coordinate) = coordinate {
        let message = format!(
            "`{text}` is the name of a rate of `{coordinate}` in files and on the command line; choose another name"
        );
        interpreter.mistakes.add(Region::from(name).error(message));
    }
}

pub(super) fn resolve_parameters(declaration: &Declaration, interpreter: &mut Interpreter) -> Vec<Parameter> {
    let any = MOVING.or(Dependence::TIME).or(Dependence::PARAMETER);
    let rule = "the default of a parameter is a number; what follows from other parameters is a `let`";
    let mut parameters = Vec::new();
    for p in &declaration.parameters {
        let line = (&p.name, &p.unit, &p.value);
        if let Some(Valued { name, unit, symbol, value: default }) =
            resolve_valued(line, Dependence::PARAMETER, (any, rule), declaration, interpreter)
        {
            parameters.push(Parameter { name, docs: p.docs.clone(), unit, symbol, default });
        }
    }
    parameters
}

/// Inputs, each with a course of numbers, parameters and time.
pub(super) fn resolve_inputs(declaration: &Declaration, interpreter: &mut Interpreter) -> Vec<Input> {
    let any = MOVING.or(Dependence::INPUT);
    let rule = "the declared course of an input is made of numbers, parameters and `t`; what depends on the motion is set \
                at run time, or is a load";
    let mut inputs = Vec::new();
    for input in &declaration.inputs {
        let line = (&input.name, &input.unit, &input.value);
        if let Some(Valued { name, unit, symbol, value: course }) =
            resolve_valued(line, Dependence::INPUT, (any, rule), declaration, interpreter)
        {
            inputs.push(Input { name, docs: input.docs.clone(), unit, symbol, course });
        }
    }
    inputs
}

/// A quantity that is declared with a value, as a symbol.
struct Valued {
    name: String,
    unit: Unit,
    symbol: Symbol,
    value: Expr,
}

/// Its value cannot refer to its own name.
fn resolve_valued(
    (name, written, value): (&Ident, &Option<dsl::Unit>, &Expression),
    dependence: Dependence,
    forbidden: (Dependence, &str),
    declaration: &Declaration,
    interpreter: &mut Interpreter,
) -> Option<Valued> {
    let text = plain(name);
    refuse_rate(name, declaration, interpreter);
    let unit = resolve_unit(written, interpreter);
    let symbol = interpreter.graph.symbol(&text);
    interpreter.dependences.declare(symbol, dependence);
    let value = match &unit {
        Some(unit) => in_unit(value, &text, unit, forbidden, interpreter),
        None => interpreter.scalar(value),
    };
    define_symbol(name, symbol, written, unit.as_ref(), interpreter);
    Some(Valued { name: text, unit: unit.unwrap_or_else(Unit::none), symbol, value: value? })
}

pub(super) fn resolve_lets(declaration: &Declaration, interpreter: &mut Interpreter) -> Vec<(String, Expr)> {
    let mut named = Vec::new();
    for (at, definition) in declaration.lets.iter().enumerate() {
        let value = match later_use(&definition.value, &declaration.lets[at..]) {
            Some(mistake) => {
                interpreter.mistakes.add(mistake);
                None
            }
            None => interpreter.value(&definition.value),
        };
        refuse_rate(&definition.name, declaration, interpreter);
        let name = plain(&definition.name);
        match value.as_ref().filter(|_| !definition.is_of_frame).map(|value| &value.shape) {
            Some(Shape::Scalar(scalar)) => named.push((name.clone(), *scalar)),
            Some(Shape::Vector([x, y])) => named.extend([(format!("{name}_x"), *x), (format!("{name}_y"), *y)]),
            Some(Shape::Spatial(vector)) => {
                let components = interpreter.frames.resolved(&mut interpreter.graph, vector);
                named.extend(["x", "y", "z"].iter().zip(components).map(|(axis, x)| (format!("{name}_{axis}"), x)));
            }
            Some(Shape::Rotation(_)) | None => {}
        }
        let origin = Origin::Defined(interpreter.parts(&definition.value));
        interpreter.origins.add(name, origin);
        define(&definition.name, value, interpreter);
    }
    named
}

/// A mistake if an expression uses a `let` that comes later, or itself.
fn later_use(expression: &Expression, later: &[dsl::Let]) -> Option<syn::Error> {
    use dsl::Kind;
    match &expression.kind {
        Kind::Name(name) => {
            let at = later.iter().position(|definition| definition.name == *name)?;
            if later[at].is_of_frame {
                let message = "this frame is declared here or below; a frame stands on others above it";
                return Some(expression.region.error(message));
            }
            let message = match at {
                0 => format!("`{name}` is defined by itself"),
                _ => format!("`{name}` is defined only below; move its line above this one"),
            };
            Some(Region::from(name).error(message))
        }
        _ => expression.parts().into_iter().find_map(|part| later_use(part, later)),
    }
}

/// A coordinate that neither moves a body nor stands in a constraint has no equation of motion.
pub(super) fn check_coordinates_used(
    declaration: &Declaration,
    coordinates: &[Coordinate],
    bodies: &[Option<Body>],
    constraints: &[Constraint],
    interpreter: &mut Interpreter,
) {
    // Another mistake may be the reason why it is not used.
    if !interpreter.mistakes.is_empty() {
        return;
    }
    let mut roots: Vec<Expr> = constraints.iter().map(|c| c.value).collect();
    for body in bodies.iter().flatten() {
        roots.extend(body.mass.iter().flat_map(|(_, at)| at));
        roots.extend(body.rotation.map(|(_, angle)| angle));
        roots.extend(body.attitude.iter().flat_map(|attitude| attitude.matrix.concat()));
    }
    let used = interpreter.graph.symbols_of(&roots);
    for (c, written) in coordinates.iter().zip(&declaration.coordinates) {
        if !used.contains(&c.position) && !used.contains(&c.speed) {
            interpreter.mistakes.add(Region::from(&written.name).error(format!(
                "coordinate `{}` moves no body and stands in no constraint; use it or leave it out",
                c.name
            )));
        }
    }
}
