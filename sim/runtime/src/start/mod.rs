//! The assembly of a mechanism before it moves.

pub(crate) mod assemble;
pub(crate) mod derivative;
pub(crate) mod dyads;
