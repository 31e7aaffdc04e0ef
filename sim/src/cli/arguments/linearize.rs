//! What is linearised, and where.

use super::common::StartArguments;
use clap::Args;
use std::path::PathBuf;

/// What is linearised, and where.
#[derive(Args)]
#[command(
    after_help = "Examples:\n  sim linearize four-bar\n  sim linearize four-bar --input T\n  sim linearize cart-pole --initial phi=0\n  sim linearize double-pendulum --at 0.5\n\n\
    Steady motions: `--at initial`, with the speeds that are kept up declared or given, linearises about a motion that goes on as it \
    is, as a spinning top or a bicycle that rolls. Its coordinates must be such that the motion changes only those that nothing depends on, \
    at constant speeds: angles, of which the last turns about the axis of the spin, not a quaternion. Where they are not, it is \
    said, and the modes are those of an instant.\n\n\
    Files written to DIR:\n  linear.json   the state, A, B, C, D, eigenvalues and modes, in SI units\n  \
    linear.npz    numpy.load(\"linear.npz\")[\"A\"], and B, C, D"
)]
pub(in crate::cli) struct LinearizeArguments {
    #[command(flatten)]
    pub(in crate::cli) start: StartArguments,

    /// About which state: `equilibrium`, the one near the start; `initial`, the start, as for steady motions; or a time of the
    /// motion.
    #[arg(long, value_name = "PLACE|TIME", default_value = "equilibrium", allow_hyphen_values = true)]
    pub(in crate::cli) at: String,

    /// An input, or a parameter that stands for one, as a torque; may be repeated [default: all inputs].
    #[arg(long, value_name = "NAME")]
    pub(in crate::cli) input: Vec<String>,

    /// Where to write [default: out/MODEL-linear].
    #[arg(long, value_name = "DIR")]
    pub(in crate::cli) out: Option<PathBuf>,
}
