//! Bodies with a place and an angle of their own: `rod: free, mass m, inertia J;` has the coordinates `rod_x`, `rod_y` and
//! `rod_phi`. Later stages know only these.

use super::{Body, Coordinate, Declaration, Expression, Kind, Region, Unit};
use crate::mistakes::Mistakes;
use syn::{Ident, Result};

/// Gives free bodies their coordinates, after those that are declared.
///
/// # Errors
/// Free bodies that have a place or an angle already.
pub(super) fn give_coordinates(declaration: &mut Declaration) -> Result<()> {
    let mut mistakes = Mistakes::default();
    // A declaration without units stays one.
    let has_units = declaration.parameters.iter().any(|p| p.unit.is_some())
        || declaration.coordinates.iter().any(|c| c.unit.is_some());
    for body in &mut declaration.bodies {
        let Some(free) = body.free else { continue };
        if let Some(mistake) = place_twice(body, free) {
            mistakes.add(mistake);
            continue;
        }
        let coordinates = [("x", "m"), ("y", "m"), ("phi", "rad")].map(|(what, unit)| Coordinate {
            docs: String::new(),
            name: Ident::new(&format!("{}_{what}", body.name), body.name.span()),
            unit: has_units.then(|| si_unit(unit, free)),
        });
        let [x, y, phi] = coordinates.each_ref().map(|c| named(&c.name, free));
        if let Some((_, position)) = &mut body.mass {
            *position = Some(Expression { region: free, kind: Kind::Vector(vec![x, y]) });
        }
        body.angle = Some(phi);
        declaration.coordinates.extend(coordinates);
    }
    mistakes.or(())
}

fn place_twice(body: &Body, free: Region) -> Option<syn::Error> {
    let name = &body.name;
    match (&body.mass, &body.angle) {
        (None, _) => {
            Some(free.error(format!("the mass of free body `{name}` is missing: `{name}: free, mass m, inertia J;`")))
        }
        (Some((_, Some(place))), _) => Some(place.region.error(format!(
            "body `{name}` is free and has its place of its own, [{name}_x, {name}_y]; leave out `at ..`, or `free`"
        ))),
        (_, Some(angle)) => Some(angle.region.error(format!(
            "body `{name}` is free and has an angle of its own, {name}_phi; leave out `angle ..`, or `free`"
        ))),
        _ if body.inertia.is_none() => Some(
            free.error(format!("the inertia of free body `{name}` is missing: `{name}: free, mass m, inertia J;`")),
        ),
        _ => None,
    }
}

fn named(name: &Ident, region: Region) -> Expression {
    Expression { region, kind: Kind::Name(name.clone()) }
}

fn si_unit(name: &str, region: Region) -> Unit {
    Unit { region, factors: vec![(Ident::new(name, region.start()), 1)], text: name.to_owned() }
}
