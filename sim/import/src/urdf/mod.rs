//! Robots from URDF, the Unified Robot Description Format (<https://wiki.ros.org/urdf/XML>), as declarations.
//!
//! A link is a frame at its own origin, and what moves together is one body at its own centre of mass. What a file lacks or
//! contradicts is a warning at its line; what leaves its meaning open is refused there.

mod check;
mod mesh;
mod mimic;
mod names;
mod number;
mod outline;
mod pose;
mod read;
mod robot;
mod tree;
mod warnings;
mod write;
mod xml;

use codegen::mistakes::Mistake;
use std::ops::Range;
use std::path::{Path, PathBuf};
use warnings::Warnings;

/// How the root of a robot is held.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum Base {
    /// The root link is fixed to the ground.
    #[default]
    Fixed,
    /// The root link moves freely.
    Free,
}

/// What becomes of a joint that mimics another.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum Mimic {
    /// Its value is written by that of the other.
    #[default]
    Substitute,
    /// It has a coordinate of its own and a constraint.
    Couple,
    /// It moves by itself.
    Free,
}

/// How a robot is imported.
#[derive(Clone, PartialEq, Debug)]
pub struct Options {
    /// How its root is held.
    pub base: Base,
    /// What becomes of joints that mimic others.
    pub mimic: Mimic,
    /// Whether joints have their damping and friction.
    pub damping: bool,
    /// Whether limits stop joints, by impacts without rebound.
    pub stops: bool,
    /// Angles of rotations this close to a quarter turn, in radians, and components of axes this close to 0 are set straight.
    pub straighten: f64,
    /// Names of packages, with their folders.
    pub packages: Vec<(String, PathBuf)>,
}

impl Options {
    /// Rotations this close to a quarter turn are set straight unless more is asked for: files write pi/2 with 12 digits.
    pub const STRAIGHT: f64 = 1e-11;
}

impl Default for Options {
    fn default() -> Options {
        Options {
            base: Base::default(),
            mimic: Mimic::default(),
            damping: true,
            stops: false,
            straighten: Options::STRAIGHT,
            packages: Vec::new(),
        }
    }
}

/// A robot as a declaration.
#[derive(Clone, Debug)]
pub struct Imported {
    /// The declaration, as a `.mech` file has it.
    pub text: String,
    /// What the robot's file lacks or contradicts, and what was left out, at its places.
    pub warnings: Vec<Mistake>,
}

/// The place of a robot's first tag in a text, by bytes.
pub fn root(text: &str) -> Range<usize> {
    roxmltree::Document::parse(text).map(|document| xml::tag(document.root_element())).unwrap_or(0..0)
}

/// The declaration of the robot that a text in URDF describes. Meshes are sought in `folder` and in the named packages.
///
/// # Errors
/// At their places: what is no XML, has no robot, two roots or a loop, or leaves open what is meant.
pub fn import(text: &str, folder: &Path, options: &Options) -> Result<Imported, Vec<Mistake>> {
    let mut warnings = Warnings::of(text);
    let robot = read::read(text, options.straighten, &mut warnings)?;
    let base = options.base;
    let tree = tree::tree(text, &robot, base)?;
    if base == Base::Fixed && robot.joints.iter().all(|joint| joint.kind == robot::Kind::Fixed) {
        let message = "nothing moves: no joint of this robot does. A free root does, `sim import FILE --base free`";
        return Err(vec![Mistake::at(text, warnings::CODE, robot.links[tree.root].place.clone(), message.into())]);
    }
    let followers = mimic::followers(&robot, options.mimic, &mut warnings);
    check::check(&robot, &tree, &mut warnings);
    if options.stops {
        // An impact holds all constraints that are active, in both directions.
        let message = "a stop that a joint rests on holds in impacts elsewhere too, even where it would have to pull";
        warnings.add(&robot.links[tree.root].place, message);
    }
    let written = write::Written { robot: &robot, tree: &tree, followers: &followers, options, folder };
    let text = written.text(&mut warnings);
    Ok(Imported { text, warnings: warnings.all() })
}
