//! What is driven, from the command line.

use crate::cli::arguments::{Size, format};
use crate::cli::quantity::parse_quantity;
use crate::cli::{Stop, unknown};
use crate::kinematics::quotient;
use crate::{Driven, Format, Start, Sweep};
use clap::Args;
use sim_kernel::{Mechanism, Quantity};
use std::path::PathBuf;

/// What is driven, and how.
#[derive(Args)]
#[command(
    after_help = "Examples:\n  sim kinematics quick-return --drive alpha --from 0 --to 360deg --speed 75rpm --steps 720\n  \
    sim kinematics four-bar\n  sim kinematics slider-crank --drive x --from 0.5 --to 0.4 --speed 0.1\n\n\
    Files written to DIR:\n  trajectory.csv   as of a run, and drive_NAME, transmission_index, ratio_OUTPUT, advantage_OUTPUT\n  \
    summary.json     strokes, time ratios, peaks, limit positions, and where they are\n  \
    NAME.svg, .png   a figure for each group of outputs against what is driven; drive, transmission, ratios, mechanism"
)]
pub(in crate::cli) struct KinematicsArguments {
    /// The mechanism, as `list` names it.
    model: String,

    /// What is driven: a coordinate, or an output that is a function of positions [default: the first coordinate that is
    /// given at the start].
    #[arg(long, value_name = "NAME")]
    drive: Option<String>,

    /// Where the sweep begins [default: where the mechanism starts].
    #[arg(long, value_name = "VALUE", allow_hyphen_values = true)]
    from: Option<String>,

    /// Where it ends [default: one turn further, if it is an angle].
    #[arg(long, value_name = "VALUE", allow_hyphen_values = true)]
    to: Option<String>,

    /// How fast it is driven [default: its speed at the start].
    #[arg(long, value_name = "VALUE", allow_hyphen_values = true)]
    speed: Option<String>,

    /// Records N + 1 positions at equal intervals.
    #[arg(long, value_name = "N", default_value_t = 720, value_parser = clap::value_parser!(u32).range(1..=10_000_000))]
    steps: u32,

    /// Holds a further degree of freedom where it is or at a value, as in `--hold phi2` or `--hold phi2=30deg`; may be
    /// repeated.
    #[arg(long, value_name = "NAME[=VALUE]", allow_hyphen_values = true)]
    hold: Vec<String>,

    /// Sets a parameter, as in `--set O2A=180mm`; may be repeated.
    #[arg(long, value_name = "NAME=VALUE")]
    pub(super) set: Vec<String>,

    /// Sets a start value, as in `--initial alpha=30deg`; may be repeated. What is given here, or guessed, decides on which
    /// branch the mechanism is assembled.
    #[arg(long, value_name = "NAME=VALUE", allow_hyphen_values = true)]
    pub(super) initial: Vec<String>,

    /// Where to write [default: out/MODEL-kinematics].
    #[arg(long, value_name = "DIR")]
    pub(super) out: Option<PathBuf>,

    /// Formats of the table, of csv, jsonl, npy, npz and, where built with it, parquet.
    #[arg(long, value_name = "FORMAT", value_delimiter = ',', default_value = "csv", value_parser = format)]
    pub(super) format: Vec<Format>,

    /// Width and height of figures in pixels of SVG; PNG has twice as many.
    #[arg(long, value_name = "WxH", default_value = "960x540")]
    pub(super) size: Size,

    /// Writes no figures.
    #[arg(long)]
    pub(super) no_figures: bool,
}

impl KinematicsArguments {
    pub(in crate::cli) fn model(&self) -> &str {
        &self.model
    }

    /// The sweep that they ask for.
    pub(super) fn sweep<M: Mechanism>(&self, mechanism: &M, start: &Start<M>) -> Result<Sweep, Stop> {
        let driven = match &self.drive {
            Some(name) => find::<M>(name)?,
            None => default_drive::<M>()?,
        };
        let (quantity, now) = (driven.quantity::<M>(), || driven.value(mechanism, 0.0, &start.positions));
        let value = |option: &str, text: &str| parse_quantity(option, text, quantity.unit);
        let from = match (&self.from, driven) {
            (Some(text), _) => value("--from", text)?,
            (None, Driven::Coordinate(_)) => now(),
            (None, Driven::Output(_)) => return Err(needed("--from", quantity)),
        };
        let to = match (&self.to, driven.turn::<M>()) {
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
        let speed = self.speed::<M>(driven, start)?;
        let held = self.hold.iter().map(|text| hold(mechanism, start, text)).collect::<Result<_, _>>()?;
        Ok(Sweep { driven, from, to, speed, steps: self.steps as usize, held })
    }

    fn speed<M: Mechanism>(&self, driven: Driven, start: &Start<M>) -> Result<f64, Stop> {
        let name = driven.quantity::<M>().name;
        let speed = match (&self.speed, driven) {
            (Some(text), Driven::Coordinate(i)) => {
                parse_quantity("--speed", text, M::DESCRIPTION.coordinates[i].speed.unit)?
            }
            (Some(text), Driven::Output(_)) => {
                parse_quantity("--speed", text, &quotient(driven.quantity::<M>(), &SECOND))?
            }
            (None, Driven::Coordinate(i)) if start.speed_given[i] => start.speeds[i],
            (None, _) => return Err(Stop::Usage(format!("the start gives `{name}` no speed: give one with --speed"))),
        };
        match speed == 0.0 {
            true => Err(Stop::Usage(format!("`{name}` has to move: give it a speed other than 0 with --speed"))),
            false => Ok(speed),
        }
    }
}

const SECOND: Quantity = Quantity { name: "t", unit: "s", factor: 1.0, docs: "" };

fn needed(option: &str, quantity: &Quantity) -> Stop {
    Stop::Usage(format!("{option} is needed for `{}`, as in `{option} 0.1{}`", quantity.name, quantity.unit))
}

fn find<M: Mechanism>(name: &str) -> Result<Driven, Stop> {
    let description = const { &M::DESCRIPTION };
    let coordinates = description.coordinates.iter().map(|c| c.position.name);
    let known = coordinates.chain(description.outputs.iter().map(|o| o.name));
    Driven::find::<M>(name).ok_or_else(|| unknown("coordinate or output", name, known))
}

/// The first coordinate that the declaration gives a value, not a guess.
fn default_drive<M: Mechanism>() -> Result<Driven, Stop> {
    let mut coordinates = M::DESCRIPTION.coordinates.iter();
    let given = coordinates.position(|c| c.start == sim_kernel::Start::Given).map(Driven::Coordinate);
    given.ok_or_else(|| Stop::Usage("say what is driven, as in `--drive alpha`".into()))
}

fn hold<M: Mechanism>(mechanism: &M, start: &Start<M>, text: &str) -> Result<(Driven, f64), Stop> {
    let (name, value) = text.split_once('=').map_or((text, None), |(name, value)| (name.trim(), Some(value.trim())));
    let driven = find::<M>(name)?;
    let value = match value {
        Some(value) => parse_quantity(name, value, driven.quantity::<M>().unit)?,
        None => driven.value(mechanism, 0.0, &start.positions),
    };
    Ok((driven, value))
}
