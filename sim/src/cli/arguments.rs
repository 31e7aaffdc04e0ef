//! What can be said on the command line.

use super::kinematics::KinematicsArguments;
use super::linearize::LinearizeArguments;
use super::poincare::PoincareArguments;
use super::settings::SettingsArguments;
use crate::Format;
use clap::{Args, Parser, Subcommand};
use std::path::PathBuf;

/// Runs mechanisms that were declared in the language, and shows their motion.
#[derive(Parser)]
#[command(
    version,
    arg_required_else_help = true,
    after_help = "Examples, for a mechanism that `list` shows as quick-return:\n  sim list\n  sim run quick-return\n  sim run quick-return --t-end 5 --set O2A=180mm\n  sim run quick-return --method rk4 --steps 8192\n  \
                  sim run quick-return --initial alpha=30deg --initial alpha_dot=60rpm --out out/slow\n  \
                  sim run out/slow/run.json --t-end 10\n  sim new my-linkage\n\n\
                  Exit status: 0 done, 1 the work failed (what was computed is written), 2 the command line is wrong, 130 interrupted\n  \
                  by SIGINT (Ctrl-C) or SIGTERM: a run then writes what it has, and a second one ends it at once."
)]
pub(super) struct Arguments {
    #[command(flatten)]
    pub(super) voice: Voice,

    #[command(subcommand)]
    pub(super) command: Command,
}

/// How much is said, and to whom.
#[derive(Args, Clone, Copy)]
pub(super) struct Voice {
    /// Prints JSON, for programs.
    #[arg(long, global = true, conflicts_with = "quiet")]
    pub(super) json: bool,

    /// Prints nothing but errors.
    #[arg(long, short, global = true)]
    pub(super) quiet: bool,
}

#[derive(Subcommand)]
pub(super) enum Command {
    /// Lists the mechanisms.
    List,
    /// Shows what a mechanism has: coordinates, parameters, constraints, outputs, sizes.
    Info(InfoArguments),
    /// Runs a mechanism and writes its motion, a summary and figures.
    Run(Box<RunArguments>),
    /// Compares a mechanism's kernels, equations and runs with independent ways to the same numbers.
    Verify(VerifyArguments),
    /// Assembles the start and prints it, with degrees of freedom and redundant constraints.
    Assemble(AssembleArguments),
    /// Finds the equilibrium near the start and the eigenvalues of small motions about it.
    Equilibrium(StartArguments),
    /// Drives a mechanism through a range: positions, velocities, reactions, driving torque, strokes, limit positions.
    Kinematics(Box<KinematicsArguments>),
    /// Linearises a mechanism about a state: matrices for a controller, eigenvalues, modes.
    Linearize(LinearizeArguments),
    /// Takes the states of a motion each time an event happens, and finds its period.
    Poincare(Box<PoincareArguments>),
    /// Draws quantities of a run over time, or against another.
    Plot(PlotArguments),
    /// Draws the same quantities of several runs in one figure each.
    Compare(CompareArguments),
    /// Makes a crate with a mechanism of your own.
    New(NewArguments),
    /// Prints what installs with a program: shell completions, the man page, the schema of run files.
    Generate(GenerateArguments),
}

/// Which mechanism.
#[derive(Args)]
pub(super) struct InfoArguments {
    /// The mechanism, as `list` names it.
    pub(super) model: String,
}

/// What to draw of a run.
#[derive(Args)]
#[command(
    after_help = "Examples:\n  sim plot out/quick-return x6 x6_velocity\n  sim plot out/quick-return alpha_dot --against alpha\n\n\
    Quantities are the columns of trajectory.csv. Those of one unit share axes; others are stacked over one time axis."
)]
pub(super) struct PlotArguments {
    /// The directory of a run, or its trajectory.csv.
    pub(super) run: PathBuf,

