//! Observed quantities: outputs, events and power.

use super::constraint::Constraint;
use super::error::{OracleError, Result, refuse};
use super::interpret::Interpreter;
use super::jet::Jet;
use super::measured::{Measured, inner};
use super::mechanics::Mechanics;
use super::motion::Solution;
use super::plain::is_plain;
use super::value::Value;
use crate::dsl::{Action, Declaration, Event, Unit};

/// Every output, group after group.
pub(super) fn outputs(declaration: &Declaration, mut along: Interpreter) -> Result<Vec<Measured>> {
    let outputs = declaration.outputs.iter().flat_map(|group| &group.outputs);
    outputs.map(|output| Ok(along.scalar(&output.value)?.value())).collect()
}

/// left - right of every event.
pub(super) fn events(declaration: &Declaration, mut along: Interpreter) -> Result<Vec<Measured>> {
    let event = |event: &Event| Ok(along.difference(&event.condition)?.scalar()?.value());
    declaration.events.iter().map(event).collect()
}

/// The values that the actions of every event set, and the coefficients of restitution of its impacts.
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

/// The multipliers of each constraint, as scalar or vector, then the forces conjugate to auxiliary displacements.
pub(super) fn reactions(mechanics: &Mechanics, solution: &Solution) -> Result<Vec<Value>> {
    let mut rest = solution.multipliers.iter().map(|multiplier| Jet::of_time(*multiplier, &[]));
    let mut reaction = |constraint: &Constraint| match constraint.rows.len() {
        1 => rest.next().map(Value::Scalar),
        components => (0..components).map(|_| rest.next()).collect::<Option<_>>().map(Value::Vector),
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
        .map(|row| by_auxiliary(&row.place) * row.inertia * acceleration(mechanics, &row.partner, solution))
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
        .map(|row| row.place.gradient()[n] * row.inertia * acceleration(mechanics, &row.partner, solution));
    loads + driven + moved.sum()
}
