//! Arguments of `import`.

use clap::{Args, ValueEnum};
use sim_runtime::import::urdf::{Base, Mimic, Options};
use std::path::PathBuf;

/// The arguments of `import`.
#[derive(Args)]
#[command(
    after_help = "Examples:\n  sim import panda.urdf -o panda.mech\n  sim import anymal.urdf --base free -o anymal.mech\n  \
    sim import arm.urdf --package arm_description=../arm_description\n\n\
    What the file lacks or contradicts is told at its line, and what was made of it. Other commands take the file itself too, as \
    in `sim run panda.urdf`, and import it without options."
)]
pub(crate) struct ImportArguments {
    /// The robot, in URDF.
    pub(crate) file: PathBuf,

    /// Where to write the declaration; one that is there is kept [default: standard output].
    #[arg(long, short, value_name = "FILE")]
    pub(crate) out: Option<PathBuf>,

    /// How the root link is held.
    #[arg(long, value_enum, default_value = "fixed")]
    base: BaseWord,

    /// What becomes of joints that mimic others: written by the other's value, coupled by a constraint, or left alone.
    #[arg(long, value_enum, default_value = "substitute")]
    mimic: MimicWord,

    /// Leaves damping and friction of joints out.
    #[arg(long)]
    no_damping: bool,

    /// Lets limits stop the joints, by impacts without rebound.
    #[arg(long)]
    stops: bool,

    /// Sets rotations straight that are this close to a quarter turn, in radians, and tells each.
    #[arg(long, value_name = "ANGLE", value_parser = angle)]
    straighten: Option<f64>,

    /// The folder of a package that meshes are in, as in `--package arm_description=../arm`; may be repeated.
    #[arg(long, value_name = "NAME=DIR", value_parser = package)]
    package: Vec<(String, PathBuf)>,
}

#[derive(Clone, Copy, ValueEnum)]
enum BaseWord {
    Fixed,
    Free,
}

#[derive(Clone, Copy, ValueEnum)]
enum MimicWord {
    Substitute,
    Couple,
    Free,
}

impl ImportArguments {
    pub(crate) fn options(&self) -> Options {
        Options {
            base: match self.base {
                BaseWord::Fixed => Base::Fixed,
                BaseWord::Free => Base::Free,
            },
            mimic: match self.mimic {
                MimicWord::Substitute => Mimic::Substitute,
                MimicWord::Couple => Mimic::Couple,
                MimicWord::Free => Mimic::Free,
            },
            damping: !self.no_damping,
            stops: self.stops,
            straighten: self.straighten.unwrap_or(Options::STRAIGHT),
            packages: self.package.clone(),
        }
    }
}

fn angle(text: &str) -> Result<f64, String> {
    let known = text.parse().ok().filter(|angle| (0.0..=0.1).contains(angle));
    known.ok_or_else(|| "an angle from 0 to 0.1 is needed, in radians, as in 1e-5".to_owned())
}

fn package(text: &str) -> Result<(String, PathBuf), String> {
    let known = text.split_once('=').filter(|(name, folder)| !name.is_empty() && !folder.is_empty());
    known
        .map(|(name, folder)| (name.to_owned(), folder.into()))
        .ok_or_else(|| "a name and a folder are needed, as in arm=../arm".to_owned())
}
