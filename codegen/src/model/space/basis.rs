//! The frames in which vectors are written.
//!
//! Known frames are that of the world and those of bodies, related by `attitude(body)`. A vector made of scalars, `[x,
//! y, z]`, or turned by any other rotation, has no known frame and fits everywhere.
//!
//! In a product of rotations the frames need not follow on each other: the rotation from one body's frame to another's
//! may be meant.

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

/// The frame of a vector; for a rotation also the frame of its arguments. Both as far as known.
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

    /// Of R S. If the frames do not match, the result is a rotation without known frames.
    pub(in crate::model) fn then(self, second: Bases) -> Bases {
        match self.from == second.to || self.from.is_none() || second.to.is_none() {
            true => Bases { to: self.to, from: second.from },
            false => Bases::default(),
        }
    }
}
