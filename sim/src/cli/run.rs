//! `sim run`.

use super::arguments::{RunArguments, Voice};
use super::files::{self, Took};
use super::folder::Folder;
use super::list::counted;
use super::quantity::{parse_quantity, split_assignment};
use super::run_file::Reproduction;
use super::{Stop, progress, unknown};
use crate::happening::impulses;
use crate::outcome::{Outcome, Recorded};
use crate::write::summary_of;
use crate::{Start, Stepping, Table, What, assemble, declared_start, mobility, run};
use sim_kernel::{Description, Input, Mechanism};
use std::path::{Path, PathBuf};
use std::time::Instant;

/// Runs a mechanism, writes what it found, and prints a short table.
pub(super) fn run_command<M: Mechanism>(arguments: &RunArguments, voice: Voice) -> Result<(), Stop> {
    let description = const { &M::DESCRIPTION };
    let clock = Instant::now();
    let mechanism = mechanism_with::<M>(description, &arguments.set)?;
    let mechanism = held_at(&mechanism, description, &arguments.input)?;
    let start = start_with(&mechanism, description, &arguments.initial)?;
    let settings = arguments.settings.settings(description)?;
    let reproduction = Reproduction::new(&mechanism, &start, &settings, arguments);
    let directory = arguments.out.clone().unwrap_or_else(|| PathBuf::from("out").join(description.name));
    warn_of_redundancy(&mechanism, &start, voice);
    let found = progress::watched(&settings, voice, |settings| run(mechanism, &start, settings))?;
    let table = Table::of(&found.mechanism, &found.trajectory);
    told(&found, &table, arguments, (&reproduction, &directory, clock), voice)
}

/// Writes what was found, prints a short table, and says what went wrong.
fn told(
    found: &dyn Recorded,
    table: &Table,
    arguments: &RunArguments,
    (reproduction, directory, clock): (&Reproduction, &Path, Instant),
    voice: Voice,
) -> Result<(), Stop> {
    let outcome = found.outcome();
    let summary = summary_of(&outcome, table);
    let mut folder = Folder::open(outcome.description, directory, &[])?;
    let took = files::write(found, (&outcome, table, &summary), arguments, reproduction, &mut folder, clock)?;
    folder.say(voice, summary, &report(&outcome, &folder, &took))?;
    match (outcome.failure, table.undefined_outputs().first()) {
        (Some(failure), _) if failure.what == What::Interrupted => Err(Stop::Interrupted(failure.into())),
        (Some(failure), _) => Err(failure.into()),
        (None, Some((name, time))) => Err(Stop::Failed(anyhow::anyhow!(
            "output `{name}` is not finite at t = {time} s: its expression leaves its domain there (division by zero, root or \
             logarithm of a negative number). The motion is not affected"
        ))),
        (None, None) => folder.check(),
    }
}

/// Names redundant constraints before a run, which may be long.
fn warn_of_redundancy<M: Mechanism>(mechanism: &M, start: &Start<M>, voice: Voice) {
    let Ok(first) = assemble(mechanism, start) else { return };
    if !voice.quiet {
        let found = mobility(mechanism, first.time, &first.positions);
        found.redundancies().iter().for_each(|line| eprintln!("redundant constraint: {line}"));
    }
}

pub(super) fn mechanism_with<M: Mechanism>(description: &Description, settings: &[String]) -> Result<M, Stop> {
    let mut parameters = M::defaults().parameters();
    set(parameters.as_mut(), description, settings)?;
    Ok(M::defaults().with_parameters(parameters))
}

/// Sets parameters to what the user says.
fn set(parameters: &mut [f64], description: &Description, settings: &[String]) -> Result<(), Stop> {
    for text in settings {
        let (name, value) = split_assignment("--set", text)?;
        let known = || description.parameters.iter().map(|p| p.name);
        if description.coordinates.iter().any(|c| [c.position.name, c.speed.name].contains(&name)) {
            return Err(Stop::Usage(format!("`{name}` is no parameter; its start is set by `--initial {text}`")));
        }
        if description.inputs.iter().any(|input| input.name == name) {
            return Err(Stop::Usage(format!("`{name}` is an input; `run` holds it by `--input {text}`")));
        }
        let at = known().position(|p| p == name).ok_or_else(|| unknown("parameter", name, known()))?;
        parameters[at] = parse_quantity(name, value, description.parameters[at].unit)?;
    }
    Ok(())
}

/// The mechanism with inputs held at what the user says.
fn held_at<M: Mechanism>(mechanism: &M, description: &Description, settings: &[String]) -> Result<M, Stop> {
    let mut inputs = mechanism.inputs();
    hold(inputs.as_mut(), description, settings)?;
    Ok(mechanism.with_inputs(inputs))
}

fn hold(inputs: &mut [Input<f64>], description: &Description, settings: &[String]) -> Result<(), Stop> {
    for text in settings {
        let (name, value) = split_assignment("--input", text)?;
        let known = || description.inputs.iter().map(|input| input.name);
        if description.parameters.iter().any(|p| p.name == name) {
            return Err(Stop::Usage(format!("`{name}` is a parameter; it is set by `--set {text}`")));
        }
        let at = known().position(|input| input == name).ok_or_else(|| unknown("input", name, known()))?;
        inputs[at] = Input::Held(parse_quantity(name, value, description.inputs[at].unit)?);
    }
    Ok(())
}

