//! What is looked at: outputs, events and power.

use super::error::{Result, refuse};
use super::interpret::Interpreter;
use super::jet::Jet;
use super::measured::{Measured, inner};
use super::mechanics::{Mechanics, difference};
use super::motion::Solution;
use super::value::Value;
use crate::dsl::Declaration;

/// Every output, group after group.
pub(super) fn outputs(declaration: &Declaration, mut along: Interpreter) -> Result<Vec<Measured>> {
    let outputs = declaration.outputs.iter().flat_map(|group| &group.outputs);
    outputs.map(|output| Ok(along.scalar(&output.value)?.value())).collect()
}

/// left - right of every event.
pub(super) fn events(declaration: &Declaration, mut along: Interpreter) -> Result<Vec<Measured>> {
    let event = |event| Ok(difference(&mut along, event)?.scalar()?.value());
    declaration.events.iter().map(event).collect()
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
pub(super) fn power(mechanics: &Mechanics, rates: &[Measured], solution: &Solution) -> Measured {
    let n = rates.len() - 1;
    let speeds = &rates[..n];
    let loads: Measured =
        mechanics.efforts.iter().map(|effort| effort.force * inner(&effort.place.gradient()[..n], speeds)).sum();
    let constraints = mechanics.constraint_rows();
    let driven: Measured =
        constraints.iter().zip(&solution.multipliers).map(|(row, lambda)| *lambda * row.gradient()[n]).sum();
    let moved = mechanics.rows.iter().map(|row| {
        let acceleration = inner(&row.place.gradient()[..n], &solution.accelerations) + row.place.curvature(rates);
        row.place.gradient()[n] * row.inertia * acceleration
    });
    loads + driven + moved.sum()
}
