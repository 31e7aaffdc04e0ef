//! `sim run`.

use crate::Stop;
use crate::arguments::{RunArguments, Voice};
use crate::files::folder;
use crate::files::reproduction::Reproduction;
use crate::files::written::Files;
use crate::given::{as_given, held_at};
use crate::progress;
use crate::said::{counted, short};
use crate::tell::tell;
use serde_json::{Value, json};
use sim_kernel::{Description, Input, Mechanism, Quantity};
use sim_output::show::{self, About};
use sim_output::{Outcome, Recorded, Until, impulses, summary_of, write_json};
use sim_runtime::{
    Failure, Run, Settings, Start, Stepping, Table, What, assemble, mobility, readable, run_compared, run_while,
};
use std::path::PathBuf;
use std::time::Instant;

/// Runs a mechanism, writes the results, and prints a short table.
pub(crate) fn run_command<M: Mechanism>(mechanism: M, arguments: &RunArguments, voice: Voice) -> Result<(), Stop> {
    let description = mechanism.description();
    let clock = Instant::now();
    let Asked { mechanism, start, settings, mut reproduction } = asked(&mechanism, arguments)?;
    let directory = arguments.out.clone().unwrap_or_else(|| PathBuf::from("out").join(description.name));
    let files = Files::new(description, &directory, &["mechanism"])?;
    warn_of_redundancy(&mechanism, &start, voice);
    let driven = inputs(description, mechanism.inputs().as_ref());
    let made = made::<M>(arguments);
    let found = progress::watched(settings.end, voice, |goes_on| made(mechanism, &start, &settings, goes_on))?;
    let clock = Clock { start: clock, integrated: clock.elapsed().as_secs_f64() };
    let mut table = Table::of(&found.mechanism, &found.trajectory);
    told(&found, &mut table, arguments, (&mut reproduction, files, clock), (driven, voice))
}

/// What makes a run.
type Made<M> = fn(M, &Start<M>, &Settings, &mut dyn FnMut(f64) -> bool) -> Result<Run<M>, Failure>;

/// How a run is made: compared with another, or alone.
pub(crate) fn made<M: Mechanism>(arguments: &RunArguments) -> Made<M> {
    if arguments.no_comparison { run_while } else { run_compared }
}

/// A run as it is asked for.
pub(crate) struct Asked<M: Mechanism> {
    pub(crate) mechanism: M,
    pub(crate) start: Start<M>,
    pub(crate) settings: Settings,
    pub(crate) reproduction: Reproduction,
}

pub(crate) fn asked<M: Mechanism>(mechanism: &M, arguments: &RunArguments) -> Result<Asked<M>, Stop> {
    let (mechanism, start) = as_given(mechanism, &arguments.set, &arguments.initial)?;
    let mechanism = held_at(&mechanism, &arguments.input)?;
    let settings = arguments.settings.settings(mechanism.description())?;
    arguments.written.chosen(&Table::headers(mechanism.description())).map_err(Stop::Usage)?;
    let reproduction = Reproduction::new(&mechanism, &start, &settings, arguments);
    Ok(Asked { mechanism, start, settings, reproduction })
}

/// Writes the results, prints a short table with what drives the inputs, and reports failures.
fn told(
    found: &dyn Recorded,
    table: &mut Table,
    arguments: &RunArguments,
    (reproduction, mut files, clock): (&mut Reproduction, Files, Clock),
    (driven, voice): (Option<Line>, Voice),
) -> Result<(), Stop> {
    let outcome = found.outcome();
    let mut summary = summary_of(&outcome, table);
    let times = write(&mut files, found, (&outcome, &mut *table, &mut summary), arguments, (reproduction, clock));
    files.say(voice, summary, &report(&outcome, driven, &files, &times))?;
    let is_interrupted = outcome.failure.as_ref().is_some_and(|failure| failure.what == What::Interrupted);
    files.check(failures(outcome.failure.as_ref(), table), is_interrupted)
}

/// When a run began, and how many seconds later it was integrated.
struct Clock {
    start: Instant,
    integrated: f64,
}

/// Seconds from the start of a run.
struct Times {
    /// Until figures were begun.
    without_figures: f64,
    /// Until all was written.
    total: f64,
}

