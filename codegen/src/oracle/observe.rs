//! What is looked at: outputs, events and power.

use super::constraint::Constraint;
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

/// The multipliers of each constraint, as scalar or vector, then the forces conjugate to auxiliary displacements.
pub(super) fn reactions(mechanics: &Mechanics, solution: &Solution) -> Result<Vec<Value>> {
    let mut rest = solution.multipliers.iter().map(|multiplier| Jet::of_time(*multiplier, &[]));
    let mut reaction = |constraint: &Constraint| match constraint.rows.len() {
        1 => rest.next().map(Value::Scalar),
        _ => rest.next().zip(rest.next()).map(|(x, y)| Value::Vector([x, y])),
    };
    let Some(mut reactions) = mechanics.constraints.iter().map(&mut reaction).collect::<Option<Vec<Value>>>() else {
        return refuse("a multiplier is missing in the solution");
    };
    let conjugate = |k: usize| Value::Scalar(Jet::of_time(conjugate_force(mechanics, solution, k), &[]));
    reactions.extend((0..mechanics.auxiliaries).map(conjugate));
    Ok(reactions)
}

/// The force conjugate to auxiliary displacement number k: the sum of x_s.(m x'' - F) + lambda C_s, which is the virtual
/// work that it takes to displace it.
fn conjugate_force(mechanics: &Mechanics, solution: &Solution, k: usize) -> Measured {
    let by_auxiliary = |place: &Jet| place.gradient()[mechanics.coordinates + 1 + k];
    let inertia: Measured = mechanics
        .rows
        .iter()
        .map(|row| by_auxiliary(&row.place) * row.inertia * acceleration(mechanics, &row.place, solution))
        .sum();
    let loads: Measured = mechanics.efforts.iter().map(|effort| effort.force * by_auxiliary(&effort.place)).sum();
    let constraints = mechanics.constraint_rows();
    let reactions: Measured =
        constraints.iter().zip(&solution.multipliers).map(|(row, lambda)| *lambda * row.by_auxiliary[k]).sum();
    inertia - loads + reactions
}

/// x'' = T_q q'' + g.
fn acceleration(mechanics: &Mechanics, place: &Jet, solution: &Solution) -> Measured {
    inner(&place.gradient()[..mechanics.coordinates], &solution.accelerations) + place.curvature(&mechanics.rates)
}

/// The sum of F.(P_q q') + lambda C_t + T_t.(m x''), where x'' = T_q q'' + g: the rate of the kinetic energy as long
/// as C_q q' + C_t = 0.
///
/// This is F.v + lambda C_t + T_t.(m x'' - F): a force does no work through a point that time moves by itself.
pub(super) fn power(mechanics: &Mechanics, solution: &Solution) -> Measured {
    let n = mechanics.coordinates;
    let speeds = &mechanics.rates[..n];
    let loads: Measured =
        mechanics.efforts.iter().map(|effort| effort.force * inner(&effort.place.gradient()[..n], speeds)).sum();
    let constraints = mechanics.constraint_rows();
    let driven: Measured =
        constraints.iter().zip(&solution.multipliers).map(|(row, lambda)| *lambda * row.time_derivative).sum();
    let moved = mechanics
        .rows
        .iter()
        .map(|row| row.place.gradient()[n] * row.inertia * acceleration(mechanics, &row.place, solution));
    loads + driven + moved.sum()
}
