//! Bodies that joints place: those joints become coordinates and form a spanning tree; the others stay constraints,
//! which cut the loops. Later stages see neither.
//!
//! A spatial body, `link: mass m, inertia [A, B, C];`, that is not `free` and has no pose is placed by the first joint,
//! in the order of declaration, that leads to it from the ground or from a placed body, and so on from there.

use super::added_coordinates::AddedCoordinates;
use super::coordinates::{JointCoordinates, Pose};
use super::frames::unknown_body;
use super::no_constraint;
use crate::dsl::{Body, Declaration, Joint, JointKind, Kind, Region, SpatialJoint};
use crate::mistakes::Mistakes;
use syn::ext::IdentExt;
use syn::{Ident, Result};

/// Gives the joints of a spanning tree their coordinates, after those that are declared, and the bodies that they place their
/// poses. Bodies then stand in the order in which they are placed.
///
/// # Errors
/// Bodies that no joint leads to, names of coordinates that are already taken, and references to joints as constraints
/// though they have become coordinates.
pub(super) fn place_bodies(declaration: &mut Declaration) -> Result<()> {
    if !declaration.bodies.iter().any(is_unplaced) {
        return Ok(());
    }
    check_names(declaration)?;
    let mut mistakes = Mistakes::default();
    let mut given = AddedCoordinates::to(declaration);
    let mut tree = Tree::of(std::mem::take(&mut declaration.bodies));
    let mut spanning = Vec::new();
    while let Some(Branch { joint, body, is_backward, is_grounded }) = tree.next(&declaration.joints) {
        let joint = declaration.joints.remove(joint);
        let mut body = tree.waiting.remove(body);
        if let JointKind::Spatial(spatial) = &joint.kind {
            let (name, docs) = (&joint.name, joint.docs.as_str());
            let coordinates = JointCoordinates { name, docs, joint: spatial, is_backward, is_grounded };
            if let Some(pose) = mistakes.note(coordinates.pose(&mut given)) {
                mistakes.note(place(&mut body, pose));
            }
        }
        tree.placed.push(body);
        tree.settle();
        spanning.push(joint);
    }
    tree.mistakes(&declaration.joints).for_each(|mistake| mistakes.add(mistake));
    declaration.bodies = tree.placed.into_iter().chain(tree.waiting).collect();
    given.add(declaration, &mut mistakes);
    no_constraint::refuse(&spanning, declaration, &mut mistakes);
    mistakes.or(())
}

/// Whether a spatial body has no pose of its own.
fn is_unplaced(body: &Body) -> bool {
    let is_spatial = body.inertia.as_ref().is_some_and(|inertia| matches!(inertia.kind, Kind::Vector(_)));
    let has_place = body.mass.as_ref().is_some_and(|(_, place)| place.is_some());
    is_spatial && !has_place && body.angle.is_none() && body.attitude.is_none()
}

fn place(body: &mut Body, pose: Pose) -> Result<()> {
    let Some((_, position)) = &mut body.mass else {
        let name = body.name.unraw();
        let message =
            format!("the mass of `{name}` is missing: a joint places it, `{name}: mass m, inertia [A, B, C];`");
        return Err(Region::from(&body.name).error(message));
    };
    *position = Some(pose.position);
    body.attitude = Some(pose.attitude);
    Ok(())
}

/// Bodies with poses, in the order of placement, and those without.
struct Tree {
    has_ground: bool,
    placed: Vec<Body>,
    waiting: Vec<Body>,
}

/// A joint, by its place, from a body that is placed or from the ground to a waiting one, by its place.
struct Branch {
    joint: usize,
    body: usize,
    is_backward: bool,
    is_grounded: bool,
}

impl Tree {
    fn of(bodies: Vec<Body>) -> Tree {
        let has_ground = bodies.iter().all(|body| body.name != "ground");
        let mut tree = Tree { has_ground, placed: vec![], waiting: bodies };
        tree.settle();
        tree
    }

    /// Bodies with a declared pose are placed once the bodies that it refers to are.
    fn settle(&mut self) {
        let is_settled = |waiting: &[Body], at: usize| {
            !is_unplaced(&waiting[at]) && !waiting[..at].iter().any(|above| speaks_of(&waiting[at], above))
        };
        while let Some(at) = (0..self.waiting.len()).find(|at| is_settled(&self.waiting, *at)) {
            self.placed.push(self.waiting.remove(at));
        }
    }

    /// The first joint that leads on.
    fn next(&self, joints: &[Joint]) -> Option<Branch> {
        joints.iter().enumerate().find_map(|(joint, Joint { kind, .. })| {
            let JointKind::Spatial(spatial) = kind else { return None };
            let SpatialJoint { first, second, .. } = &**spatial;
            let ways = [(&first.body, &second.body, false), (&second.body, &first.body, true)];
            ways.into_iter().find_map(|(holder, held, is_backward)| {
                let is_grounded = self.has_ground && holder == "ground";
                let holds = is_grounded || self.placed.iter().any(|body| body.name == *holder);
                let body = self.waiting.iter().position(|body| body.name == *held && is_unplaced(body))?;
                holds.then_some(Branch { joint, body, is_backward, is_grounded })
            })
        })
    }

    /// Bodies that nothing places, by the joints that are left.
    fn mistakes(&self, joints: &[Joint]) -> impl Iterator<Item = syn::Error> {
        let rolls = |body: &Body| {
            joints.iter().any(|joint| matches!(&joint.kind, JointKind::Rolling(rolling) if rolling.disc == body.name))
        };
        let lost =
            self.waiting.iter().filter(|body| is_unplaced(body) && self.placed.iter().all(|p| p.name != body.name));
        lost.map(move |body| {
            let name = body.name.unraw();
            let roll = if rolls(body) { "; `roll` is a constraint and places nothing" } else { "" };
            Region::from(&body.name).error(format!(
                "no joint places `{name}`: none leads to it from the ground or from a placed body{roll}. Join \
                 it, write `mass m at P` and `attitude R`, or make it `free`"
            ))
        })
    }
}

fn speaks_of(body: &Body, other: &Body) -> bool {
    let place = body.mass.as_ref().and_then(|(_, place)| place.as_ref());
    let name = other.name.to_string();
    place.into_iter().chain(&body.angle).chain(&body.attitude).any(|expression| expression.mentions(&name))
}

/// Refuses joints of bodies that are not there, which would leave others without a place.
fn check_names(declaration: &Declaration) -> Result<()> {
    let names: Vec<&Ident> = declaration.bodies.iter().map(|body| &body.name).collect();
    let mut mistakes = Mistakes::default();
    for Joint { kind, .. } in &declaration.joints {
        let JointKind::Spatial(joint) = kind else { continue };
        for body in [&joint.first.body, &joint.second.body] {
            if body != "ground" && !names.contains(&body) {
                mistakes.add(unknown_body(body, &names));
            }
        }
    }
    mistakes.or(())
}
