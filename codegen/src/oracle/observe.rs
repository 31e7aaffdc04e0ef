//! What is looked at: outputs, events and power.

use super::error::{OracleError, Result, refuse};
use super::interpret::Interpreter;
use super::jet::Jet;
use super::measured::{Measured, inner};
use super::mechanics::{Mechanics, difference};
use super::motion::Solution;
use super::parameters::is_plain;
use super::value::Value;
use crate::dsl::{Action, Declaration, Event, Unit};

/// Every output, group after group.
pub(super) fn outputs(declaration: &Declaration, mut along: Interpreter) -> Result<Vec<Measured>> {
    let outputs = declaration.outputs.iter().flat_map(|group| &group.outputs);
    outputs.map(|output| Ok(along.scalar(&output.value)?.value())).collect()
}

/// left - right of every event.
pub(super) fn events(declaration: &Declaration, mut along: Interpreter) -> Result<Vec<Measured>> {
    let event = |event: &Event| Ok(difference(&mut along, &event.condition)?.scalar()?.value());
    declaration.events.iter().map(event).collect()
}

/// What the actions of every event set, and the coefficients of restitution of its impacts.
pub(super) fn event_values(
    declaration: &Declaration,
    si_factor: &dyn Fn(&Unit) -> f64,
    mut along: Interpreter,
) -> Result<Vec<Measured>> {
    let mut values = Vec::new();
    for action in declaration.events.iter().flat_map(|event| &event.actions) {
        match action {
            Action::Set { name, value, .. } => {
                let units = declaration.coordinates.iter().map(|c| (&c.name, &c.unit));
                let mut units = units.chain(declaration.parameters.iter().map(|p| (&p.name, &p.unit)));
                let unit = units.find(|(other, _)| *other == name).and_then(|(_, unit)| unit.as_ref());
                let factor = unit.filter(|_| is_plain(value)).map_or(1.0, si_factor);
                values.push(along.scalar(value)?.value() * Measured::given(factor));
            }
            Action::Swap(first, second) => {
                for name in [second, first] {
                    let coordinate = along.coordinate_named(name)?;
                    let speed = coordinate.dot().map(|speed| speed.value());
                    values.push(coordinate.value());
                    values.push(speed.ok_or_else(|| OracleError::new("a speed that is not known here"))?);
                }
            }
            Action::Impact { restitution, .. } => values.push(match restitution {
                Some(coefficient) => along.scalar(coefficient)?.value(),
                None => Measured::ZERO,
            }),
            Action::Record | Action::Stop { .. } | Action::Switch { .. } => {}
        }
    }
    Ok(values)
}

/// The multipliers of each constraint, as scalar or vector.
pub(super) fn reactions(constraints: &[Value], multipliers: &[Measured]) -> Result<Vec<Value>> {
    let mut rest = multipliers.iter().map(|multiplier| Jet::of_time(*multiplier, &[]));
    let mut reaction = |constraint: &Value| match constraint {
        Value::Scalar(_) => rest.next().map(Value::Scalar),
        Value::Vector(_) => rest.next().zip(rest.next()).map(|(x, y)| Value::Vector([x, y])),
    };
    match constraints.iter().map(&mut reaction).collect() {
        Some(reactions) => Ok(reactions),
        None => refuse("a multiplier is missing in the solution"),
    }
}

/// The sum of F.(P_q q') + lambda C_t + T_t.(m x''), where x'' = T_q q'' + g: the rate of the kinetic energy as long
/// as C_q q' + C_t = 0.
///
/// This is F.v + lambda C_t + T_t.(m x'' - F): a force does no work through a point that time moves by itself.
pub(super) fn power(mechanics: &Mechanics, rates: &[Measured], solution: &Solution, active: &[bool]) -> Measured {
    let n = rates.len() - 1;
    let speeds = &rates[..n];
    let loads: Measured =
        mechanics.efforts.iter().map(|effort| effort.force * inner(&effort.place.gradient()[..n], speeds)).sum();
    let constraints = mechanics.constraint_rows();
    let driven = constraints.iter().zip(&solution.multipliers).zip(active).filter(|(_, active)| **active);
    let driven: Measured = driven.map(|((row, lambda), _)| *lambda * row.gradient()[n]).sum();
    let moved = mechanics.rows.iter().map(|row| {
        let acceleration = inner(&row.place.gradient()[..n], &solution.accelerations) + row.place.curvature(rates);
        row.place.gradient()[n] * row.inertia * acceleration
    });
    loads + driven + moved.sum()
}