    /// The quantities, as columns of the table are called.
    #[arg(required = true, value_name = "NAME")]
    pub(super) quantities: Vec<String>,

    /// The quantity along the abscissa, instead of time.
    #[arg(long, value_name = "NAME", default_value = "t")]
    pub(super) against: String,

    /// The file to write, without its extension [default: DIR/plot-NAMES].
    #[arg(long, value_name = "PATH")]
    pub(super) out: Option<PathBuf>,

    /// The title.
    #[arg(long, default_value = "")]
    pub(super) title: String,

    /// Width and height of figures in pixels of SVG; PNG has twice as many.
    #[arg(long, value_name = "WxH", default_value = "960x540")]
    pub(super) size: Size,
}

/// What to compare.
#[derive(Args)]
#[command(
    after_help = "Example:\n  sim compare out/quick-return out/shorter-crank --quantity x6 --out out/compared\n\n\
    Curves are called after their directories."
)]
pub(super) struct CompareArguments {
    /// The directories of runs, or their trajectory.csv.
    #[arg(required = true, num_args = 2.., value_name = "RUN")]
    pub(super) runs: Vec<PathBuf>,

    /// A quantity to draw, as a column of the tables is called; may be repeated [default: all they share but
    /// accelerations].
    #[arg(long, value_name = "NAME")]
    pub(super) quantity: Vec<String>,

    /// Where to write.
    #[arg(long, value_name = "DIR", default_value = "out/compare")]
    pub(super) out: PathBuf,

    /// Width and height of figures in pixels of SVG; PNG has twice as many.
    #[arg(long, value_name = "WxH", default_value = "960x540")]
    pub(super) size: Size,
}

/// What to make.
#[derive(Args)]
pub(super) struct NewArguments {
    /// The directory to make; its last part is the crate's name.
    pub(super) path: PathBuf,

    /// Where Linkwright is: a folder with its workspace, or the address of its git repository [default: where this
    /// program was built].
    #[arg(long, value_name = "PATH|URL")]
    pub(super) linkwright: Option<String>,
}

/// What to print.
#[derive(Args)]
pub(super) struct GenerateArguments {
    /// Which of them.
    #[command(subcommand)]
    pub(super) what: Generated,
}

/// What can be printed.
#[derive(Subcommand)]
pub(super) enum Generated {
    /// Completions for a shell.
    Completions {
        /// The shell.
        shell: clap_complete::Shell,
    },
    /// The man page, in roff.
    Man,
    /// The JSON schema of run files.
    Schema,
}

/// Width and height, in logical pixels.
#[derive(Clone, Copy, Debug)]
pub(super) struct Size(pub(super) f64, pub(super) f64);

impl Size {
    /// For figures.
    pub(super) fn show(self) -> crate::show::Size {
        crate::show::Size { width: self.0, height: self.1 }
    }
}

impl std::str::FromStr for Size {
    type Err = String;

    fn from_str(text: &str) -> Result<Size, String> {
        let side = |text: &str| text.parse().ok().filter(|side| (240.0..=8000.0).contains(side));
        let sides = text.split_once('x').and_then(|(width, height)| Some(Size(side(width)?, side(height)?)));
        sides.ok_or_else(|| "width and height from 240 to 8000 are needed, as in 960x540".to_owned())
    }
}

impl std::fmt::Display for Size {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{}x{}", self.0, self.1)
    }
}

/// How to run.
#[derive(Args)]
#[command(
    args_override_self = true,
    after_help = "Files written to DIR:\n  \
    report.html      the mechanism in motion, plots, tables and equations; opens in any browser, without network\n  \
    trajectory.csv   time, coordinates, speeds, accelerations, multipliers, work done and outputs; headers `name [unit]`\n  \
    run.json         the run file, which makes this run again: `sim run DIR/run.json`\n  \
    summary.json     model, parameters, method, events, period, residuals, energy balance\n  \
    timing.json      wall times; all other files are the same bytes run after run\n  \
    NAME.svg, .png   a figure for each group of outputs, and mechanism.svg, .png: the mechanism in several positions\n\n\
    A value may have a unit of the same dimension: 180mm, 0.18, \"180 mm\". Without one it is in the declared unit."
)]
pub(super) struct RunArguments {
    /// The mechanism, as `list` names it; or a run file, NAME.json, which other words of the command line override.
    #[arg(value_name = "MODEL|FILE.json")]
    pub(super) model: String,

