//! A program before its values have registers.

use super::instruction::{Instruction, LookUp, Waves};

/// A program.
pub(super) struct Parts {
    pub(super) instructions: Vec<Instruction<Place>>,
    pub(super) waves: Vec<Waves<Place>>,
    pub(super) look_ups: Vec<LookUp<Place>>,
}

/// Where a value is.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub(super) enum Place {
    Constant(usize),
    Field(usize),
    Argument(usize),
    /// A value of the program's own, by number.
    Local(usize),
    Result(usize),
}
