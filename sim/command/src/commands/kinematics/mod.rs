//! `sim kinematics`.

mod found;

use crate::arguments::{KinematicsArguments, Voice};
use crate::files::asked::command;
use crate::files::folder;
use crate::files::written::Files;
use crate::given::as_given;
use crate::quantity::parse_quantity;
use crate::signals;
use crate::{Stop, unknown};
use found::{Found, report, summary};
use serde_json::Value;
use sim_kernel::{Array, Description, Mechanism, Quantity};
use sim_output::show::{self, SWEEP_FIGURES};
use sim_runtime::{
    Driven, Kinematics, Start, Sweep, Table, What, assemble, kinematics_until, prescribed_coordinate, quotient,
};
use std::path::Path;
use std::sync::atomic::AtomicBool;

impl KinematicsArguments {
    pub(crate) fn model(&self) -> &str {
        &self.model
    }

    /// The sweep of a mechanism, where `now` gives the values of coordinates and outputs at the start, with these
    /// speeds there; `prescribed` is a coordinate that a constraint drives.
    fn sweep(
        &self,
        description: &'static Description,
        now: &dyn Fn(Driven) -> f64,
        speeds: &[Option<f64>],
        prescribed: Option<(usize, f64)>,
    ) -> Result<Sweep, Stop> {
        let driven = match &self.drive {
            Some(name) => find(description, name)?,
            None => prescribed.map_or_else(|| default_drive(description), |(i, _)| Ok(Driven::Coordinate(i)))?,
        };
        let quantity = driven.quantity(description);
        let value = |option: &str, text: &str| parse_quantity(option, text, quantity.unit);
        let from = match (&self.from, driven) {
            (Some(text), _) => value("--from", text)?,
            (None, Driven::Coordinate(_)) => now(driven),
            (None, Driven::Output(_)) => return Err(needed("--from", quantity)),
        };
        let asked = self.asked_speed(description, driven)?;
        let declared = match driven {
            Driven::Coordinate(i) => prescribed.filter(|(j, _)| *j == i).map(|(_, speed)| speed).or(speeds[i]),
            Driven::Output(_) => None,
        };
        let speed = asked.or(declared).unwrap_or(0.0);
        let to = match (&self.to, driven.turn(description)) {
            (Some(text), _) => value("--to", text)?,
            (None, Some(turn)) => from + if speed < 0.0 { -turn } else { turn },
            (None, None) => return Err(needed("--to", quantity)),
        };
        if asked.is_some_and(|speed| speed < 0.0) && to > from {
            return Err(Stop::Usage(format!(
                "--speed is negative, and `{}` grows from --from to --to: give a positive speed, or both ends the other way round",
                quantity.name
            )));
        }
        if from == to {
            return Err(Stop::Usage(format!(
                "--from and --to are equal: there is nothing to drive `{}` through",
                quantity.name
            )));
        }
        let held = self.hold.iter().map(|text| hold(description, now, text)).collect::<Result<_, _>>()?;
        Ok(Sweep { driven, from, to, speed, steps: self.steps as usize, held })
    }

    /// The speed that is asked for.
    fn asked_speed(&self, description: &'static Description, driven: Driven) -> Result<Option<f64>, Stop> {
        let parse = |text: &String| match driven {
            Driven::Coordinate(i) => parse_quantity("--speed", text, description.coordinates[i].speed.unit),
            Driven::Output(_) => parse_quantity("--speed", text, &quotient(driven.quantity(description), &SECOND)),
        };
        self.speed.as_ref().map(parse).transpose()
    }
}

const SECOND: Quantity = Quantity { name: "t", unit: "s", factor: 1.0, is_length: false, docs: "" };

fn needed(option: &str, quantity: &Quantity) -> Stop {
    let unit = if quantity.unit == "1" { "" } else { quantity.unit };
    Stop::Usage(format!("{option} is needed for `{}`, as in `{option} 0.1{unit}`", quantity.name))
}

fn find(description: &Description, name: &str) -> Result<Driven, Stop> {
    let coordinates = description.coordinates.iter().map(|c| c.position.name);
    let known = coordinates.chain(description.outputs.iter().map(|o| o.name));
    Driven::find(description, name).ok_or_else(|| unknown("coordinate or output", name, known))
}

/// The only coordinate, or the first that the declaration gives a value, not a guess.
fn default_drive(description: &Description) -> Result<Driven, Stop> {
    let mut coordinates = description.coordinates.iter();
    let chosen = match coordinates.len() {
        1 => Some(0),
        _ => coordinates.position(|c| c.start == sim_kernel::Start::Given),
    };
    chosen.map(Driven::Coordinate).ok_or_else(|| Stop::Usage("say what is driven, as in `--drive alpha`".into()))
}

