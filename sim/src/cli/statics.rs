//! `sim assemble` and `sim equilibrium`.

use super::arguments::{StartArguments, Voice};
use super::list::counted;
use super::run::{mechanism_with, start_with};
use super::{Stop, print};
use crate::{assemble, check_masses, equilibrium, mobility, residuals};
use serde_json::{Map, Value, json};
use sim_kernel::{Array, Mechanism, Quantity};
use std::io::Write;

/// Prints the assembled start, degrees of freedom and redundant constraints.
pub(super) fn assemble_command<M: Mechanism>(arguments: &StartArguments, voice: Voice) -> Result<(), Stop> {
    let description = const { &M::DESCRIPTION };
    let mechanism = mechanism_with::<M>(description, &arguments.set)?;
    let state = assemble(&mechanism, &start_with(&mechanism, description, &arguments.initial)?)?;
    check_masses(&mechanism, state.time, &state.positions)?;
    let found = mobility(&mechanism, state.time, &state.positions);
    let (position, velocity) = residuals(&mechanism, &state);
    if voice.quiet {
        return Ok(());
    }
    if voice.json {
        let coordinates = named(description.coordinates.iter().map(|c| &c.position), &state.positions);
        let speeds = named(description.coordinates.iter().map(|c| &c.speed), &state.speeds);
        let said = json!({
            "model": description.name,
            "degrees_of_freedom": found.degrees_of_freedom,
            "configuration_freedom": found.configuration_freedom,
            "redundant_constraints": found.dependent,
            "coordinates": coordinates,
            "speeds": speeds,
            "residuals": { "position": position, "velocity": velocity },
        });
        return print(&format!("{said:#}\n"));
    }
    let mut out = std::io::stdout().lock();
    let freedom = super::info::freedom(&found);
    let coordinates = counted(M::Q::LEN, "coordinate");
    writeln!(out, "{}: {coordinates}, {}, {freedom}", description.name, counted(M::L::LEN, "constraint"))?;
    for line in found.redundancies() {
        writeln!(out, "redundant    {line}")?;
    }
    for (c, (q, qd)) in description.coordinates.iter().zip(state.positions.iter().zip(state.speeds.iter())) {
        let (position, speed) = (q / c.position.factor, qd / c.speed.factor);
        writeln!(
            out,
            "{:<12} {position:>20.15} {:<10} {speed:>20.15} {}",
            c.position.name, c.position.unit, c.speed.unit
        )?;
    }
    Ok(writeln!(out, "constraints  open by at most {position:.1e} (positions), {velocity:.1e} (velocities)")?)
}

/// Prints an equilibrium, its reactions and the eigenvalues of small motions.
pub(super) fn equilibrium_command<M: Mechanism>(arguments: &StartArguments, voice: Voice) -> Result<(), Stop> {
    let description = const { &M::DESCRIPTION };
    let mechanism = mechanism_with::<M>(description, &arguments.set)?;
    let found = equilibrium(&mechanism, &start_with(&mechanism, description, &arguments.initial)?)?;
    if voice.quiet {
        return Ok(());
    }
    if voice.json {
        let eigenvalues = found.eigenvalues.iter().map(|value| json!([value.re, value.im]));
        let said = json!({
            "model": description.name,
            "coordinates": named(description.coordinates.iter().map(|c| &c.position), &found.state.positions),
            "multipliers": named(description.constraints.iter(), &found.multipliers),
            "eigenvalues": eigenvalues.collect::<Vec<_>>(),
        });
        return print(&format!("{said:#}\n"));
    }
    let mut out = std::io::stdout().lock();
    for (c, q) in description.coordinates.iter().zip(found.state.positions.iter()) {
        writeln!(out, "{:<20} {:>20.12} {}", c.position.name, q / c.position.factor, c.position.unit)?;
    }
    for (c, lambda) in description.constraints.iter().zip(found.multipliers.iter()) {
        writeln!(out, "{:<20} {:>20.12} {}", format!("lambda_{}", c.name), lambda / c.factor, c.unit)?;
    }
    for value in found.eigenvalues {
        writeln!(out, "{:<20} {:>20.12} {:+.12} i 1/s", "eigenvalue", value.re, value.im)?;
    }
    Ok(())
}

/// Values by name, in their units.
fn named<'a, A: Array<f64>>(quantities: impl Iterator<Item = &'a Quantity>, values: &A) -> Map<String, Value> {
    let entry =
        |(q, value): (&Quantity, &f64)| (q.name.to_owned(), json!({ "value": value / q.factor, "unit": q.unit }));
    quantities.zip(values.iter()).map(entry).collect()
}
