//! `sim kinematics`.

use crate::analysis::kinematics::{prescribed_coordinate, quotient};
use crate::cli::arguments::{KinematicsArguments, Voice};
use crate::cli::events::{idle_events, only_in_runs};
use crate::cli::files::asked::command;
use crate::cli::files::folder;
use crate::cli::files::written::Files;
use crate::cli::given::as_given;
use crate::cli::quantity::parse_quantity;
use crate::cli::signals;
use crate::cli::{Stop, unknown};
use crate::output::show::{self, SWEEP_FIGURES};
use crate::{
    Driven, Extreme, Extremes, Failure, Kinematics, Mobility, Range, SpecialPosition, Start, Sweep, Table, What,
    kinematics_until,
};
use serde_json::{Map, Value, json};
use sim_kernel::{Array, Description, Mechanism, Quantity};
use std::path::Path;
use std::sync::atomic::AtomicBool;

impl KinematicsArguments {
    pub(in crate::cli) fn model(&self) -> &str {
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
        let to = match (&self.to, driven.turn(description)) {
            (Some(text), _) => value("--to", text)?,
            (None, Some(turn)) => from + turn,
            (None, None) => return Err(needed("--to", quantity)),
        };
        if from == to {
            return Err(Stop::Usage(format!(
                "--from and --to are equal: there is nothing to drive `{}` through",
                quantity.name
            )));
        }
        let declared = match driven {
            Driven::Coordinate(i) => prescribed.filter(|(j, _)| *j == i).map(|(_, speed)| speed).or(speeds[i]),
            Driven::Output(_) => None,
        };
        let speed = self.speed(description, driven, declared)?;
        let held = self.hold.iter().map(|text| hold(description, now, text)).collect::<Result<_, _>>()?;
        Ok(Sweep { driven, from, to, speed, steps: self.steps as usize, held })
    }

    fn speed(&self, description: &'static Description, driven: Driven, declared: Option<f64>) -> Result<f64, Stop> {
        let speed = match (&self.speed, driven) {
            (Some(text), Driven::Coordinate(i)) => {
                parse_quantity("--speed", text, description.coordinates[i].speed.unit)?
            }
            (Some(text), Driven::Output(_)) => {
                parse_quantity("--speed", text, &quotient(driven.quantity(description), &SECOND))?
            }
            (None, _) => declared.unwrap_or(0.0),
        };
        Ok(speed)
    }
}

const SECOND: Quantity = Quantity { name: "t", unit: "s", factor: 1.0, is_length: false, docs: "" };

