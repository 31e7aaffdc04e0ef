//! The command line's arguments.

mod common;
mod evaluate;
mod import;
mod kinematics;
mod linearize;
mod poincare;
mod run;
mod watch;

use clap::{Args, Parser, Subcommand};
use common::Size;
pub(super) use common::{StartArguments, Voice, WrittenArguments};
pub(super) use evaluate::EvaluateArguments;
pub(super) use import::ImportArguments;
pub(super) use kinematics::KinematicsArguments;
pub(super) use linearize::LinearizeArguments;
pub(super) use poincare::PoincareArguments;
pub(super) use run::RunArguments;
use sim_runtime::{COMMIT, VERSION};
use std::path::PathBuf;
pub(super) use watch::WatchArguments;

/// Runs mechanisms that were declared in the language, and shows their motion.
#[derive(Parser)]
#[command(
    version = format!("{VERSION} (commit {COMMIT})"),
    arg_required_else_help = true,
    after_help = "Examples, for a mechanism that `list` shows as quick-return:\n  sim list\n  sim run quick-return\n  sim run quick-return --t-end 5 --set O2A=180mm\n  sim run quick-return --method rk4 --steps 8192\n  \
                  sim run quick-return --initial alpha=30deg --initial alpha_dot=60rpm --out out/slow\n  \
                  sim run out/slow/run.json --t-end 10\n  sim new my-linkage\n\n\
                  Exit status: 0 done, 1 the work failed (what was computed is written), 2 the command line is wrong, 130 interrupted\n  \
                  by SIGINT (Ctrl-C) or SIGTERM: a run then writes what it has, and draws what takes less than a second."
)]
pub(super) struct Arguments {
    #[command(flatten)]
    pub(super) voice: Voice,

    #[command(subcommand)]
    pub(super) command: Command,
}

#[derive(Subcommand)]
pub(super) enum Command {
    /// Lists the mechanisms.
    List,
    /// Shows what a mechanism has: coordinates, parameters, constraints, outputs, sizes.
    Info(InfoArguments),
    /// Runs a mechanism and writes its motion, a summary and figures.
    Run(Box<RunArguments>),
    /// Shows a file's mechanism in the browser, and follows what is saved.
    Watch(Box<WatchArguments>),
    /// Compares a mechanism's kernels, equations and runs with independent computations.
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
    /// Computes a kernel at given states, as CSV on standard output.
    Evaluate(EvaluateArguments),
    /// Shows the mistakes of a file that declares mechanisms.
    Check(CheckArguments),
    /// Writes the declaration of a robot that stands in a URDF file.
    Import(ImportArguments),
    /// Draws quantities of a run over time, or against another.
    Plot(PlotArguments),
    /// Draws the same quantities of several runs in one figure each.
    Compare(CompareArguments),
    /// Makes a file or a crate with a mechanism of your own.
    New(NewArguments),
    /// Prints files to install with a program: shell completions, the man page, the schema of run files.
    Generate(GenerateArguments),
}

/// Which mechanism.
#[derive(Args)]
pub(super) struct InfoArguments {
    /// The mechanism, as `list` names it, or a file that declares it: FILE or FILE:NAME.
    pub(super) model: String,
}

/// The arguments of `plot`.
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

    /// The quantity along the abscissa, instead of time; lengths against a length are drawn to one scale, as a path.
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

/// The arguments of `compare`.
#[derive(Args)]
#[command(
    after_help = "Example:\n  sim compare out/quick-return out/shorter-crank --quantity x6 --out out/compared\n\n\
    Curves are named after their directories."
)]
pub(super) struct CompareArguments {
    /// The directories of runs, or their trajectory.csv.
    #[arg(required = true, num_args = 2.., value_name = "RUN")]
    pub(super) runs: Vec<PathBuf>,

    /// A quantity to draw, as a column of the tables is called; may be repeated [default: all that they share except
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

/// The arguments of `new`.
#[derive(Args)]
pub(super) struct NewArguments {
    /// The directory to make, whose last part is the crate's name; with `--file` the file.
    pub(super) path: PathBuf,

    /// Writes a declaration alone, as in `new --file linkage.mech`: it is run without a compiler.
    #[arg(long, conflicts_with = "linkwright")]
    pub(super) file: bool,

    /// A mechanism that `list` shows, to begin with.
    #[arg(long, value_name = "MODEL", requires = "file")]
    pub(super) from: Option<String>,

    /// Where Linkwright is: a folder with its workspace, or the address of its git repository [default: where this
    /// program was built].
    #[arg(long, value_name = "PATH|URL")]
    pub(super) linkwright: Option<String>,
}

/// The arguments of `generate`.
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

/// The arguments of `check`.
#[derive(Args)]
#[command(after_help = "Examples:\n  sim check linkage.mech\n  sim check src/lib.rs --json\n\n\
    Exit status 1 if there are mistakes. As JSON each has its code, message, suggestion and range: lines, columns in UTF-16 and \
    in bytes, all from 0.")]
pub(super) struct CheckArguments {
    /// The file: a declaration by itself, or Rust with `mechanism! { .. }` in it.
    pub(super) file: PathBuf,
}

/// The arguments of `verify`.
#[derive(Args)]
#[command(after_help = "One row for each check: the difference between two independent computations, its bound, and \
    the verdict. Exit status 1 if a check fails.")]
pub(super) struct VerifyArguments {
    /// The mechanism, as `list` names it, or a file that declares it: FILE or FILE:NAME.
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

/// The arguments of `assemble`.
#[derive(Args)]
pub(super) struct AssembleArguments {
    #[command(flatten)]
    pub(super) start: StartArguments,

    /// Lists the loops that close in closed form, and all configurations that satisfy the given start values: elbow up and elbow
    /// down.
    #[arg(long)]
    pub(super) branches: bool,
}
