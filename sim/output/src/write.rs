//! A run as files.

use crate::happening::{crossing, does, impulses};
use crate::outcome::{Happening, Outcome, Recorded, Row, Until};
use crate::whole::{whole, whole_bytes};
use serde_json::{Map, Value, json};
use sim_kernel::{Description, Mechanism, Quantity};
use sim_runtime::{Apart, Run, Stepping, SuddenChanges, Table};
use std::io::Write;
use std::path::{Path, PathBuf};

/// A file that could not be written.
#[derive(Debug, thiserror::Error)]
#[error("cannot write {path}: {reason}")]
pub struct WriteError {
    /// Its place.
    pub path: PathBuf,
    /// Why not.
    pub reason: String,
}

impl WriteError {
    /// Why a file could not be written.
    pub fn new(path: &Path, reason: impl std::fmt::Display) -> WriteError {
        WriteError { path: path.into(), reason: reason.to_string() }
    }
}

/// Writes a table as CSV: header cells `name [unit]`, numbers that read back as the same `f64`. Where it comes from is not in
/// it, as readers would have to be told what to skip: see [`write_commented_csv`].
///
/// # Errors
/// If the file cannot be written.
pub fn write_csv(table: &Table, path: &Path) -> Result<(), WriteError> {
    csv_below(&[], table, path)
}

/// The same, with lines on top that begin with `#` and say where it comes from.
///
/// # Errors
/// If the file cannot be written.
pub fn write_commented_csv(table: &Table, path: &Path) -> Result<(), WriteError> {
    csv_below(&table.provenance.lines(), table, path)
}

fn csv_below(comments: &[String], table: &Table, path: &Path) -> Result<(), WriteError> {
    let written = whole::<csv::Error>(path, |file| {
        let comments: String = comments.iter().map(|line| format!("# {line}\n")).collect();
        file.write_all(comments.as_bytes())?;
        let mut writer = csv::Writer::from_writer(file);
        writer.write_record(table.columns.iter().map(|column| column.header()))?;
        for row in 0..table.times().len() {
            writer.write_record(table.columns.iter().map(|column| format!("{:?}", column.values[row])))?;
        }
        Ok(writer.flush()?)
    });
    written.map_err(|why| WriteError::new(path, why))
}

/// Writes a JSON value, indented.
///
/// # Errors
/// If the file cannot be written.
pub fn write_json(value: &Value, path: &Path) -> Result<(), WriteError> {
    let fail = |e: &dyn std::fmt::Display| WriteError::new(path, e);
    let mut text = serde_json::to_string_pretty(value).map_err(|e| fail(&e))?;
    text.push('\n');
    whole_bytes(path, text.as_bytes()).map_err(|e| fail(&e))
}

/// The settings and results of a run, the same bytes for every repetition.
pub fn summary<M: Mechanism>(run: &Run<M>, table: &Table) -> Value {
    summary_of(&run.outcome(), table)
}

