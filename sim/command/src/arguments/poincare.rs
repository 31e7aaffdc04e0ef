//! The arguments of `poincare`.

use super::common::{StartArguments, WrittenArguments};
use clap::{Args, ValueEnum};
use sim_runtime::Crossing;
use std::path::PathBuf;

/// The arguments of `poincare`.
#[derive(Args)]
#[command(after_help = "Examples:\n  sim poincare pendulum --event bottom --direction rising --count 50\n  \
    sim poincare slider-crank --event dead_point --count 200\n\n\
    Files written to DIR:\n  trajectory.csv    the states of the section, a row for each crossing, with all outputs\n  \
    summary.json      crossings, period\n  section_NAME.svg  and .png: speed against position of each coordinate, a dot for each")]
pub(crate) struct PoincareArguments {
    #[command(flatten)]
    pub(crate) start: StartArguments,

    /// The event at which states are taken.
    #[arg(long, value_name = "EVENT")]
    pub(crate) event: String,

    /// The direction in which the event's condition, left - right, crosses zero.
    #[arg(long, value_enum, default_value_t = Direction::Both)]
    pub(crate) direction: Direction,

    /// How many states are taken.
    #[arg(long, value_name = "N", default_value_t = 200, value_parser = clap::value_parser!(u32).range(1..=10_000_000))]
    pub(crate) count: u32,

    /// The motion ends at this time at the latest.
    #[arg(long, value_name = "TIME", default_value = "1000", allow_hyphen_values = true)]
    pub(crate) t_end: String,

    /// Relative tolerance of DOP853.
    #[arg(long, value_name = "NUMBER", default_value_t = 1e-10)]
    pub(crate) rtol: f64,

    /// Where to write [default: out/MODEL-poincare].
    #[arg(long, value_name = "DIR")]
    pub(crate) out: Option<PathBuf>,

    #[command(flatten)]
    pub(crate) written: WrittenArguments,
}

/// Of the condition of an event.
#[derive(Clone, Copy, ValueEnum)]
pub(crate) enum Direction {
    Rising,
    Falling,
    Both,
}

impl Direction {
    pub(crate) fn crossing(self) -> Option<Crossing> {
        match self {
            Direction::Rising => Some(Crossing::Rising),
            Direction::Falling => Some(Crossing::Falling),
            Direction::Both => None,
        }
    }
}
