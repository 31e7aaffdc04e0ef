//! In which frame vectors are written: a vector of one frame where one of another belongs is a mistake.
//!
//! Known are the world's frame and those of bodies, by `attitude(body)`, which takes vectors of the one to the other. What is made
//! of scalars, `[x, y, z]`, or turned by any other rotation is of no frame in particular, and fits everywhere.

use crate::dsl::Region;
use crate::model::interpret::Interpreter;
use crate::model::value::Value;
use std::fmt::{Display, Formatter, Result};

/// The frame whose axes the components of a vector are along.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(in crate::model) enum Basis {
    World,
    Body(String),
}

impl Display for Basis {
    fn fmt(&self, f: &mut Formatter) -> Result {
        match self {
            Basis::World => write!(f, "the world's frame"),
            Basis::Body(name) => write!(f, "the frame of `{name}`"),
        }
    }
}

/// The frame in which a vector is written, and for a rotation also that of the vectors that it takes, where they are known.
#[derive(Clone, Default, Debug)]
pub(in crate::model) struct Bases {
    pub(in crate::model) to: Option<Basis>,
    pub(in crate::model) from: Option<Basis>,
}

impl Bases {
    /// Of a vector.
    pub(in crate::model) fn of(basis: Option<Basis>) -> Bases {
        Bases { to: basis, from: None }
    }

    /// Of a body's attitude.
    pub(in crate::model) fn attitude(body: String) -> Bases {
        Bases { to: Some(Basis::World), from: Some(Basis::Body(body)) }
    }

    /// Of R'.
    pub(in crate::model) fn inverse(self) -> Bases {
        Bases { to: self.from, from: self.to }
    }

    /// Of R S. One that does not follow on the other may still mean something; it is a rotation as any.
    pub(in crate::model) fn then(self, second: Bases) -> Bases {
        match self.from == second.to || self.from.is_none() || second.to.is_none() {
            true => Bases { to: self.to, from: second.from },
            false => Bases::default(),
        }
    }
}

impl Interpreter {
    /// Refuses a vector in one frame where one in another belongs.
    pub(super) fn expect_basis(&mut self, place: Region, found: &Option<Basis>, wanted: &Option<Basis>) -> Option<()> {
        let (Some(found), Some(wanted)) = (found, wanted) else { return Some(()) };
        if found == wanted {
            return Some(());
        }
        let into = |body: &str| format!("transpose(attitude({body}))*");
        let way = match (found, wanted) {
            (Basis::Body(own), Basis::Body(other)) => format!("{}(attitude({own})*v)", into(other)),
            (_, Basis::Body(other)) => format!("{}v", into(other)),
            (Basis::Body(own), _) => format!("attitude({own})*v"),
            (Basis::World, Basis::World) => return Some(()),
        };
        self.refuse(place, format!("this vector v is in {found}, and one in {wanted} belongs here: `{way}`"))
    }

    /// Refuses a vector in the frame of a body where one in the world's belongs.
    pub(in crate::model) fn expect_world(&mut self, place: Region, found: &Bases) -> Option<()> {
        self.expect_basis(place, &found.to, &Some(Basis::World))
    }

    /// The frame of two vectors together. Of two that differ the one in the world's frame is taken to be right.
    pub(in crate::model) fn common_basis(&mut self, vectors: [(Region, &Value); 2]) -> Option<Bases> {
        let [(first_place, first), (second_place, second)] = vectors.map(|(place, value)| (place, &value.bases.to));
        match second {
            Some(Basis::World) => self.expect_basis(first_place, first, second)?,
            _ => self.expect_basis(second_place, second, first)?,
        }
        Some(Bases::of(first.clone().or(second.clone())))
    }
}