/// The same of a run whose mechanism has no type.
pub fn summary_of(run: &Outcome, table: &Table) -> Value {
    let Outcome { description, parameters, .. } = run;
    let parameters = description.parameters.iter().zip(parameters.iter()).map(|(p, value)| {
        let value = json!({ "value": value / p.factor, "unit": p.unit });
        (p.name.to_owned(), value)
    });
    let events: Vec<Value> = run.events.iter().map(|event| event_object(event, description)).collect();
    let singularities: Vec<Value> = run
        .steps
        .singularities
        .iter()
        .map(|passed| json!({ "constraint": passed.constraint, "time": passed.time, "sine": passed.sine }))
        .collect();
    let counted = |all: SuddenChanges| json!({ "steps": all.steps, "first": all.first });
    let later = run.redundant_later.iter().map(|(time, found)| json!({ "from": time, "constraints": found.dependent }));
    let is_undetermined = !run.mobility.dependent.is_empty() || !run.redundant_later.is_empty();
    let dead_points: Vec<Value> = run.dead_points.iter().map(|(of, time)| json!({ "of": of, "time": time })).collect();
    let undefined =
        table.undefined_outputs().into_iter().map(|(name, time)| (name.to_owned(), json!({ "from": time })));
    json!({
        "model": description.name,
        "parameters": parameters.collect::<Map<String, Value>>(),
        "initial": run.start.as_ref().map(|start| state_object(description, start)),
        "method": method_object(run),
        "end": { "asked": run.settings.end, "reached": run.reached, "samples": run.samples },
        "until": until(run),
        "failure": run.failure.as_ref().map(ToString::to_string),
        "failure_code": run.failure.as_ref().map(|failure| failure.what.code()),
        "degrees_of_freedom": run.mobility.degrees_of_freedom,
        "configuration_freedom": run.mobility.configuration_freedom,
        "redundant_constraints": run.mobility.dependent,
        "redundant_constraints_later": later.collect::<Vec<Value>>(),
        "undetermined_reactions": is_undetermined.then_some("least norm in SI units"),
        "singularities": singularities,
        "sudden_changes_within_equal_steps": run.steps.sudden_changes.map(counted),
        "compared_with_rtol": run.compared,
        "off_from_tolerance": run.apart.map(|apart| off(description, apart)),
        "corners": run.steps.corners.map(counted),
        "undefined_outputs": undefined.collect::<Map<String, Value>>(),
        "period": run.period,
        "events": events,
        "dead_points": dead_points,
        "residuals": { "position": run.position_residual, "velocity": run.velocity_residual },
        "energy_balance": run.energy_balance,
        "energy_balance_of_changes": run.energy_balance_of_changes,
        "energy_taken_by_events": run.energy_taken,
        "warnings": run.warnings(),
        "provenance": table.provenance.to_json(),
    })
}

/// The event that was to end the run, and how often it has happened.
fn until(run: &Outcome) -> Option<Value> {
    let Until { event, asked, happened } = run.until()?;
    Some(json!({ "event": event, "asked": asked, "happened": happened }))
}

/// An occurrence of an event, with its effects.
fn event_object(event: &Happening, description: &Description) -> Value {
    let mut object = json!({ "name": event.name, "time": event.time, "crossing": crossing(event.crossing) });
    if let (Some(change), Some(object)) = (&event.change, object.as_object_mut()) {
        let impulses = impulses(event, description).into_iter();
        let impulses = impulses.map(|(name, value, unit)| (name.to_owned(), json!({ "value": value, "unit": unit })));
        object.insert("does".into(), does(&description.events[event.event], description).into());
        object.insert("impulses".into(), impulses.collect::<Map<String, Value>>().into());
        object.insert("energy_taken".into(), change.energy_taken.into());
    }
    object
}

/// Where a run is off beside one with a smaller tolerance, in the units of the declaration.
fn off(description: &Description, apart: Apart) -> Value {
    let Apart { tolerance, coordinate, by, extent, time, since } = apart;
    let Quantity { name, unit, factor, .. } = &description.coordinates[coordinate].position;
    json!({
        "coordinate": name,
        "by": by / factor,
        "extent": extent / factor,
        "unit": unit,
        "time": time,
        "since": since,
        "tolerance": tolerance,
    })
}

/// The request, and its cost.
fn method_object(run: &Outcome) -> Value {
    let settings = &run.settings;
    let steps = match settings.stepping {
        Stepping::Equal(steps) => json!({ "equal": steps, "step": settings.end / steps.max(1) as f64 }),
        Stepping::Adaptive(tolerance) => json!({ "rtol": tolerance.relative, "atol": tolerance.absolute }),
    };
    json!({
        "name": settings.method.name(),
        "order": settings.method.order(),
        "stepping": steps,
        "stabilisation": settings.stabilisation.to_string(),
        "accepted_steps": run.steps.accepted,
        "rejected_steps": run.steps.rejected,
        "right_hand_sides": run.evaluations,
    })
}

/// Coordinates and speeds by name, in their units.
fn state_object(description: &Description, state: &Row) -> Value {
    let positions = description.coordinates.iter().zip(&state.positions).map(|(c, value)| (&c.position, value));
    let speeds = description.coordinates.iter().zip(&state.speeds).map(|(c, value)| (&c.speed, value));
    let entries = positions.chain(speeds).map(|(q, value)| {
        let value = json!({ "value": value / q.factor, "unit": q.unit });
        (q.name.to_owned(), value)
    });
    entries.collect::<Map<String, Value>>().into()
}
