//! What can be said on the command line.

use super::settings::SettingsArguments;
use clap::{Args, Parser, Subcommand};
use std::path::PathBuf;

/// Runs mechanisms that were declared in the language, and shows their motion.
#[derive(Parser)]
#[command(
    version,
    arg_required_else_help = true,
    after_help = "Examples, for a mechanism that `list` shows as quick-return:\n  sim list\n  sim run quick-return\n  sim run quick-return --t-end 5 --set O2A=180mm\n  sim run quick-return --method rk4 --steps 8192\n  \
                  sim run quick-return --initial alpha=30deg --initial alpha_dot=60rpm --out out/slow\n\n\
                  Exit status: 0 done, 1 the run failed (what was computed is written), 2 the command line is wrong."
)]
pub(super) struct Arguments {
    #[command(subcommand)]
    pub(super) command: Command,
}

#[derive(Subcommand)]
pub(super) enum Command {
    /// Lists the mechanisms.
    List,
    /// Runs a mechanism and writes its motion, a summary and figures.
    Run(Box<RunArguments>),
    /// Compares a mechanism's kernels, equations and runs with independent ways to the same numbers.
    Verify(VerifyArguments),
    /// Assembles the start and prints it, with degrees of freedom and redundant constraints.
    Assemble(StartArguments),
    /// Finds the equilibrium near the start and the eigenvalues of small motions about it.
    Equilibrium(StartArguments),
}

/// How to run.
#[derive(Args)]
#[command(after_help = "Files written to DIR:\n  \
    trajectory.csv   time, coordinates, speeds, accelerations, multipliers and outputs; header cells `name [unit]`\n  \
    summary.json     model, parameters, method, events, period, residuals, energy balance\n  \
    timing.json      wall times; all other files are the same bytes run after run\n  \
    NAME.svg, .png   a figure for each group of outputs, and mechanism.svg, .png: the mechanism in several positions\n\n\
    A value may have a unit of the same dimension: 180mm, 0.18, \"180 mm\". Without one it is in the declared unit.")]
pub(super) struct RunArguments {
    /// The mechanism, as `list` names it.
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

    /// Where to write [default: out/MODEL].
    #[arg(long, value_name = "DIR")]
    pub(super) out: Option<PathBuf>,

    /// Writes no figures.
    #[arg(long)]
    pub(super) no_figures: bool,
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
