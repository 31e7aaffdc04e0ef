//! The `constraints` block.

use super::interpreter::Interpreter;
use super::level::{BEYOND_POSITION, no_input};
use super::rates::linear_in_speeds;
use super::scope::{Names, plain};
use super::space::Spatial;
use super::unmoved::without_coordinates;
use super::value::{Shape, Value};
use super::{Conditional, Constraint, Dependence, Dimension, Level, Unit};
use crate::dsl::{self, Declaration, Region};
use crate::symbolic::{Expr, Graph};

/// `conjugate` are the forces conjugate to auxiliary displacements, which are reactions too.
pub(super) fn resolve_constraints(
    declaration: &Declaration,
    conjugate: &[Value],
    interpreter: &mut Interpreter,
) -> (Vec<Constraint>, Vec<Conditional>) {
    let (mut rows, mut conditionals) = (Vec::new(), Vec::new());
    let mut reactions =
        Names::new(if conjugate.is_empty() { "constraint" } else { "constraint or auxiliary displacement" });
    for equation in &declaration.constraints {
        let first = rows.len();
        let sides = equation_sides(equation, interpreter);
        let is_known = sides.as_ref().is_some_and(|sides| sides.dimension.is_some());
        if let Some(sides) = sides {
            let level = if declaration.has_rates(equation) { Level::Speeds } else { Level::Positions };
            constraint_rows(equation, level, sides, &mut rows, interpreter);
        }
        if let Some(initially) = equation.initially {
            conditionals.push(conditional(equation, initially, &mut rows[first..], first, declaration, interpreter));
        }
        let multipliers: Vec<Expr> =
            rows[first..].iter().map(|row: &Constraint| interpreter.graph.variable(row.multiplier)).collect();
        let dimension = rows.get(first).map(|row| row.unit.dimension().clone()).filter(|_| is_known);
        let reaction = match multipliers.as_slice() {
            [one] => Some(Value::scalar(*one, dimension)),
            [x, y] => Some(Value::new(Shape::Vector([*x, *y]), dimension)),
            [x, y, z] => Some(Value::new(Shape::Spatial(Spatial::world([*x, *y, *z])), dimension)),
            _ => None,
        };
        reactions.define(&equation.name, reaction, &mut interpreter.mistakes);
    }
    for (k, (auxiliary, force)) in declaration.auxiliary.iter().zip(conjugate).enumerate() {
        // Duplicate names have been reported already.
        if declaration.auxiliary[..k].iter().any(|other| other.name == auxiliary.name) {
            continue;
        }
        reactions.define(&auxiliary.name, Some(force.clone()), &mut interpreter.mistakes);
    }
    interpreter.reactions = Some(reactions);
    (rows, conditionals)
}

/// Gives the rows of a constraint an activity, a number that events change.
fn conditional(
    equation: &dsl::Equation,
    initially: dsl::Activity,
    rows: &mut [Constraint],
    first: usize,
    declaration: &Declaration,
    interpreter: &mut Interpreter,
) -> Conditional {
    let name = plain(&equation.name);
    let field = format!("{name}_activity");
    if let Some(parameter) = declaration.parameters.iter().find(|p| plain(&p.name) == field) {
        let message =
            format!("`{field}` is the field that says whether constraint `{name}` holds; choose another name");
        interpreter.mistakes.add(Region::from(&parameter.name).error(message));
    }
    let symbol = interpreter.graph.symbol(&field);
    interpreter.dependences.declare(symbol, Dependence::PARAMETER);
    let activity = interpreter.graph.variable(symbol);
    rows.iter_mut().for_each(|row| row.activity = Some(activity));
    let rows = first..first + rows.len();
    Conditional { name, field, symbol, rows, initially_active: initially == dsl::Activity::Active }
}

