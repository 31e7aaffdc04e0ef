//! `sim assemble` and `sim equilibrium`.

use crate::Stop;
use crate::arguments::{AssembleArguments, StartArguments, Voice};
use crate::commands::steady::CORNER;
use crate::events::{idle_events, only_in_runs};
use crate::given::as_given;
use crate::numbers::{beside, in_units};
use crate::said::Said;
use crate::said::counted;
use nalgebra::Complex;
use serde_json::{Map, Value, json};
use sim_kernel::{Description, Mechanism, Quantity};
use sim_output::list;
use sim_runtime::{Branches, Loop, Mobility, assemble, branches, check_bodies, equilibrium, mobility, residuals};
use std::fmt::Write;

/// Prints the assembled start, degrees of freedom and redundant constraints.
pub(crate) fn assemble_command<M: Mechanism>(
    mechanism: M,
    arguments: &AssembleArguments,
    voice: Voice,
) -> Result<(), Stop> {
    assembled(mechanism, arguments)?.tell(voice)
}

/// The assembled start, or all configurations.
pub(crate) fn assembled<M: Mechanism>(mechanism: M, arguments: &AssembleArguments) -> Result<Said, Stop> {
    let description = mechanism.description();
    let (mechanism, start) = as_given(&mechanism, &arguments.start.set, &arguments.start.initial)?;
    if arguments.branches {
        let Branches { loops, open, positions } = branches(&mechanism, &start);
        return of_branches(description, &loops, &open, &positions.iter().map(list).collect::<Vec<_>>());
    }
    let state = assemble(&mechanism, &start)?;
    check_bodies(&mechanism, state.time, &state.positions)?;
    let found = mobility(&mechanism, state.time, &state.positions);
    let numbers = (state.positions.as_ref(), state.speeds.as_ref());
    of_start(description, &found, numbers, residuals(&mechanism, &state))
}

fn of_start(
    description: &Description,
    found: &Mobility,
    (positions, speeds): (&[f64], &[f64]),
    (position, velocity): (f64, f64),
) -> Result<Said, Stop> {
    let json = json!({
        "model": description.name,
        "degrees_of_freedom": found.degrees_of_freedom,
        "configuration_freedom": found.configuration_freedom,
        "redundant_constraints": found.dependent,
        "singular_constraints": found.singular,
        "coordinates": named(description.coordinates.iter().map(|c| &c.position), positions),
        "speeds": named(description.coordinates.iter().map(|c| &c.speed), speeds),
        "residuals": { "position": position, "velocity": velocity },
    });
    let mut out = String::new();
    let freedom = crate::commands::info::freedom(found);
    let coordinates = counted(positions.len(), "coordinate");
    writeln!(
        out,
        "{}: {coordinates}, {}, {freedom}",
        description.name,
        counted(description.constraints.len(), "constraint")
    )?;
    for line in found.redundancies() {
        writeln!(out, "redundant    {line}")?;
    }
    for line in found.singularities() {
        writeln!(out, "singular     {line}")?;
    }
    let positions = in_units(description.coordinates.iter().map(|c| &c.position), positions, 15);
    let speeds = in_units(description.coordinates.iter().map(|c| &c.speed), speeds, 15);
    for (c, (position, speed)) in description.coordinates.iter().zip(positions.iter().zip(&speeds)) {
        writeln!(out, "{:<12} {position:>20} {:<10} {speed:>20} {}", c.position.name, c.position.unit, c.speed.unit)?;
    }
    writeln!(out, "constraints  open by at most {position:.1e} (positions), {velocity:.1e} (velocities)")?;
    Ok(Said { json, text: out })
}

/// How the loops close, and the configurations.
fn of_branches(description: &Description, loops: &[Loop], open: &[&str], branches: &[Vec<f64>]) -> Result<Said, Stop> {
    let positions = || description.coordinates.iter().map(|c| &c.position);
    let coordinates = |q: &Vec<f64>| named(positions(), q);
    let of =
        |l: &Loop| json!({ "form": l.form.to_string(), "constraints": l.constraints, "coordinates": l.coordinates });
    let json = json!({
        "model": description.name,
        "loops": loops.iter().map(of).collect::<Vec<_>>(),
        "not_in_closed_form": open,
        "branches": branches.iter().map(coordinates).collect::<Vec<_>>(),
    });
    let mut out = String::new();
    for Loop { constraints, coordinates, form } in loops {
        let (constraints, coordinates) = (constraints.join(", "), coordinates.join(", "));
        writeln!(out, "loop         {constraints} closes {coordinates}: {form}")?;
    }
    for name in open {
        writeln!(out, "loop         {name} is not found in closed form; its guess decides")?;
    }
    if branches.is_empty() {
        let why = match open.is_empty() {
            true => "none: the links do not reach each other",
            false => "none was found from these guesses",
        };
        writeln!(out, "branches     {why}")?;
    }
    for (k, q) in branches.iter().enumerate() {
        let numbers = in_units(positions(), q, 12);
        let values = positions().zip(numbers).map(|(c, q)| format!("{} = {q} {}", c.name, c.unit));
        writeln!(out, "branch {:<5} {}", k + 1, values.collect::<Vec<_>>().join(", "))?;
    }
    Ok(Said { json, text: out })
}

