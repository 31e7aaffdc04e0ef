//! Links: a frame each, and a body for those that move together.

use super::blocks::{Blocks, FREE};
use super::{Named, Written};
use crate::urdf::number::Number;
use crate::urdf::pose::{Pose, quaternion};
use crate::urdf::robot::{Joint, Kind, Origin};
use codegen::model::impossible_inertia;
use nalgebra::{Matrix3, Vector3};

impl Written<'_> {
    /// Writes a link's frame, and its body if it is the first of those that move together.
    pub(super) fn link(&self, named: &Named, link: usize, blocks: &mut Blocks) {
        let held = self.tree.holding[link];
        let is_floating = held.is_some_and(|joint| self.robot.joints[joint].kind == Kind::Floating);
        if self.is_free(link) || is_floating {
            return self.free_body(named, link, blocks);
        }
        let frame = match held {
            Some(joint) => self.held(named, joint),
            None => "at [0, 0, 0], attitude rotation(z, 0)".to_owned(),
        };
        blocks.line("frames", format!("{}: {frame};", named.links[link]));
        if self.tree.is_head(link) && !self.tree.is_grounded(link) {
            let lump = self.tree.body(self.robot, link);
            let is_nothing = lump.mass.is_zero() && lump.inertia.iter().all(Number::is_zero);
            // Without a body at all, nothing would tell what the joint moves.
            if is_nothing && self.tree.has_mass_beyond(link) {
                return;
            }
            let (name, frame) = (&named.bodies[link], &named.links[link]);
            let [mass, place] = [lump.mass.with("kg"), lengths(&lump.centre)];
            let inertia = inertia(&lump.inertia);
            let mass = if lump.mass.is_zero() { "0 [kg]".to_owned() } else { mass };
            let line = format!("{name}: mass {mass} at on({frame}, {place}), {inertia}, attitude attitude({frame});");
            blocks.line("bodies", line);
        }
    }

    /// A body that nothing holds, with the frame of its link on it.
    fn free_body(&self, named: &Named, link: usize, blocks: &mut Blocks) {
        let (lump, name) = (self.tree.body(self.robot, link), &named.bodies[link]);
        let mass = if lump.mass.is_zero() { "0 [kg]".to_owned() } else { lump.mass.with("kg") };
        blocks.line(FREE, format!("{name}: free, mass {mass}, {};", inertia(&lump.inertia)));
        let back = lump.centre.each_ref().map(|number| Number::of(-number.value));
        let place = lengths(&back);
        blocks.line("frames", format!("{}: at on({name}, {place}), attitude attitude({name});", named.links[link]));
        let start = self.start(link);
        let centre = start.place + start.rotation * Vector3::from(lump.centre.each_ref().map(|number| number.value));
        for (axis, value) in ["x", "y", "z"].iter().zip(&centre).filter(|(_, value)| **value != 0.0) {
            blocks.line("initial", format!("{name}_{axis} = {};", Number::of(*value)));
        }
        if start.rotation != Matrix3::identity() {
            for (k, value) in quaternion(&start.rotation).into_iter().enumerate() {
                blocks.line("initial", format!("{name}_q{k} = {};", Number::of(value)));
            }
        }
    }

    /// Where a free link starts, in the world.
    fn start(&self, link: usize) -> Pose {
        let mut joints = Vec::new();
        let mut at = link;
        while let Some(joint) = self.tree.holding[at] {
            joints.push(joint);
            at = self.robot.joints[joint].parent;
        }
        joints.into_iter().rev().fold(Pose::none(), |pose, joint| {
            let Joint { kind, origin, axis, .. } = &self.robot.joints[joint];
            let value = if kind.is_single() { self.start_of(joint) } else { 0.0 };
            let pose = pose.then(origin);
            let axis = nalgebra::Unit::new_unchecked(*axis);
            match kind {
                Kind::Prismatic => Pose { place: pose.place + pose.rotation * (axis.into_inner() * value), ..pose },
                _ if value != 0.0 => {
                    let turn = nalgebra::Rotation3::from_axis_angle(&axis, value);
                    Pose { rotation: pose.rotation * turn.matrix(), ..pose }
                }
                _ => pose,
            }
        })
    }

    /// The frame of a link that a joint holds.
    fn held(&self, named: &Named, joint: usize) -> String {
        let Joint { kind, parent, origin, axis, .. } = &self.robot.joints[joint];
        let parent = &named.links[*parent];
        let place = format!("on({parent}, {})", lengths(&origin.xyz));
        let attitude = format!("attitude({parent}){}", turned(origin));
        match kind {
            Kind::Revolute | Kind::Continuous => {
                format!("at {place}, attitude {attitude}*{}", rotation(axis, &self.value(named, joint)))
            }
            Kind::Prismatic => {
                let along = vector(axis);
                format!("at {place} + {}*({attitude}*{along}), attitude {attitude}", self.value(named, joint))
            }
            Kind::Planar => {
                let (name, [u, v]) = (&named.joints[joint], across(axis));
                let shift = |ending: &str, along| format!(" + {name}_{ending}*({attitude}*{})", vector(along));
                let turned = rotation(axis, &format!("{name}_turn"));
                format!("at {place}{}{}, attitude {attitude}*{turned}", shift("x", &u), shift("y", &v))
            }
            Kind::Fixed | Kind::Floating => format!("at {place}, attitude {attitude}"),
        }
    }
}

/// `*axes(..)`, if an origin is turned.
fn turned(origin: &Origin) -> String {
    let column = |k: usize| vector(&origin.rotation.column(k).into_owned());
    if origin.is_turned() { format!("*axes({}, {}, {})", column(0), column(1), column(2)) } else { String::new() }
}

fn rotation(axis: &Vector3<f64>, angle: &str) -> String {
    for (k, letter) in ["x", "y", "z"].into_iter().enumerate() {
        if axis[k].abs() == 1.0 {
            return format!("rotation({letter}, {}{angle})", if axis[k] < 0.0 { "-" } else { "" });
        }
    }
    format!("rotation({}, {angle})", vector(axis))
}

/// Two directions across a plane's normal, right-handed with it: x and y for z.
fn across(normal: &Vector3<f64>) -> [Vector3<f64>; 2] {
    let smallest = (0..3).min_by(|a, b| normal[*a].abs().total_cmp(&normal[*b].abs())).unwrap_or(0);
    let u = match normal.iter().position(|x| *x == 1.0) {
        Some(axis) => Vector3::ith((axis + 1) % 3, 1.0),
        None => normal.cross(&Vector3::ith(smallest, 1.0)).normalize(),
    };
    [u, normal.cross(&u)]
}

/// `inertia [..]`, principal moments alone where the others are 0.
fn inertia(entries: &[Number; 6]) -> String {
    let [xx, yy, zz, xy, xz, yz] = entries.each_ref().map(|entry| entry.value);
    let count = if [xy, xz, yz].iter().all(|entry| *entry == 0.0) { 3 } else { 6 };
    let list: Vec<String> = entries[..count].iter().map(|entry| entry.with("kg*m^2")).collect();
    let unchecked = if impossible_inertia([xx, yy, zz, yz, xz, xy]).is_some() { ", unchecked" } else { "" };
    format!("inertia [{}]{unchecked}", list.join(", "))
}

fn lengths(numbers: &[Number; 3]) -> String {
    format!("[{}]", numbers.each_ref().map(|number| number.with("m")).join(", "))
}

fn vector(v: &Vector3<f64>) -> String {
    format!("[{}, {}, {}]", Number::of(v[0]), Number::of(v[1]), Number::of(v[2]))
}
