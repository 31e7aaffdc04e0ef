//! The drive of a sweep.

use super::common::WrittenArguments;
use clap::Args;
use std::path::PathBuf;

/// The drive of a sweep.
#[derive(Args)]
#[command(
    after_help = "Examples:\n  sim kinematics quick-return --drive alpha --from 0 --to 360deg --speed 75rpm --steps 720\n  \
    sim kinematics four-bar\n  sim kinematics slider-crank --drive x --from 0.5 --to 0.4 --speed 0.1\n\n\
    Files written to DIR:\n  trajectory.csv   as of a run, and drive_NAME, transmission_index, ratio_OUTPUT, advantage_OUTPUT\n  \
    summary.json     strokes, time ratios, peaks, limit positions, and where they are\n  \
    report.html      mechanism, plots against what is driven, tables and equations, for any browser\n  \
    NAME.svg, .png   a figure for each group of outputs against what is driven; drive, transmission, ratios, mechanism"
)]
pub(crate) struct KinematicsArguments {
    /// The mechanism, as `list` names it, or a file that declares it: FILE or FILE:NAME.
    pub(crate) model: String,

    /// What is driven: a coordinate, or an output that is a function of positions [default: the coordinate that a constraint
    /// prescribes, or the first that is given at the start].
    #[arg(long, value_name = "NAME")]
    pub(crate) drive: Option<String>,

    /// Where the sweep begins [default: where the mechanism starts].
    #[arg(long, value_name = "VALUE", allow_hyphen_values = true)]
    pub(crate) from: Option<String>,

    /// Where it ends [default: one turn further, if it is an angle, or one turn back if its speed is negative].
    #[arg(long, value_name = "VALUE", allow_hyphen_values = true)]
    pub(crate) to: Option<String>,

    /// How fast it is driven; with 0 it rests in each position, while time stands still at 0, and forces are static [default:
    /// its speed at the start, in the direction of the sweep, or 0 if that gives none].
    #[arg(long, value_name = "VALUE", allow_hyphen_values = true)]
    pub(crate) speed: Option<String>,

    /// Records N + 1 positions at equal intervals.
    #[arg(long, value_name = "N", default_value_t = 720, value_parser = clap::value_parser!(u32).range(1..=10_000_000))]
    pub(crate) steps: u32,

    /// Holds a further degree of freedom where it is or at a value, as in `--hold phi2` or `--hold phi2=30deg`; may be
    /// repeated.
    #[arg(long, value_name = "NAME[=VALUE]", allow_hyphen_values = true)]
    pub(crate) hold: Vec<String>,

    /// Sets a parameter, as in `--set O2A=180mm`; may be repeated.
    #[arg(long, value_name = "NAME=VALUE")]
    pub(crate) set: Vec<String>,

    /// Sets a start value, as in `--initial alpha=30deg`; may be repeated. Given values and guesses decide on which
    /// branch the mechanism is assembled.
    #[arg(long, value_name = "NAME=VALUE", allow_hyphen_values = true)]
    pub(crate) initial: Vec<String>,

    /// Where to write [default: out/MODEL-kinematics].
    #[arg(long, value_name = "DIR")]
    pub(crate) out: Option<PathBuf>,

    /// Writes no report.
    #[arg(long)]
    pub(crate) no_report: bool,

    #[command(flatten)]
    pub(crate) written: WrittenArguments,
}
