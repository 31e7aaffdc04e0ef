//! A robot as the text of a declaration.

mod blocks;
mod frames;
mod joints;
mod shapes;

use super::mimic::Followers;
use super::names::{Names, type_name};
use super::robot::{Kind, Robot};
use super::tree::Tree;
use super::warnings::Warnings;
use super::{Base, Mimic, Options};
use blocks::Blocks;
use std::path::Path;

/// What is to be written.
pub(super) struct Written<'a> {
    pub(super) robot: &'a Robot,
    pub(super) tree: &'a Tree,
    pub(super) followers: &'a Followers,
    pub(super) options: &'a Options,
    pub(super) folder: &'a Path,
}

/// The names of a robot's parts in the declaration, by their places in the robot.
struct Named {
    /// The coordinate of each joint, or the beginning of their names.
    joints: Vec<String>,
    /// The frame of each link.
    links: Vec<String>,
    /// The body of each link that is the first of those that move together.
    bodies: Vec<String>,
    gravity: String,
}

impl Written<'_> {
    /// The declaration.
    pub(super) fn text(&self, warnings: &mut Warnings) -> String {
        let (mut names, mut blocks) = (Names::none(), Blocks::default());
        let named = self.names(&mut names, warnings);
        blocks.line("parameters", format!("/// Acceleration of free fall.\n    {} [m/s^2] = 9.81;", named.gravity));
        blocks.line("loads", format!("gravity [0, 0, -{}];", named.gravity));
        for link in &self.tree.order {
            self.link(&named, *link, &mut blocks);
        }
        for (at, joint) in self.robot.joints.iter().enumerate() {
            match joint.kind {
                Kind::Revolute | Kind::Continuous | Kind::Prismatic => {
                    self.joint(&named, at, &mut names, &mut blocks);
                    self.warn_of_start(at, warnings);
                }
                Kind::Planar => {
                    for (ending, unit) in PLANAR {
                        blocks.line("coordinates", format!("{}{ending} [{unit}];", named.joints[at]));
                    }
                }
                Kind::Fixed | Kind::Floating => {}
            }
        }
        shapes::draw(self, &named.links, &mut blocks, warnings);
        blocks.line("kernels", "inverse_dynamics;".to_owned());
        blocks.line("kernels", "speed_mass_matrix;".to_owned());
        let name = type_name(&self.robot.name);
        format!("language 1;\n\n/// {}, from its URDF.\npub {name};\n{}", one_line(&self.robot.name), blocks.text())
    }

    fn names(&self, names: &mut Names, warnings: &mut Warnings) -> Named {
        let mut tell = |place, old: &str, new: &str| {
            if old != new {
                warnings.add(place, format!("`{}` is called `{new}`", one_line(old)));
            }
        };
        let mut joints = Vec::new();
        for joint in &self.robot.joints {
            let name = names.take_with(&joint.name, "joint", endings(joint.kind));
            tell(&joint.place, &joint.name, &name);
            joints.push(name);
        }
        let mut links = Vec::new();
        for link in &self.robot.links {
            let name = names.take(&link.name, "link");
            tell(&link.place, &link.name, &name);
            links.push(name);
        }
        let bodies = links.iter().map(|link| names.take_with(&format!("{link}_body"), "body", FREE)).collect();
        Named { joints, links, bodies, gravity: names.take("g", "gravity") }
    }

    /// A joint that follows another may start outside of its own limits.
    fn warn_of_start(&self, joint: usize, warnings: &mut Warnings) {
        let of = &self.robot.joints[joint];
        let Some((limit, [lower, upper])) = of.limit.as_ref().and_then(|limit| Some((limit, limit.range.as_ref()?)))
        else {
            return;
        };
        let start = self.start_of(joint);
        if self.followers.law(joint).is_some() && !(lower.value..=upper.value).contains(&start) {
            let message = format!(
                "joint `{}` follows another, and starts at {start}, outside of these limits",
                one_line(&of.name)
            );
            warnings.add(&limit.place, message);
        }
    }

    fn is_substituted(&self, joint: usize) -> bool {
        self.options.mimic == Mimic::Substitute && self.followers.law(joint).is_some()
    }

    fn is_free(&self, link: usize) -> bool {
        link == self.tree.root && self.options.base == Base::Free
    }
}

/// What the names of a free body's coordinates end in, and that of its norm.
const FREE: &[&str] = &["_x", "_y", "_z", "_q0", "_q1", "_q2", "_q3", "_norm"];

/// What the names of a planar joint's coordinates end in.
const PLANAR: [(&str, &str); 3] = [("_x", "m"), ("_y", "m"), ("_turn", "rad")];

/// What the names of a joint's coordinates end in.
fn endings(kind: Kind) -> &'static [&'static str] {
    match kind {
        Kind::Revolute | Kind::Continuous | Kind::Prismatic => &[""],
        Kind::Planar => &["_x", "_y", "_turn"],
        Kind::Fixed | Kind::Floating => &[],
    }
}

/// A name in documentation: on one line, and not too long.
fn one_line(text: &str) -> String {
    text.chars().take(80).map(|c| if c.is_control() { ' ' } else { c }).collect()
}
