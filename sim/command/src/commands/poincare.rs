//! `sim poincare`.

use crate::arguments::{PoincareArguments, Voice};
use crate::commands::run::failures;
use crate::files::asked::command;
use crate::files::folder;
use crate::files::written::Files;
use crate::given::as_given;
use crate::progress;
use crate::settings::positive;
use crate::{Stop, unknown};
use serde_json::{Value, json};
use sim_kernel::event::Direction;
use sim_kernel::{Description, Mechanism};
use sim_output::show;
use sim_runtime::{
    Crossing, Failure, Method, Period, Sectioning, Settings, Start, Table, What, poincare_while, readable,
};
use std::path::Path;

/// Takes a section of a motion, writes it and prints its period.
pub(crate) fn poincare_command<M: Mechanism>(
    mechanism: M,
    arguments: &PoincareArguments,
    voice: Voice,
) -> Result<(), Stop> {
    let description = mechanism.description();
    let Asked { mechanism, start, section, settings } = asked(&mechanism, arguments)?;
    let directory = arguments.out.clone().unwrap_or_else(|| format!("out/{}-poincare", description.name).into());
    let files = Files::new(description, &directory, &["mechanism"])?;
    let found = progress::watched(settings.end, voice, |goes_on| {
        poincare_while(mechanism, &start, &section, &settings, goes_on)
    })?;
    let mut table = Table::of(&found.mechanism, &found.trajectory);
    let draw =
        |table: &Table, directory: &Path| show::section_figures(&found, table, directory, arguments.written.figures());
    let (period, failure) = (found.period, found.trajectory.failure.as_ref());
    tell(description, &mut table, (period, failure), arguments, &draw, (files, voice))
}

/// The section as it is asked for.
struct Asked<M: Mechanism> {
    mechanism: M,
    start: Start<M>,
    section: Sectioning,
    settings: Settings,
}

fn asked<M: Mechanism>(mechanism: &M, arguments: &PoincareArguments) -> Result<Asked<M>, Stop> {
    let description = mechanism.description();
    let (mechanism, start) = as_given(mechanism, &arguments.start.set, &arguments.start.initial)?;
    let events = || description.events.iter().map(|event| event.name);
    let event = events().position(|name| name == arguments.event);
    let event = event.ok_or_else(|| unknown("event", &arguments.event, events()))?;
    let crossing = arguments.direction.crossing();
    let never = match (description.events[event].direction, crossing) {
        (Direction::Rising, Some(Crossing::Falling)) => Some("rising"),
        (Direction::Falling, Some(Crossing::Rising)) => Some("falling"),
        _ => None,
    };
    if let Some(declared) = never {
        let message =
            format!("--direction: event `{}` is declared `{declared}`, and happens so alone", arguments.event);
        return Err(Stop::Usage(message));
    }
    if !(1e-14..=0.1).contains(&arguments.rtol) {
        return Err(Stop::Usage("--rtol from 1e-14 to 0.1 is possible; numbers here have 16 digits".into()));
    }
    arguments.written.chosen(&Table::headers(description)).map_err(Stop::Usage)?;
    let section = Sectioning { event, crossing, count: arguments.count as usize };
    let end = positive("--t-end", &arguments.t_end)?;
    let settings = Settings::adaptive(Method::Dop853, end, arguments.rtol);
    Ok(Asked { mechanism, start, section, settings })
}

/// The states that it takes to find a period.
const LEAST_STATES: usize = 3;

/// The states of the section, its summary, and what is wrong with it.
pub(crate) struct Sectioned {
    pub(crate) table: Table,
    pub(crate) summary: Value,
    pub(crate) failure: Option<Failure>,
    pub(crate) problems: Vec<String>,
}

/// Takes a section of a motion for as long as `goes_on` says so.
pub(crate) fn sectioned<M: Mechanism>(
    mechanism: M,
    arguments: &PoincareArguments,
    goes_on: &mut dyn FnMut(f64) -> bool,
) -> Result<Sectioned, Stop> {
    let description = mechanism.description();
    let Asked { mechanism, start, section, settings } = asked(&mechanism, arguments)?;
    let found = poincare_while(mechanism, &start, &section, &settings, goes_on)?;
    let table = Table::of(&found.mechanism, &found.trajectory);
    let failure = found.trajectory.failure;
    let summary = summary(description, arguments, table.times(), (found.period, failure.as_ref()));
    let problems = problems(arguments, &table, failure.as_ref())?;
    Ok(Sectioned { table, summary, failure, problems })
}

/// Writes and prints the results.
fn tell(
    description: &Description,
    table: &mut Table,
    (period, failure): (Option<Period>, Option<&Failure>),
    arguments: &PoincareArguments,
    draw: &dyn Fn(&Table, &Path) -> show::Figures,
    (mut files, voice): (Files, Voice),
) -> Result<(), Stop> {
    let times = table.times().to_vec();
    let mut said = summary(description, arguments, &times, (period, failure));
    Files::name_run(table, command(), &mut [&mut said]);
    files.add_table(table, &arguments.written);
    folder::tell("summary.json", said.clone());
    if !arguments.written.no_figures && !times.is_empty() {
        files.add_figures(arguments.written.figures(), |directory| draw(table, directory));
    }
    files.finish();
    files.say(voice, said, &format!("{}{}", report(description, arguments, &times, period), files.line()))?;
    let problems = problems(arguments, table, failure)?;
    files.check(problems, failure.is_some_and(|failure| failure.what == What::Interrupted))
}

fn summary(
    description: &Description,
    arguments: &PoincareArguments,
    times: &[f64],
    (period, failure): (Option<Period>, Option<&Failure>),
) -> Value {
    json!({
        "model": description.name,
        "event": arguments.event,
        "crossings": times.len(),
        "asked": arguments.count,
        "period": period.map(|period| json!({ "seconds": period.seconds, "crossings": period.crossings })),
        "times": times,
        "failure": failure.map(ToString::to_string),
        "failure_code": failure.map(|failure| failure.what.code()),
    })
}

/// A failure of the motion or of outputs, or that there is no state.
fn problems(arguments: &PoincareArguments, table: &Table, failure: Option<&Failure>) -> Result<Vec<String>, Stop> {
    Ok(match failure {
        None if table.times().is_empty() => vec![format!(
            "event `{}` has not happened in {} s{}. Give a longer --t-end, or another event",
            arguments.event,
            positive("--t-end", &arguments.t_end)?,
            if arguments.direction.crossing().is_some() { " in this direction" } else { "" }
        )],
        _ => failures(failure, table),
    })
}

fn report(description: &Description, arguments: &PoincareArguments, times: &[f64], period: Option<Period>) -> String {
    let mut text = format!("{:<12} {}\n", "model", description.name);
    text += &format!("{:<12} {} states at `{}`", "section", times.len(), arguments.event);
    if let (Some(first), Some(last)) = (times.first(), times.last()) {
        text += &format!(", from {} s to {} s", readable(*first, 9), readable(*last, 9));
    }
    text += "\n";
    text += &match period {
        Some(Period { seconds, crossings }) => {
            format!("{:<12} {} s, {crossings} crossing(s) each\n", "period", readable(seconds, 12))
        }
        None if times.len() < LEAST_STATES => format!("{:<12} not known: that takes {LEAST_STATES} states\n", "period"),
        None => format!("{:<12} none: the states do not repeat from the first on\n", "period"),
    };
    text
}