    #[command(flatten)]
    pub(super) settings: SettingsArguments,

    /// Sets a parameter, as in `--set O2A=180mm`; may be repeated.
    #[arg(long, value_name = "NAME=VALUE")]
    pub(super) set: Vec<String>,

    /// Sets a start value, as in `--initial alpha=30deg` or `--initial alpha_dot=75rpm`; may be repeated. A coordinate
    /// that is declared as a guess stays one.
    #[arg(long, value_name = "NAME=VALUE", allow_hyphen_values = true)]
    pub(super) initial: Vec<String>,

    /// Holds an input at a value instead of its declared course, as in `--input tau=0.5`; may be repeated.
    #[arg(long, value_name = "NAME=VALUE")]
    pub(super) input: Vec<String>,

    /// Where to write [default: out/MODEL].
    #[arg(long, value_name = "DIR")]
    pub(super) out: Option<PathBuf>,

    #[command(flatten)]
    pub(super) written: WrittenArguments,

    /// Writes no report.
    #[arg(long)]
    pub(super) no_report: bool,
}

/// Which files are written, and how large figures are.
#[derive(Args)]
pub(super) struct WrittenArguments {
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

pub(super) fn format(name: &str) -> Result<Format, String> {
    let names = || Format::ALL.iter().map(|format| format.name());
    let found = Format::ALL.iter().copied().find(|format| format.name() == name);
    found.ok_or_else(|| match name {
        "parquet" => "this program was built without the feature `parquet`".to_owned(),
        _ => format!("known are {}", names().collect::<Vec<_>>().join(", ")),
    })
}

/// What to verify.
#[derive(Args)]
#[command(
    after_help = "One row for each check: how far two ways to the same numbers are apart, how far they may be, and \
    the verdict. Exit status 1 if a check fails."
)]
pub(super) struct VerifyArguments {
    /// The mechanism, as `list` names it.
    pub(super) model: String,

    /// Verifies the motion until then, or for as long as 150 steps of DOP853 take.
    #[arg(long, value_name = "TIME", default_value = "2", allow_hyphen_values = true)]
    pub(super) t_end: String,

    /// Sets a parameter, as in `--set O2A=180mm`; may be repeated.
    #[arg(long, value_name = "NAME=VALUE")]
    pub(super) set: Vec<String>,

    /// Sets a start value, as in `--initial alpha=30deg`; may be repeated.
    #[arg(long, value_name = "NAME=VALUE", allow_hyphen_values = true)]
    pub(super) initial: Vec<String>,
}

/// What to assemble.
#[derive(Args)]
pub(super) struct AssembleArguments {
    #[command(flatten)]
    pub(super) start: StartArguments,

    /// Lists the loops that close in closed form, and all configurations that have what the start gives: elbow up and elbow
    /// down.
    #[arg(long)]
    pub(super) branches: bool,
}

/// A mechanism and its start.
#[derive(Args)]
pub(super) struct StartArguments {
    /// The mechanism, as `list` names it.
    pub(super) model: String,

    /// Sets a parameter, as in `--set O2A=180mm`; may be repeated.
    #[arg(long, value_name = "NAME=VALUE")]
    pub(super) set: Vec<String>,

    /// Sets a start value, as in `--initial alpha=30deg`; may be repeated.
    #[arg(long, value_name = "NAME=VALUE", allow_hyphen_values = true)]
    pub(super) initial: Vec<String>,
}