/// Writes everything: tables, run file, figures, report, and last the times; the summary when all of them are whole.
fn write(
    files: &mut Files,
    run: &dyn Recorded,
    (outcome, table, summary): (&Outcome, &mut Table, &mut Value),
    arguments: &RunArguments,
    (reproduction, clock): (&mut Reproduction, Clock),
) -> Times {
    let seconds = || clock.start.elapsed().as_secs_f64();
    Files::name_run(table, reproduction.command.clone(), &mut [&mut reproduction.file, summary]);
    files.add_table(table, &arguments.written);
    files.add("run.json", |path| write_json(&reproduction.file, path));
    folder::tell("summary.json", summary.clone());
    let without_figures = seconds();
    let is_shown = !table.times().is_empty() && files.has_room();
    if !arguments.no_report && is_shown {
        let about = About { summary, command: &reproduction.command, run_file: Some(&reproduction.text()) };
        files.add("report.html", |path| show::report_of(run, outcome, table, &about, path));
    }
    if !arguments.written.no_figures && is_shown && files.has_room() {
        let settings = arguments.written.figures();
        files.add_figures(settings, |directory| show::figures_of(run, outcome, table, directory, settings));
    }
    let times = Times { without_figures, total: seconds() };
    let timing = json!({
        "run": table.provenance.run,
        "integration_seconds": outcome.integration_seconds,
        "integrated_seconds": clock.integrated,
        "without_figures_seconds": times.without_figures,
        "total_seconds": times.total,
        "provenance": table.provenance.to_json(),
    });
    files.add("timing.json", |path| write_json(&timing, path));
    files.finish();
    times
}

/// Failures of the motion or its outputs.
pub(crate) fn failures(failure: Option<&Failure>, table: &Table) -> Vec<String> {
    let of_output = |(name, time): &(&str, f64)| {
        format!(
            "output `{name}` is not finite at t = {time} s: its expression leaves its domain there (division by zero, root or \
             logarithm of a negative number). The motion is not affected"
        )
    };
    match failure {
        Some(failure) => vec![failure.to_string()],
        None => table.undefined_outputs().first().map(of_output).into_iter().collect(),
    }
}

/// Names redundant constraints before a run, which may be long.
fn warn_of_redundancy<M: Mechanism>(mechanism: &M, start: &Start<M>, voice: Voice) {
    let Ok(first) = assemble(mechanism, start) else { return };
    if !voice.quiet {
        let found = mobility(mechanism, first.time, &first.positions);
        found.redundancies().iter().for_each(|line| tell!("redundant constraint: {line}"));
    }
}

/// The method, its steps and their cost.
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

/// The message if the event that should end the run has not happened.
fn never(run: &Outcome) -> Option<String> {
    let Until { event, asked, happened } = run.until().filter(|_| run.failure.is_none())?;
    let count = counted(happened, "time");
    let ended = match run.reached < run.settings.end {
        true => format!("the run has ended at {} s", readable(run.reached, 6)),
        false => "the run went on to its end".to_owned(),
    };
    (happened < asked).then(|| format!("`{event}` has happened {count}, not {asked}: {ended}"))
}