/// left - right, both scalars or both vectors.
pub(super) fn equation_sides(equation: &dsl::Equation, interpreter: &mut Interpreter) -> Option<Value> {
    let (left, right) = (interpreter.value(&equation.left), interpreter.value(&equation.right));
    let (left, right) = (left?, right?);
    let shape = match (&left.shape, &right.shape) {
        (Shape::Scalar(l), Shape::Scalar(r)) => Shape::Scalar(interpreter.graph.sub(*l, *r)),
        (Shape::Vector([lx, ly]), Shape::Vector([rx, ry])) => {
            Shape::Vector([interpreter.graph.sub(*lx, *rx), interpreter.graph.sub(*ly, *ry)])
        }
        (Shape::Spatial(l), Shape::Spatial(r)) => Shape::Spatial(l.combine(r, &mut interpreter.graph, Graph::sub)),
        (Shape::Rotation(_), Shape::Rotation(_)) => {
            let message = "rotations cannot be equated; write three equations between their axes, such as \
                           `inner(R*[1, 0, 0], S*[0, 1, 0]) = 0`, or by a joint";
            return interpreter.refuse(equation.left.region.to(equation.right.region), message);
        }
        _ => {
            let message = format!(
                "the left side is {} and the right side {}; both must be of one kind",
                left.kind(),
                right.kind()
            );
            return interpreter.refuse(equation.left.region.to(equation.right.region), message);
        }
    };
    let rule = "both sides of an equation are of one dimension";
    let dimension =
        interpreter.common_dimension(left.measured(&equation.left), right.measured(&equation.right), rule)?;
    interpreter.common_basis([(equation.left.region, &left), (equation.right.region, &right)])?;
    Some(Value::new(shape, dimension))
}

fn constraint_rows(
    equation: &dsl::Equation,
    level: Level,
    value: Value,
    rows: &mut Vec<Constraint>,
    interpreter: &mut Interpreter,
) -> Option<()> {
    let place = equation.left.region.to(equation.right.region);
    let name = plain(&equation.name);
    let components = interpreter.components(&value);
    no_input(place, &components, "a constraint", interpreter)?;
    match level {
        Level::Positions => {
            interpreter.restrict(
                place,
                &components,
                BEYOND_POSITION,
                "a constraint holds between positions or speeds",
            )?;
        }
        Level::Speeds => linear_in_speeds(place, &components, interpreter)?,
    }
    interpreter.smooth(place, &components, level, "a constraint")?;
    let work = match level {
        Level::Positions => Dimension::energy(),
        Level::Speeds => Dimension::energy().over(&Dimension::time()),
    };
    let unit = match &value.dimension {
        Some(dimension) => Unit::coherent(work.over(dimension)),
        None => Unit::none(),
    };
    let components: Vec<Expr> = components
        .into_iter()
        .map(|row| match equation.is_of_joint && level == Level::Positions {
            true => without_coordinates(&mut interpreter.graph, &mut interpreter.dependences, row).unwrap_or(row),
            false => row,
        })
        .collect();
    let suffixes: &[&str] = if components.len() == 1 { &[""] } else { &["_x", "_y", "_z"] };
    let named: Vec<_> = components.into_iter().zip(suffixes.iter().map(|suffix| format!("{name}{suffix}"))).collect();
    for (value, row) in &named {
        check_row(equation, level, *value, row, rows, interpreter)?;
    }
    for (value, name) in named {
        let multiplier = interpreter.graph.symbol(&format!("lambda_{name}"));
        interpreter.dependences.declare(multiplier, Dependence::MULTIPLIER);
        rows.push(Constraint { name, level, value, multiplier, unit: unit.clone(), activity: None });
    }
    Some(())
}

/// Refuses a row that nothing moves, and one whose name is taken.
fn check_row(
    equation: &dsl::Equation,
    level: Level,
    value: Expr,
    row: &str,
    rows: &[Constraint],
    interpreter: &mut Interpreter,
) -> Option<()> {
    let constrained = match level {
        Level::Positions => Dependence::COORDINATE,
        Level::Speeds => Dependence::SPEED,
    };
    // A joint whose row nothing moves is sound where it closes: the row is redundant.
    if !equation.is_of_joint && !interpreter.dependences.of(&interpreter.graph, value).meets(constrained) {
        if level == Level::Speeds {
            let message = format!(
                "no speed is left in constraint row `{row}`, though `dot()` is written; write it between positions, \
                 without `dot()`"
            );
            return interpreter.refuse(Region::from(&equation.name), message);
        }
        let message = format!(
            "no coordinate moves constraint `{row}`: it holds always or never; leave it out, or make it depend on a coordinate"
        );
        return interpreter.refuse(Region::from(&equation.name), message);
    }
    if rows.iter().any(|other| other.name == row) {
        let message = format!("two constraint rows would be called `{row}`; choose another name for one of them");
        return interpreter.refuse(Region::from(&equation.name), message);
    }
    Some(())
}
