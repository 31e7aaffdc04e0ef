//! How a mechanism is put together before it moves.

pub(crate) mod assemble;
pub(crate) mod dyads;