/// A line of the report: label and text.
type Line = (&'static str, String);

/// Events of which more happen are told by the summary alone; so are dead points and singular positions.
const MOST_LINES: usize = 8;

/// The short table for the terminal.
fn report(run: &Outcome, driven: Option<Line>, files: &Files, times: &Times) -> String {
    let description = run.description;
    let end = run.settings.end;
    let reached = run.reached;
    let span = if reached == end { format!("0 to {end:?} s") } else { format!("0 to {reached:?} s of {end:?} s") };
    let mut rows = vec![("model", description.name.to_owned()), ("method", method(run)), ("time", span)];
    rows.extend(driven);
    rows.extend(happened(run));
    rows.extend(quality(run));
    let milliseconds = |seconds: f64| 1e3 * seconds;
    let integration = milliseconds(run.integration_seconds);
    let (without, total) = (milliseconds(times.without_figures), milliseconds(times.total));
    rows.push((
        "wall time",
        format!("{integration:.2} ms integration, {without:.0} ms without figures, {total:.0} ms in all"),
    ));
    let is_figure = |name: &&String| name.ends_with(".svg") || name.ends_with(".png");
    let others: Vec<&str> = files.names.iter().filter(|name| !is_figure(name)).map(String::as_str).collect();
    let figures = counted(files.names.iter().filter(|name| name.ends_with(".svg")).count(), "figure");
    rows.push(("written", format!("{}: {}, {figures}", files.directory().display(), others.join(", "))));
    if files.names.iter().any(|name| name == "report.html") {
        rows.push(("look at", format!("{}", files.directory().join("report.html").display())));
    }
    rows.iter().map(|(name, value)| format!("{name:<12} {value}\n")).collect()
}

/// Which inputs are held from the start, and how others can be; nothing of a mechanism without inputs.
fn inputs(description: &Description, inputs: &[Input]) -> Option<Line> {
    let (first, others) = description.inputs.split_first()?;
    let of_each = description.inputs.iter().zip(inputs);
    let held: Vec<String> = of_each
        .filter_map(|(quantity, input)| {
            let Quantity { name, unit, factor, .. } = quantity;
            Some(format!("{name} = {} {unit}", short(input.held()? / factor)))
        })
        .collect();
    let (first, held_there) = (first.name, held.join(", "));
    let line = match (held.len(), others.len()) {
        (0, 0) => format!("{first} as declared; `--input {first}=VALUE` holds it at a value"),
        (0, more) => {
            let others = counted(more, "other");
            format!("{first} and {others} as declared; `--input {first}=VALUE` holds one at a value")
        }
        (count, more) if count > more => format!("{held_there} held"),
        _ => format!("{held_there} held, others as declared"),
    };
    Some(("inputs", line))
}

/// The events of the run.
fn happened(run: &Outcome) -> Vec<Line> {
    let (description, mut rows) = (run.description, Vec::new());
    match run.period {
        Some(period) => rows.push(("period", format!("{} s", readable(period, 12)))),
        None if description.events.iter().any(|event| event.name == "period") => {
            rows.push(("period", "not reached".into()))
        }
        None => {}
    }
    let events: Vec<_> = run.events.iter().filter(|event| event.name != "period").collect();
    for event in events.iter().take(MOST_LINES) {
        let impulses = impulses(event, description)
            .into_iter()
            .map(|(name, value, unit)| format!("; impulse of {name} {} {unit}", readable(value, 6)));
        let more: String = impulses.collect();
        rows.push(("event", format!("{} at {} s{more}", event.name, readable(event.time, 12))));
    }
    rows.extend(more("event", events.len()));
    rows.extend(never(run).map(|line| ("until", line)));
    for (of, time) in run.dead_points.iter().take(MOST_LINES) {
        let of = of.join(", ");
        rows.push((
            "dead point",
            format!("of {of} at {} s: the motion continues on another branch", readable(*time, 12)),
        ));
    }
    rows.extend(more("dead point", run.dead_points.len()));
    rows.extend(run.mobility.redundancies().into_iter().map(|line| ("redundant", line)));
    for (time, mobility) in &run.redundant_later {
        let from = readable(*time, 9);
        rows.extend(mobility.redundancies().into_iter().map(|line| ("redundant", format!("from {from} s: {line}"))));
    }
    for passed in run.steps.singularities.iter().take(MOST_LINES) {
        let crossed = "passed straight through: another branch of the motion begins there, and reactions are unbounded";
        rows.push(("singular", format!("`{}` at {} s, {crossed}", passed.constraint, readable(passed.time, 9))));
    }
    rows.extend(more("singular", run.steps.singularities.len()));
    rows.extend(run.corners().map(|line| ("corner", line)));
    rows
}

/// What is not printed of so many.
fn more(what: &'static str, count: usize) -> Option<Line> {
    (count > MOST_LINES).then(|| (what, format!("and {} more: see summary.json", count - MOST_LINES)))
}

/// What a run with another tolerance says of the motion, unless it says by how much it is off.
fn compared(run: &Outcome) -> Option<String> {
    match (run.compared, &run.apart) {
        _ if run.failure.is_some() => None,
        (Some(_), Some(_)) => None,
        (Some(tolerance), None) => {
            let but = run
                .unresolved
                .map(|of| format!(" but `{}`'s", run.description.coordinates[of.coordinate].position.name));
            Some(format!(
                "rows agree with those of a run with tolerance {tolerance:.0e}, to a thousandth of each coordinate's way{}",
                but.unwrap_or_default()
            ))
        }
        (None, _) => {
            Some("not compared with a run of another tolerance: whether errors have grown is not known".to_owned())
        }
    }
}

/// The accuracy of the numbers.
fn quality(run: &Outcome) -> Vec<Line> {
    let mut rows = Vec::new();
    if !run.description.constraints.is_empty() {
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
    rows.extend(compared(run).map(|line| ("compared", line)));
    if run.energy_taken != 0.0 {
        rows.push(("impact loss", format!("{:.6e} J of kinetic energy taken by events", run.energy_taken)));
    }
    rows.extend(run.warnings().into_iter().map(|line| ("warning", line)));
    rows
}
