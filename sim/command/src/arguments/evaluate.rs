//! Arguments of `evaluate`.

use clap::Args;
use std::path::PathBuf;

/// The arguments of `evaluate`.
#[derive(Args)]
#[command(
    after_help = "Examples:\n  sim evaluate quick-return --kernel dynamics --at out/quick-return/trajectory.csv\n  \
    sim evaluate linkage.mech --kernel mass_matrix --at states.csv > masses.csv\n\n\
    Columns are named as those of a trajectory: `t`, `alpha`, `alpha_dot`, `alpha_ddot`, `lambda_slot`, in declared units or in that \
    of the heading, `alpha [deg]`. Entries of matrices are named `mass_matrix_1_2`, in SI units. Where \
    `dynamics` refuses a pivot of its planned elimination, the numbers are those of a run: by complete pivoting, and with \
    reactions of least norm where constraints are redundant. `refused` is 1, and numbers are left out, where a run \
    cannot be either, and where another kernel refuses a pivot."
)]
pub(crate) struct EvaluateArguments {
    /// The mechanism, as `list` names it, or a file that declares it: FILE or FILE:NAME.
    pub(crate) model: String,

    /// The kernel: dynamics, mass_matrix, constraint_jacobian, ..
    #[arg(long, value_name = "NAME")]
    pub(crate) kernel: String,

    /// The states, as CSV with a heading; `-` is standard input.
    #[arg(long, value_name = "FILE")]
    pub(crate) at: PathBuf,

    /// Sets a parameter, as in `--set O2A=180mm`; may be repeated.
    #[arg(long, value_name = "NAME=VALUE")]
    pub(crate) set: Vec<String>,

    /// Holds an input at a value, as in `--input torque=2`; may be repeated.
    #[arg(long, value_name = "NAME=VALUE", allow_hyphen_values = true)]
    pub(crate) input: Vec<String>,
}
