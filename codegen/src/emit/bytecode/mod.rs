//! Programs as instructions on numbered registers, for machines that execute them as they are.
//!
//! A program is straight-line already, so nothing is left but to name its registers. Each operation is one of
//! [`Instruction`], in the order in which the generated Rust does it: whoever executes them gets the same bits.

mod allocate;
mod columns;
mod in_place;
mod instruction;
mod parts;
mod schedule;
mod write;

pub use instruction::{Access, Instruction, LookUp, Wave, Waves};
pub use write::codes;

use crate::kernel_id::{Argument, KernelId};
use std::ops::Range;

/// The register of every program that holds -0: x + (-0) is x, whatever x is.
pub const MINUS_ZERO: u32 = 0;
/// The register of every program that holds 1.
pub const ONE: u32 = 1;

/// In which order the instructions stand. The results have the same bits.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Order {
    /// That of the program, on as few registers as possible: for many states at once, whose registers are large.
    Written,
    /// One in which none waits long for the ones before it: for a single state.
    Scheduled,
}

/// A kernel as instructions. Its registers are, in this order: constants, what is loaded from the receiver, what is
/// loaded from the arguments, others, and the results.
#[derive(Debug)]
pub struct Code {
    /// Which kernel it is.
    pub kernel: KernelId,
    /// What the first registers hold.
    pub constants: Vec<f64>,
    /// What the registers after those are loaded with, of the receiver.
    pub fields: Vec<Field>,
    /// What the registers after those are loaded with, of the arguments: which, and which entry of it.
    pub arguments: Vec<(Argument, usize)>,
    /// How many registers there are.
    pub registers: usize,
    /// The instructions, in order.
    pub instructions: Vec<Instruction<u32>>,
    /// What [`Instruction::Waves`] computes.
    pub waves: Vec<Waves<u32>>,
    /// What [`Instruction::LookUp`] looks up.
    pub look_ups: Vec<LookUp<u32>>,
    /// The results, in the order of the record that is returned.
    pub results: Vec<Returned>,
    /// Whether a pivot is refused: pivots, each with the magnitude of its terms. `None` refuses every state.
    pub pivots: Option<Vec<[u32; 2]>>,
}

/// What a register is loaded with.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Field {
    /// A parameter.
    Parameter(usize),
    /// The activity of a constraint that events switch.
    Activity(usize),
    /// A result of [`KernelId::Prepare`].
    Prepared(usize),
}

/// A result: a number, a vector or a matrix.
#[derive(Debug)]
pub struct Returned {
    /// The field of the record; empty where there is no record.
    pub name: String,
    /// The registers of its rows.
    pub rows: Vec<Range<usize>>,
}
