//! The arguments of `run`.

use super::common::WrittenArguments;
use crate::settings::SettingsArguments;
use clap::Args;
use std::path::PathBuf;

/// The arguments of `run`.
#[derive(Args)]
#[command(
    args_override_self = true,
    after_help = "Files written to DIR:\n  \
    report.html      the mechanism in motion, plots, tables and equations; opens in any browser, without network\n  \
    trajectory.csv   time, coordinates, speeds, accelerations, multipliers, work done and outputs; headers `name [unit]`\n  \
    run.json         the run file, which makes this run again: `sim run DIR/run.json`\n  \
    summary.json     model, parameters, method, events, period, residuals, energy balance; where all files come from\n  \
    timing.json      wall times; all other files are the same bytes run after run\n  \
    NAME.svg, .png   a figure for each group of outputs, and mechanism.svg, .png: the mechanism in several positions\n\n\
    A value may have a unit of the same dimension: 180mm, 0.18, \"180 mm\". Without one it is in the declared unit."
)]
pub(crate) struct RunArguments {
    /// The mechanism, as `list` names it, or a file that declares it, FILE or FILE:NAME; or a run file, NAME.json, which other
    /// arguments override.
    #[arg(value_name = "MODEL|FILE")]
    pub(crate) model: String,

    #[command(flatten)]
    pub(crate) settings: SettingsArguments,

    /// Sets a parameter, as in `--set O2A=180mm`; may be repeated.
    #[arg(long, value_name = "NAME=VALUE")]
    pub(crate) set: Vec<String>,

    /// Sets a start value, as in `--initial alpha=30deg` or `--initial alpha_dot=75rpm`; may be repeated. A coordinate
    /// that is declared as a guess stays one.
    #[arg(long, value_name = "NAME=VALUE", allow_hyphen_values = true)]
    pub(crate) initial: Vec<String>,

    /// Holds an input at a value instead of its declared course, as in `--input tau=0.5`; may be repeated.
    #[arg(long, value_name = "NAME=VALUE")]
    pub(crate) input: Vec<String>,

    /// Where to write [default: out/MODEL].
    #[arg(long, value_name = "DIR")]
    pub(crate) out: Option<PathBuf>,

    #[command(flatten)]
    pub(crate) written: WrittenArguments,

    /// Writes no report.
    #[arg(long)]
    pub(crate) no_report: bool,

    /// Does not compare the run with one of a smaller tolerance, which tells where errors have grown and may take four times as long
    /// as the run itself.
    #[arg(long)]
    pub(crate) no_comparison: bool,
}
