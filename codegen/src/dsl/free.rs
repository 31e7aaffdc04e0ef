//! Bodies with a place and an angle of their own: `rod: free, mass m, inertia J;` has the coordinates `rod_x`, `rod_y` and
//! `rod_phi`. One of space, `rod: free, mass m, inertia [A, B, C];`, has `rod_x`, `rod_y`, `rod_z` and the quaternion `rod_q0`
//! to `rod_q3`, which the constraint `rod_norm` keeps at length 1. Later stages know only these.

use super::made::{binary, call};
use super::{Body, Coordinate, Declaration, Equation, Expression, Initial, InitialKind, Kind, Operator, Region, Unit};
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
        let coordinate = |(what, unit): (&str, &str)| Coordinate {
            docs: String::new(),
            name: Ident::new(&format!("{}_{what}", body.name), body.name.span()),
            unit: (has_units && unit != "1").then(|| si_unit(unit, free)),
        };
        if body.inertia.as_ref().is_some_and(|inertia| matches!(inertia.kind, Kind::Vector(_))) {
            let places = [("x", "m"), ("y", "m"), ("z", "m")].map(coordinate);
            let quaternion = [("q0", "1"), ("q1", "1"), ("q2", "1"), ("q3", "1")].map(coordinate);
            if let Some((_, position)) = &mut body.mass {
                let components = places.each_ref().map(|c| named(&c.name, free)).to_vec();
                *position = Some(Expression { region: free, kind: Kind::Vector(components) });
            }
            let components = quaternion.each_ref().map(|c| named(&c.name, free));
            declaration.constraints.push(norm(body, &components, free));
            body.attitude = Some(call(free, "quaternion", components.to_vec()));
            upright(&mut declaration.initial, &quaternion[0].name, free);
            declaration.coordinates.extend(places.into_iter().chain(quaternion));
            continue;
        }
        let coordinates = [("x", "m"), ("y", "m"), ("phi", "rad")].map(coordinate);
        let [x, y, phi] = coordinates.each_ref().map(|c| named(&c.name, free));
        if let Some((_, position)) = &mut body.mass {
            *position = Some(Expression { region: free, kind: Kind::Vector(vec![x, y]) });
        }
        body.angle = Some(phi);
        declaration.coordinates.extend(coordinates);
    }
    mistakes.or(())
}

/// `rod_norm: q0^2 + q1^2 + q2^2 + q3^2 = 1`
fn norm(body: &Body, components: &[Expression; 4], free: Region) -> Equation {
    let number =
        |literal: &str| Expression { region: free, kind: Kind::Number { literal: literal.into(), unit: None } };
    let [a, b, c, d] = components.clone().map(|x| binary(Operator::Power, x, number("2")));
    let sum = [b, c, d].into_iter().fold(a, |sum, square| binary(Operator::Add, sum, square));
    let name = Ident::new(&format!("{}_norm", body.name), body.name.span());
    Equation { name, left: sum, right: number("1"), initially: None }
}

/// A body whose start is not given starts near where its axes are the world's.
fn upright(initial: &mut Vec<Initial>, q0: &Ident, free: Region) {
    let is_given = initial.iter().any(|line| line.coordinate == *q0 && line.kind != InitialKind::Speed);
    if !is_given {
        let value = Expression { region: free, kind: Kind::Number { literal: "1".into(), unit: None } };
        initial.push(Initial { coordinate: q0.clone(), kind: InitialKind::Guess, value });
    }
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

fn named(name: &Ident, region: Region) -> Expression {
    Expression { region, kind: Kind::Name(name.clone()) }
}

fn si_unit(name: &str, region: Region) -> Unit {
    Unit { region, factors: vec![(Ident::new(name, region.start()), 1)], text: name.to_owned() }
}
