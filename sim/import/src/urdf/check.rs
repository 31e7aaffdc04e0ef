//! What cannot be, and what is missing for a motion.

use super::robot::{Inertial, Kind, Robot};
use super::tree::Tree;
use super::warnings::Warnings;
use codegen::model::impossible_inertia;

/// Warns of inertias that no body can have, and of links that move without mass.
pub(super) fn check(robot: &Robot, tree: &Tree, warnings: &mut Warnings) {
    for link in &robot.links {
        if let Some((inertial, why)) = link.inertial.as_ref().and_then(|own| Some((own, impossible(own)?))) {
            warnings.add(&inertial.place, format!("link `{}`: {why}. It is taken as it is", link.name));
        }
    }
    for link in tree.order.iter().copied().filter(|link| tree.is_head(*link) && !tree.is_grounded(*link)) {
        let held = tree.holding[link].map(|joint| &robot.joints[joint]);
        let lump = tree.body(robot, link);
        if !lump.mass.is_zero() || lump.inertia.iter().any(|entry| !entry.is_zero()) {
            continue;
        }
        let (name, place) = (&robot.links[link].name, &robot.links[link].place);
        let moved = held.map_or("the free root".to_owned(), |joint| format!("moved by joint `{}`", joint.name));
        let beyond = match held {
            Some(joint) if !tree.has_mass_beyond(link) => {
                format!(", nor has anything beyond: the acceleration of `{}` is not determined", joint.name)
            }
            Some(joint) if joint.kind != Kind::Floating => String::new(),
            // Free: whatever it carries may not be enough.
            _ => ": its accelerations may not be determined".to_owned(),
        };
        warnings.add(place, format!("link `{name}`, {moved}, has no mass{beyond}"));
    }
}

/// Why no body has such an inertia, if none has.
fn impossible(own: &Inertial) -> Option<String> {
    let [xx, yy, zz, xy, xz, yz] = own.values();
    let is_point = own.values().iter().all(|entry| *entry == 0.0);
    if is_point && own.mass.value > 0.0 {
        return Some("this mass has no extent, a body has a moment of inertia about every axis".to_owned());
    }
    impossible_inertia([xx, yy, zz, yz, xz, xy])
}
