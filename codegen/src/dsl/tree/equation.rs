//! Equations by name.

use crate::dsl::Expression;
use syn::Ident;

/// `slot: left = right;`
pub struct Equation {
    /// Its name.
    pub name: Ident,
    /// The left side.
    pub left: Expression,
    /// The right side.
    pub right: Expression,
    /// `initially released`, on a constraint that events switch.
    pub initially: Option<Activity>,
    /// Whether it comes from a joint: the user then cannot leave out single rows.
    pub is_of_joint: bool,
}

/// Whether a constraint holds.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Activity {
    /// It holds.
    Active,
    /// It does not hold, and its reaction is 0.
    Released,
}