fn hold(description: &'static Description, now: &dyn Fn(Driven) -> f64, text: &str) -> Result<(Driven, f64), Stop> {
    let (name, value) = text.split_once('=').map_or((text, None), |(name, value)| (name.trim(), Some(value.trim())));
    let driven = find(description, name)?;
    let value = match value {
        Some(value) => parse_quantity(name, value, driven.quantity(description).unit)?,
        None => now(driven),
    };
    Ok((driven, value))
}

/// Drives a mechanism through a range, writes the results, and prints a summary.
pub(crate) fn kinematics_command<M: Mechanism>(
    mechanism: M,
    arguments: &KinematicsArguments,
    voice: Voice,
) -> Result<(), Stop> {
    let description = mechanism.description();
    let (mechanism, start, sweep) = asked(&mechanism, arguments)?;
    let directory = arguments.out.clone();
    let directory = directory.unwrap_or_else(|| format!("out/{}-kinematics", description.name).into());
    let files = Files::new(description, &directory, &SWEEP_FIGURES)?;
    let found = signals::interruptible(|| kinematics_until(&signals::INTERRUPTED, mechanism, &start, &sweep))?;
    let settings = arguments.written.figures();
    let pictures = Pictures {
        figures: &|table, directory| show::sweep_figures(&found, table, directory, settings),
        report: &|table, command, path| show::sweep_report(&found, table, command, path),
    };
    tell(&Found::new(&found), &mut found.table(), (arguments, files), &pictures, voice)
}

/// The sweep as it is asked for.
fn asked<M: Mechanism>(mechanism: &M, arguments: &KinematicsArguments) -> Result<(M, Start<M>, Sweep), Stop> {
    let (mechanism, start) = as_given(mechanism, &arguments.set, &arguments.initial)?;
    // Guesses are no places where the mechanism can be. One that cannot be assembled as it is given may be on the way.
    let positions = assemble(&mechanism, &start).map_or_else(|_| start.positions.clone(), |state| state.positions);
    let now = |driven: Driven| driven.value(&mechanism, 0.0, &positions);
    let speeds: Vec<Option<f64>> = start.speed_given.iter().zip(start.speeds.iter()).map(given).collect();
    let prescribed = prescribed_coordinate(&mechanism, &positions);
    let sweep = arguments.sweep(mechanism.description(), &now, &speeds, prescribed)?;
    Ok((mechanism, start, sweep))
}

/// The sweep, and its summary.
pub(crate) fn swept<M: Mechanism>(
    mechanism: M,
    arguments: &KinematicsArguments,
    interrupted: &AtomicBool,
) -> Result<(Kinematics<M>, Value), Stop> {
    let (mechanism, start, sweep) = asked(&mechanism, arguments)?;
    let found = kinematics_until(interrupted, mechanism, &start, &sweep)?;
    let summary = summary(&Found::new(&found));
    Ok((found, summary))
}

/// What draws a sweep.
struct Pictures<'a> {
    figures: &'a dyn Fn(&Table, &Path) -> show::Figures,
    /// From the command that repeats it, to a file.
    report: &'a dyn Fn(&Table, &str, &Path) -> Result<(), show::ShowError>,
}

/// A value, if it is given.
fn given((is_given, value): (&bool, &f64)) -> Option<f64> {
    is_given.then_some(*value)
}

/// Writes the results, and prints a summary.
fn tell(
    found: &Found,
    table: &mut Table,
    (arguments, mut files): (&KinematicsArguments, Files),
    pictures: &Pictures,
    voice: Voice,
) -> Result<(), Stop> {
    let mut summary = summary(found);
    let command = command();
    Files::name_run(table, command.clone(), &mut [&mut summary]);
    files.add_table(table, &arguments.written);
    folder::tell("summary.json", summary.clone());
    let is_shown = !table.times().is_empty() && files.has_room();
    if !arguments.no_report && is_shown {
        files.add("report.html", |path| (pictures.report)(table, &command, path));
    }
    if !arguments.written.no_figures && is_shown && files.has_room() {
        files.add_figures(arguments.written.figures(), |directory| (pictures.figures)(table, directory));
    }
    files.finish();
    files.say(voice, summary, &format!("{}{}", report(found), files.line()))?;
    let is_interrupted = found.failure.is_some_and(|failure| failure.what == What::Interrupted);
    files.check(found.failure.iter().map(ToString::to_string).collect(), is_interrupted)
}
