//! `sim poincare`.

use super::arguments::{Size, StartArguments, Voice, format};
use super::files::Files;
use super::run::{mechanism_with, start_with};
use super::settings::positive;
use super::{Stop, print, progress, unknown};
use crate::show;
use crate::{Crossing, Format, Method, Section, Sectioning, Settings, Table, What, poincare, write_json};
use clap::{Args, ValueEnum};
use serde_json::{Value, json};
use sim_kernel::Mechanism;
use std::path::PathBuf;

/// Which section of which motion.
#[derive(Args)]
#[command(after_help = "Examples:\n  sim poincare pendulum --event bottom --direction rising --count 50\n  \
    sim poincare slider-crank --event dead_point --count 200\n\n\
    Files written to DIR:\n  trajectory.csv    the states of the section, a row for each crossing, with all outputs\n  \
    summary.json      crossings, period\n  section_NAME.svg  and .png: speed against position of each coordinate, a dot for each")]
pub(super) struct PoincareArguments {
    #[command(flatten)]
    pub(super) start: StartArguments,

    /// The event at which states are taken.
    #[arg(long, value_name = "EVENT")]
    event: String,

    /// In which direction the event's condition, left - right, has to cross zero.
    #[arg(long, value_enum, default_value_t = Direction::Both)]
    direction: Direction,

    /// How many states are taken.
    #[arg(long, value_name = "N", default_value_t = 200, value_parser = clap::value_parser!(u32).range(1..=10_000_000))]
    count: u32,

    /// The motion ends then if the event has not happened so often.
    #[arg(long, value_name = "TIME", default_value = "1000", allow_hyphen_values = true)]
    t_end: String,

    /// Relative tolerance of DOP853.
    #[arg(long, value_name = "NUMBER", default_value_t = 1e-10)]
    rtol: f64,

    /// Where to write [default: out/MODEL-poincare].
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,

    /// Formats of the table, of csv, jsonl, npy, npz and, where built with it, parquet.
    #[arg(long, value_name = "FORMAT", value_delimiter = ',', default_value = "csv", value_parser = format)]
    format: Vec<Format>,

    /// Width and height of figures in pixels of SVG; PNG has twice as many.
    #[arg(long, value_name = "WxH", default_value = "960x540")]
    size: Size,

    /// Writes no figures.
    #[arg(long)]
    no_figures: bool,
}

#[derive(Clone, Copy, ValueEnum)]
enum Direction {
    Rising,
    Falling,
    Both,
}

impl Direction {
    fn crossing(self) -> Option<Crossing> {
        match self {
            Direction::Rising => Some(Crossing::Rising),
            Direction::Falling => Some(Crossing::Falling),
            Direction::Both => None,
        }
    }
}

/// Takes a section of a motion, writes it and prints its period.
pub(super) fn poincare_command<M: Mechanism>(arguments: &PoincareArguments, voice: Voice) -> Result<(), Stop> {
    let description = const { &M::DESCRIPTION };
    let mechanism = mechanism_with::<M>(description, &arguments.start.set)?;
    let start = start_with(&mechanism, description, &arguments.start.initial)?;
    let events = || description.events.iter().map(|event| event.name);
    let event = events().position(|name| name == arguments.event);
    let event = event.ok_or_else(|| unknown("event", &arguments.event, events()))?;
    if !(1e-14..=0.1).contains(&arguments.rtol) {
        return Err(Stop::Usage("--rtol from 1e-14 to 0.1 is possible; numbers here have 16 digits".into()));
    }
    let section = Sectioning { event, crossing: arguments.direction.crossing(), count: arguments.count as usize };
    let end = positive("--t-end", &arguments.t_end)?;
    let settings = Settings::adaptive(Method::Dop853, end, arguments.rtol);
    let directory = arguments.out.clone().unwrap_or_else(|| format!("out/{}-poincare", description.name).into());
    let mut files = Files::new(description, &directory, &["mechanism"])?;
    let found = progress::watched(&settings, voice, |settings| poincare(mechanism, &start, &section, settings))?;
    write(&found, arguments, &mut files);
    let said = summary(&found, arguments);
    match voice {
        Voice { quiet: true, .. } => {}
        Voice { json: true, .. } => print(&format!("{said:#}\n"))?,
        _ => print(&format!(
            "{}written      {}: {}\n",
            report(&found, arguments),
            directory.display(),
            files.names.join(", ")
        ))?,
    }
    let problems = match &found.trajectory.failure {
        Some(failure) => vec![failure.to_string()],
        None if found.trajectory.samples.is_empty() => vec![format!(
            "event `{}` has not happened in {end} s{}. Give a longer --t-end, or another event",
            arguments.event,
            if section.crossing.is_some() { " in this direction" } else { "" }
        )],
        None => Vec::new(),
    };
    let is_interrupted = found.trajectory.failure.is_some_and(|failure| failure.what == What::Interrupted);
    files.check(problems, is_interrupted)
}

fn write<M: Mechanism>(found: &Section<M>, arguments: &PoincareArguments, files: &mut Files) {
    files.add_table(&Table::of(&found.mechanism, &found.trajectory), &arguments.format);
    files.add("summary.json", |path| write_json(&summary(found, arguments), path));
    if !arguments.no_figures && !found.trajectory.samples.is_empty() {
        files.add_figures(&show::section_figures(found, files.directory(), arguments.size.show()));
    }
}

fn summary<M: Mechanism>(found: &Section<M>, arguments: &PoincareArguments) -> Value {
    let times = found.trajectory.samples.iter().map(|sample| sample.state.time);
    json!({
        "model": M::DESCRIPTION.name,
        "event": arguments.event,
        "crossings": found.trajectory.samples.len(),
        "asked": arguments.count,
        "period": found.period.map(|period| json!({ "seconds": period.seconds, "crossings": period.crossings })),
        "times": times.collect::<Vec<_>>(),
        "failure": found.trajectory.failure.as_ref().map(ToString::to_string),
    })
}

fn report<M: Mechanism>(found: &Section<M>, arguments: &PoincareArguments) -> String {
    let samples = &found.trajectory.samples;
    let mut text = format!("{:<12} {}\n", "model", M::DESCRIPTION.name);
    text += &format!("{:<12} {} states at `{}`", "section", samples.len(), arguments.event);
    if let (Some(first), Some(last)) = (samples.first(), samples.last()) {
        text += &format!(", from {:.9} s to {:.9} s", first.state.time, last.state.time);
    }
    text += "\n";
    text += &match found.period {
        Some(period) => format!("{:<12} {:.12} s, {} crossing(s) each\n", "period", period.seconds, period.crossings),
        None => format!("{:<12} none: no state comes again\n", "period"),
    };
    text
}
