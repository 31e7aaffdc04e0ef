//! Coordinates that the language adds for free bodies and joints.

use super::made::{binary, call, named, number, sum};
use crate::dsl::{Coordinate, Declaration, Equation, Expression, Initial, InitialKind, Operator, Region, Unit};
use crate::mistakes::Mistakes;
use syn::Ident;
use syn::ext::IdentExt;

/// Coordinates to be added to a declaration, with the norm constraints of their quaternions.
pub(super) struct AddedCoordinates {
    /// Whether lengths are in metres; without units they are in one of the user's choice.
    has_units: bool,
    coordinates: Vec<Coordinate>,
    norms: Vec<Equation>,
    /// The scalar parts of quaternions.
    scalar_parts: Vec<(Ident, Region)>,
}

impl AddedCoordinates {
    /// None yet.
    pub(super) fn to(declaration: &Declaration) -> AddedCoordinates {
        AddedCoordinates {
            has_units: declaration.has_units(),
            coordinates: vec![],
            norms: vec![],
            scalar_parts: vec![],
        }
    }

    /// A coordinate, in a unit of the SI; gives its name as an expression. An angle is one whatever units are chosen.
    pub(super) fn coordinate(&mut self, name: Ident, unit: &str, docs: String, at: Region) -> Expression {
        let is_told = unit == "rad" || self.has_units && unit != "1";
        let unit = is_told.then(|| Unit {
            region: at,
            factors: vec![(Ident::new(unit, at.start()), 1)],
            text: unit.to_owned(),
        });
        let expression = named(&name, at);
        self.coordinates.push(Coordinate { docs, name, unit, is_added: true });
        expression
    }

    /// A quaternion of the coordinates `name_q0` to `name_q3`, which the constraint `name_norm` keeps at length 1.
    pub(super) fn quaternion(&mut self, name: &Ident, docs: &str, at: Region) -> Expression {
        let components =
            ["q0", "q1", "q2", "q3"].map(|what| self.coordinate(with_suffix(name, what), "1", docs.to_owned(), at));
        let squares = components.clone().map(|x| binary(Operator::Power, x, number(at, "2")));
        let [a, b, c, d] = squares;
        let left = sum(sum(sum(a, b), c), d);
        self.norms.push(Equation {
            name: with_suffix(name, "norm"),
            left,
            right: number(at, "1"),
            initially: None,
            is_of_joint: false,
        });
        self.scalar_parts.push((with_suffix(name, "q0"), at));
        call(at, "quaternion", components.into())
    }

    /// Adds them after those that are declared. A name that is already taken is a mistake.
    pub(super) fn add(self, declaration: &mut Declaration, mistakes: &mut Mistakes) {
        for Coordinate { name, .. } in &self.coordinates {
            if let Some(other) = names(declaration).find(|other| *other == name) {
                let mut mistake = Region::from(name).error(format!(
                    "`{name}` is the name of a coordinate that this adds; rename this, or the other `{name}`"
                ));
                mistake.combine(Region::from(other).error(format!("the other `{name}` is here")));
                mistakes.add(mistake);
            }
        }
        declaration.coordinates.extend(self.coordinates);
        declaration.constraints.extend(self.norms);
        for (scalar_part, at) in self.scalar_parts {
            start_upright(&mut declaration.initial, scalar_part, at);
        }
    }
}

/// The names that expressions can refer to.
fn names(declaration: &Declaration) -> impl Iterator<Item = &Ident> {
    let valued = declaration.parameters.iter().chain(&declaration.inputs).map(|p| &p.name);
    let moving = declaration.coordinates.iter().map(|c| &c.name).chain(declaration.auxiliary.iter().map(|a| &a.name));
    valued
        .chain(moving)
        .chain(declaration.lets.iter().map(|l| &l.name))
        .chain(declaration.tables.iter().map(|t| &t.name))
}

/// A quaternion without a given start is guessed as the identity.
fn start_upright(initial: &mut Vec<Initial>, coordinate: Ident, at: Region) {
    let is_given = initial.iter().any(|line| line.coordinate == coordinate && line.kind != InitialKind::Speed);
    if !is_given {
        initial.push(Initial { coordinate, kind: InitialKind::Guess, value: number(at, "1") });
    }
}

/// `rod_x` of `rod`.
pub(super) fn with_suffix(name: &Ident, what: &str) -> Ident {
    Ident::new(&format!("{}_{what}", name.unraw()), name.span())
}
