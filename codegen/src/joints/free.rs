//! Bodies with their own position and angle: `rod: free, mass m, inertia J;` has the coordinates `rod_x`, `rod_y` and
//! `rod_phi`. One of space, `rod: free, mass m, inertia [A, B, C];`, has `rod_x`, `rod_y`, `rod_z` and the quaternion
//! `rod_q0` to `rod_q3`, which the constraint `rod_norm` keeps at length 1. Later stages see only these.

use super::added_coordinates::{AddedCoordinates, with_suffix};
use super::made::vector;
use crate::dsl::{Body, Declaration, Kind, Region};
use crate::mistakes::Mistakes;
use syn::Result;

/// Gives free bodies their coordinates, after those that are declared.
///
/// # Errors
/// Free bodies that also declare a position or an angle.
pub(super) fn give_coordinates(declaration: &mut Declaration) -> Result<()> {
    let mut mistakes = Mistakes::default();
    let mut given = AddedCoordinates::to(declaration);
    for body in &mut declaration.bodies {
        let Some(free) = body.free else { continue };
        if let Some(mistake) = place_twice(body, free) {
            mistakes.add(mistake);
            continue;
        }
        let is_spatial = body.inertia.as_ref().is_some_and(|inertia| matches!(inertia.kind, Kind::Vector(_)));
        let axes: &[&str] = if is_spatial { &["x", "y", "z"] } else { &["x", "y"] };
        let mut coordinate = |what, unit| given.coordinate(with_suffix(&body.name, what), unit, String::new(), free);
        let place = axes.iter().map(|axis| coordinate(*axis, "m")).collect();
        if is_spatial {
            body.attitude = Some(given.quaternion(&body.name, "", free));
        } else {
            body.angle = Some(coordinate("phi", "rad"));
        }
        if let Some((_, position)) = &mut body.mass {
            *position = Some(vector(free, place));
        }
    }
    given.add(declaration, &mut mistakes);
    mistakes.or(())
}

fn place_twice(body: &Body, free: Region) -> Option<syn::Error> {
    let name = &body.name;
    match (&body.mass, &body.angle) {
        (None, _) => {
            Some(free.error(format!("the mass of free body `{name}` is missing: `{name}: free, mass m, inertia J;`")))
        }
        (Some((_, Some(place))), _) => Some(place.region.error(format!(
            "body `{name}` is free and has a position of its own, [{name}_x, {name}_y]; leave out `at ..`, or `free`"
        ))),
        (_, Some(angle)) => Some(angle.region.error(format!(
            "body `{name}` is free and has an angle of its own, {name}_phi; leave out `angle ..`, or `free`"
        ))),
        _ if body.attitude.is_some() => Some(free.error(format!(
            "body `{name}` is free and has an attitude of its own, the quaternion {name}_q0 to {name}_q3; leave out \
             `attitude ..`, or `free`"
        ))),
        _ if body.inertia.is_none() => Some(
            free.error(format!("the inertia of free body `{name}` is missing: `{name}: free, mass m, inertia J;`")),
        ),
        _ => None,
    }
}