/// Prints an equilibrium, its reactions and the eigenvalues of small motions.
pub(crate) fn equilibrium_command<M: Mechanism>(
    mechanism: M,
    arguments: &StartArguments,
    voice: Voice,
) -> Result<(), Stop> {
    balanced(mechanism, arguments)?.tell(voice)
}

/// The equilibrium near the start.
pub(crate) fn balanced<M: Mechanism>(mechanism: M, arguments: &StartArguments) -> Result<Said, Stop> {
    let description = mechanism.description();
    let (mechanism, start) = as_given(&mechanism, &arguments.set, &arguments.initial)?;
    let found = equilibrium(&mechanism, &start)?;
    let redundant = mobility(&mechanism, found.state.time, &found.state.positions);
    let numbers = (found.state.positions.as_ref(), found.multipliers.as_ref());
    of_equilibrium(description, &redundant, numbers, (&found.eigenvalues, found.is_steady, found.has_corner))
}

fn of_equilibrium(
    description: &Description,
    mobility: &Mobility,
    (positions, multipliers): (&[f64], &[f64]),
    (eigenvalues, is_steady, has_corner): (&[Complex<f64>], bool, bool),
) -> Result<Said, Stop> {
    let values = eigenvalues.iter().map(|value| json!([value.re, value.im]));
    let of_one_time = (!is_steady).then_some("what acts changes with time: this holds at t = 0 alone");
    let warnings: Vec<&str> = of_one_time.into_iter().chain(has_corner.then_some(CORNER)).collect();
    let json = json!({
        "model": description.name,
        "coordinates": named(description.coordinates.iter().map(|c| &c.position), positions),
        "multipliers": named(description.constraints.iter(), multipliers),
        "redundant_constraints": mobility.dependent,
        "eigenvalues": values.collect::<Vec<_>>(),
        "steady": is_steady,
        "corner": has_corner,
        "events_without_effect": idle_events(description),
        "warnings": warnings,
    });
    let mut out = String::new();
    let coordinates = description.coordinates.iter().map(|c| &c.position);
    for (c, q) in coordinates.clone().zip(in_units(coordinates, positions, 12)) {
        writeln!(out, "{:<20} {q:>20} {}", c.name, c.unit)?;
    }
    for line in mobility.redundancies() {
        writeln!(out, "{:<20} {line}", "redundant")?;
    }
    let constraints = description.constraints.iter();
    for (c, lambda) in constraints.clone().zip(in_units(constraints, multipliers, 12)) {
        writeln!(out, "{:<20} {lambda:>20} {}", format!("lambda_{}", c.name), c.unit)?;
    }
    let largest = eigenvalues.iter().fold(0.0f64, |largest, value| largest.max(value.norm()));
    for value in eigenvalues {
        let part = |part: f64| beside(part, largest, 12);
        let sign = if value.im < 0.0 { "" } else { "+" };
        writeln!(out, "{:<20} {:>20} {sign}{} i 1/s", "eigenvalue", part(value.re), part(value.im))?;
    }
    for warning in warnings {
        writeln!(out, "{:<20} {warning}", "warning")?;
    }
    if let Some(line) = only_in_runs(description) {
        writeln!(out, "{:<20} {line}", "events")?;
    }
    Ok(Said { json, text: out })
}

/// Values by name, in their units.
fn named<'a>(quantities: impl Iterator<Item = &'a Quantity>, values: &[f64]) -> Map<String, Value> {
    let entry =
        |(q, value): (&Quantity, &f64)| (q.name.to_owned(), json!({ "value": value / q.factor, "unit": q.unit }));
    quantities.zip(values.iter()).map(entry).collect()
}
