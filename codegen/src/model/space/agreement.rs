//! A vector in one frame where another is needed is a mistake.

use super::basis::{Bases, Basis};
use crate::dsl::Region;
use crate::model::interpreter::Interpreter;
use crate::model::value::Value;

impl Interpreter {
    /// Refuses a vector in one frame where another is needed.
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
        self.refuse(place, format!("this vector v is in {found}, but one in {wanted} is needed: `{way}`"))
    }

    /// Refuses a vector in a body's frame where the world frame is needed.
    pub(in crate::model) fn expect_world(&mut self, place: Region, found: &Bases) -> Option<()> {
        self.expect_basis(place, &found.to, &Some(Basis::World))
    }

    /// The common frame of two vectors. If they differ, the one in the world frame is taken to be right.
    pub(in crate::model) fn common_basis(&mut self, vectors: [(Region, &Value); 2]) -> Option<Bases> {
        let [(first_place, first), (second_place, second)] = vectors.map(|(place, value)| (place, &value.bases.to));
        match second {
            Some(Basis::World) => self.expect_basis(first_place, first, second)?,
            _ => self.expect_basis(second_place, second, first)?,
        }
        Some(Bases::of(first.clone().or(second.clone())))
    }
}