pub(super) fn start_with<M: Mechanism>(
    mechanism: &M,
    description: &Description,
    settings: &[String],
) -> Result<Start<M>, Stop> {
    let mut start = declared_start(mechanism);
    for (started, value) in started(description, settings)? {
        match started {
            Started::Position(at) => {
                start.positions[at] = value;
                start.position_given[at] = description.coordinates[at].start != sim_kernel::Start::Guess;
            }
            Started::Speed(at) => {
                start.speeds[at] = value;
                start.speed_given[at] = true;
            }
        }
    }
    Ok(start)
}

/// A coordinate or a speed, by index.
enum Started {
    Position(usize),
    Speed(usize),
}

/// What the user says of the start.
fn started(description: &Description, settings: &[String]) -> Result<Vec<(Started, f64)>, Stop> {
    let mut said = Vec::new();
    for text in settings {
        let (name, value) = split_assignment("--initial", text)?;
        let coordinates = description.coordinates;
        if let Some(at) = coordinates.iter().position(|c| c.position.name == name) {
            said.push((Started::Position(at), parse_quantity(name, value, coordinates[at].position.unit)?));
        } else if let Some(at) = coordinates.iter().position(|c| c.speed.name == name) {
            said.push((Started::Speed(at), parse_quantity(name, value, coordinates[at].speed.unit)?));
        } else {
            if description.parameters.iter().any(|p| p.name == name) {
                return Err(Stop::Usage(format!("`{name}` is a parameter; it is set by `--set {text}`")));
            }
            let known = coordinates.iter().flat_map(|c| [c.position.name, c.speed.name]);
            return Err(unknown("coordinate or speed", name, known));
        }
    }
    Ok(said)
}

/// The method, its steps and what they took.
fn method(run: &Outcome) -> String {
    let settings = &run.settings;
    let steps = match settings.stepping {
        Stepping::Equal(steps) => format!("{} of {:.6e} s", counted(steps, "step"), settings.end / steps as f64),
        Stepping::Adaptive(tolerance) => {
            let accepted = usize::try_from(run.steps.accepted).unwrap_or(usize::MAX);
            format!("rtol {:e}, {}, {} refused", tolerance.relative, counted(accepted, "step"), run.steps.rejected)
        }
    };
    let (name, kept) = (settings.method.name(), settings.stabilisation);
    format!("{name}, {steps}, {} right-hand sides, {kept}", run.evaluations)
}

/// The short table for the terminal.
fn report(run: &Outcome, folder: &Folder, took: &Took) -> String {
    let description = run.description;
    let end = run.settings.end;
    let reached = run.reached;
    let span = if reached == end { format!("0 to {end:?} s") } else { format!("0 to {reached:?} s of {end:?} s") };
    let mut rows = vec![("model", description.name.to_owned()), ("method", method(run)), ("time", span)];
    match run.period {
        Some(period) => rows.push(("period", format!("{period:.12} s"))),
        None if description.events.iter().any(|event| event.name == "period") => {
            rows.push(("period", "not reached".into()))
        }
        None => {}
    }
    for event in run.events.iter().filter(|event| event.name != "period").take(8) {
        let impulses = impulses(event, description)
            .into_iter()
            .map(|(name, value, unit)| format!("; impulse of {name} {value:.6} {unit}"));
        let more: String = impulses.collect();
        rows.push(("event", format!("{} at {:.12} s{more}", event.name, event.time)));
    }
    for (of, time) in run.dead_points.iter().take(8) {
        let of = of.join(", ");
        rows.push(("dead point", format!("of {of} at {time:.12} s: the motion goes on upon another branch")));
    }
    rows.extend(run.mobility.redundancies().into_iter().map(|line| ("redundant", line)));
    for passed in run.steps.singularities.iter().take(8) {
        let crossed = "passed straight on: there another way of moving begins, and reactions have no bound";
        rows.push(("singular", format!("`{}` at {:.9} s, {crossed}", passed.constraint, passed.time)));
    }
    if !description.constraints.is_empty() {
        let (positions, velocities) = (run.position_residual, run.velocity_residual);
        rows.push((
            "constraints",
            format!("open by at most {positions:.1e} (positions), {velocities:.1e} (velocities)"),
        ));
    }
    rows.push((
        "energy",
        format!("balance of kinetic energy and work off by at most {:.1e}, relative", run.energy_balance),
    ));
    if run.energy_taken != 0.0 {
        rows.push(("impact loss", format!("{:.6e} J of kinetic energy taken by events", run.energy_taken)));
    }
    if !(run.energy_balance < crate::DOUBTFUL_BALANCE) {
        rows.push(("warning", "energy does not balance: take smaller steps before you trust these numbers".into()));
    }
    let milliseconds = |seconds: f64| 1e3 * seconds;
    let integration = milliseconds(run.integration_seconds);
    let (without, total) = (milliseconds(took.without_figures), milliseconds(took.total));
    rows.push((
        "wall time",
        format!("{integration:.2} ms integration, {without:.0} ms without figures, {total:.0} ms in all"),
    ));
    let is_picture = |name: &String| name.ends_with(".svg") || name.ends_with(".png");
    let (pictures, files): (Vec<String>, Vec<String>) = folder.names().iter().cloned().partition(is_picture);
    let (directory, figures) = (folder.directory(), counted(pictures.len() / 2, "figure"));
    rows.push(("written", format!("{}: {}, {figures}", directory.display(), files.join(", "))));
    if files.iter().any(|name| name == "report.html") {
        rows.push(("look at", format!("{}", directory.join("report.html").display())));
    }
    rows.iter().map(|(name, value)| format!("{name:<12} {value}\n")).collect()
}
