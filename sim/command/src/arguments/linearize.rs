//! The subject and the place of a linearisation.

use super::common::StartArguments;
use clap::Args;
use std::path::PathBuf;

/// The subject and the place of a linearisation.
#[derive(Args)]
#[command(
    after_help = "Examples:\n  sim linearize four-bar\n  sim linearize four-bar --input T\n  sim linearize cart-pole --initial phi=0\n  sim linearize double-pendulum --at 0.5\n\n\
    Steady motions: `--at initial`, with the steady speeds declared or given, linearises about a steady motion, \
    such as a spinning top or a rolling bicycle. The motion must change only coordinates that nothing depends on, \
    at constant speeds: use angles, the last about the axis of the spin, not a quaternion. If it does not, the output says so, \
    and the modes hold for one instant only.\n\n\
    Files written to DIR:\n  linear.json   the state, A, B, C, D, eigenvalues and modes, in SI units\n  \
    linear.npz    numpy.load(\"linear.npz\")[\"A\"], and B, C, D"
)]
pub(crate) struct LinearizeArguments {
    #[command(flatten)]
    pub(crate) start: StartArguments,

    /// The state: `equilibrium`, the one near the start; `initial`, the start, as for steady motions; or a time of the
    /// motion.
    #[arg(long, value_name = "PLACE|TIME", default_value = "equilibrium", allow_hyphen_values = true)]
    pub(crate) at: String,

    /// An input, or a parameter used as one, such as a torque; may be repeated [default: all inputs].
    #[arg(long, value_name = "NAME")]
    pub(crate) input: Vec<String>,

    /// Where to write [default: out/MODEL-linear].
    #[arg(long, value_name = "DIR")]
    pub(crate) out: Option<PathBuf>,
}