fn needed(option: &str, quantity: &Quantity) -> Stop {
    Stop::Usage(format!("{option} is needed for `{}`, as in `{option} 0.1{}`", quantity.name, quantity.unit))
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
pub(in crate::cli) fn kinematics_command<M: Mechanism>(
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
    let now = |driven: Driven| driven.value(&mechanism, 0.0, &start.positions);
    let speeds: Vec<Option<f64>> = start.speed_given.iter().zip(start.speeds.iter()).map(given).collect();
    let prescribed = prescribed_coordinate(&mechanism, &start.positions);
    let sweep = arguments.sweep(mechanism.description(), &now, &speeds, prescribed)?;
    Ok((mechanism, start, sweep))
}

/// The sweep, and its summary.
pub(in crate::cli) fn swept<M: Mechanism>(
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

/// The results, without the type of the mechanism.
struct Found<'a> {
    description: &'static Description,
    sweep: &'a Sweep,
    values: &'a [f64],
    is_cycle: bool,
    mobility: &'a Mobility,
    branches: &'a [SpecialPosition],
    limit: Option<&'a SpecialPosition>,
    extremes: &'a Extremes,
    failure: Option<&'a Failure>,
}

impl<'a> Found<'a> {
    fn new<M: Mechanism>(found: &'a Kinematics<M>) -> Found<'a> {
        Found {
            description: found.mechanism.description(),
            sweep: &found.sweep,
            values: &found.values,
            is_cycle: found.is_cycle(),
            mobility: &found.mobility,
            branches: &found.branches,
            limit: found.limit.as_ref(),
            extremes: &found.extremes,
            failure: found.trajectory.failure.as_ref(),
        }
    }

    /// The driven quantity.
    fn driven(&self) -> &'static Quantity {
        self.sweep.driven.quantity(self.description)
    }

    /// The drive and the holds, each with its force.
    fn drives(&self) -> impl Iterator<Item = (Driven, &'a Option<Range>)> {
        let held = self.sweep.held.iter().map(|(held, _)| *held);
        [self.sweep.driven].into_iter().chain(held).zip(&self.extremes.forces)
    }
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

/// The driven quantity and its range.
fn drive(found: &Found) -> Value {
    let driven = found.driven();
    let value = |si: f64| si / driven.factor;
    json!({
        "name": driven.name,
        "unit": driven.unit,
        "from": value(found.sweep.from),
        "to": value(found.sweep.to),
        "speed": value(found.sweep.rate()),
        "reached": found.values.last().copied().map(value),
        "samples": found.values.len(),
    })
}

/// The results, in declared units.
fn summary(found: &Found) -> Value {
    let (description, driven) = (found.description, found.driven());
    let value = |si: f64| si / driven.factor;
    let special = |position: &SpecialPosition| {
        let coordinates = description.coordinates.iter().zip(&position.positions);
        let coordinates = coordinates.map(|(c, q)| (c.position.name.to_owned(), json!(q / c.position.factor)));
        json!({ "at": value(position.value), "coordinates": coordinates.collect::<Map<_, _>>() })
    };
    let extreme = |extreme: &Extreme, factor: f64| json!({ "value": extreme.value / factor, "at": value(extreme.at) });
    let range = |range: &Range, factor: f64, unit: &str| {
        let (least, greatest) = (extreme(&range.least, factor), extreme(&range.greatest, factor));
        json!({ "unit": unit, "least": least, "greatest": greatest, "stroke": range.stroke() / factor })
    };
    let extremes = found.extremes;
    let outputs = description.outputs.iter().enumerate().filter_map(|(i, o)| {
        let mut entry = range(extremes.outputs[i].as_ref()?, o.factor, o.unit);
        if let Some(ratio) = &extremes.time_ratios[i] {
            let [working, returning] = [ratio.working, ratio.returning].map(value);
            entry["time_ratio"] = json!({ "ratio": ratio.ratio, "working": working, "returning": returning });
        }
        if let Some(ratio) = &extremes.ratios[i] {
            let peak = ratio.peak();
            let least = driven.factor.recip() * o.factor / peak.value;
            entry["least_mechanical_advantage"] =
                json!({ "value": least, "unit": quotient(driven, o), "at": value(peak.at) });
        }
        Some((o.name.to_owned(), entry))
    });
    let multipliers = description.constraints.iter().zip(&extremes.multipliers);
    let multipliers =
        multipliers.filter_map(|(c, found)| Some((c.name.to_owned(), range(found.as_ref()?, c.factor, c.unit))));
    let drives = found.drives().filter_map(|(driven, found)| {
        let unit = &driven.force_unit(description);
        Some((driven.quantity(description).name.to_owned(), range(found.as_ref()?, 1.0, unit)))
    });
    json!({
        "model": description.name,
        "drive": drive(found),
        "failure": found.failure.map(ToString::to_string),
        "failure_code": found.failure.map(|failure| failure.what.code()),
        "degrees_of_freedom": found.mobility.degrees_of_freedom,
        "redundant_constraints": found.mobility.dependent,
        "cycle": found.is_cycle,
        "limit_position": found.limit.map(special),
        "branch_positions": found.branches.iter().map(special).collect::<Vec<_>>(),
        "drives": drives.collect::<Map<_, _>>(),
        "transmission_index": extremes.transmission.as_ref().map(|found| range(found, 1.0, "1")),
        "outputs": outputs.collect::<Map<_, _>>(),
        "multipliers": multipliers.collect::<Map<_, _>>(),
        "without_bounds": without_bounds(found),
        "events_without_effect": idle_events(description),
    })
}

/// The columns that have no least and no greatest value.
fn without_bounds(found: &Found) -> Vec<String> {
    let (description, extremes) = (found.description, found.extremes);
    let drives = found.drives().map(|(driven, range)| (format!("drive_{}", driven.quantity(description).name), range));
    let multipliers = description.constraints.iter().zip(&extremes.multipliers);
    let multipliers = multipliers.map(|(c, range)| (format!("lambda_{}", c.name), range));
    let outputs = description.outputs.iter().zip(&extremes.outputs).map(|(o, range)| (o.name.to_owned(), range));
    let all = drives.chain(multipliers).chain(outputs);
    all.filter(|(_, range)| range.is_none()).map(|(name, _)| name).collect()
}

/// The same to be read.
fn report(found: &Found) -> String {
    let description = found.description;
    let (driven, sweep, extremes) = (found.driven(), found.sweep, found.extremes);
    let value = |si: f64| format!("{:.6} {}", si / driven.factor, driven.unit);
    let mut text = format!("{:<12} {}\n", "model", description.name);
    text += &format!(
        "{:<12} {} from {} to {} {}, {} positions\n",
        "drive",
        driven.name,
        value(sweep.from),
        value(sweep.to),
        if sweep.is_at_rest() {
            "at rest in each".to_owned()
        } else {
            speed(sweep.rate() / driven.factor, driven.unit)
        },
        found.values.len()
    );
    text += &passed(found);
    text += &format!("{:<22} {:>14} {:>14} {:>14} {:>14}  unit\n", "", "least", "at", "greatest", "at");
    let mut row = |name: &str, range: &Option<Range>, factor: f64, unit: &str| {
        let Some(Range { least, greatest }) = range else {
            text +=
                &format!("{name:<22} not finite everywhere, or without bound, as at a pole or beside a dead point\n");
            return;
        };
        let numbers =
            [least.value / factor, least.at / driven.factor, greatest.value / factor, greatest.at / driven.factor];
        let numbers = numbers.map(|number| format!("{:>14}", significant(number))).join(" ");
        text += &format!("{name:<22} {numbers}  {unit}\n");
    };
    for (driven, range) in found.drives() {
        row(&format!("drive_{}", driven.quantity(description).name), range, 1.0, &driven.force_unit(description));
    }
    row("transmission_index", &extremes.transmission, 1.0, "1");
    for (c, range) in description.constraints.iter().zip(&extremes.multipliers) {
        row(&format!("lambda_{}", c.name), range, c.factor, c.unit);
    }
    for (o, range) in description.outputs.iter().zip(&extremes.outputs) {
        row(o.name, range, o.factor, o.unit);
    }
    for (o, ratio) in description.outputs.iter().zip(&extremes.time_ratios) {
        let Some(ratio) = ratio else { continue };
        let (working, returning) = (value(ratio.working), value(ratio.returning));
        text += &format!("{:<12} {}: {:.9} ({working} to {returning})\n", "time ratio", o.name, ratio.ratio);
    }
    text
}

/// What the sweep comes upon, to be read.
fn passed(found: &Found) -> String {
    let driven = found.driven();
    let value = |si: f64| format!("{:.6} {}", si / driven.factor, driven.unit);
    let mut text = String::new();
    for position in found.branches {
        text += &format!("{:<12} another branch of the motion crosses at {}\n", "branches", value(position.value));
    }
    if let Some(position) = found.limit {
        text += &format!("{:<12} {} goes no further than {}\n", "limit", driven.name, value(position.value));
    }
    if let Some(line) = only_in_runs(found.description) {
        text += &format!("{:<12} {line}\n", "events");
    }
    text
}

/// A speed, to be read.
fn speed(value: f64, unit: &str) -> String {
    format!("at {value:.6} {unit}/s")
}

/// Nine significant digits.
fn significant(value: f64) -> String {
    // Zero has no sign here.
    let value = value + 0.0;
    let plain = value == 0.0 || (1e-3..1e6).contains(&value.abs());
    if plain { format!("{value:.6}") } else { format!("{value:.6e}") }
}
