//! A program at many states: each instruction is read once for a block of them, and done by vector
//! instructions.

use super::block_sums::BlockSum;
use super::compact::{Body, body};
use super::execute::{Given, step};
use super::one_program::Places;
use crate::{Results, States};
use codegen::emit::bytecode::{Code, Instruction, Wave};
use codegen::kernel_id::Argument;
use sim_kernel::{Input, Lanes, Scalar, Table, Work, pivot_is_refused, sin_cos_of_block};
use std::ops::Range;

/// How many states a block has. Not a power of two: registers would stand such a number of bytes apart, and loads would wait for
/// stores whose addresses have the same lowest 12 bits.
const STATES: usize = 72;

/// A number at each of them.
type Block = Lanes<STATES>;

/// A program, and what it reads besides the states.
#[derive(Clone, Copy)]
pub(super) struct OfMany<'a> {
    pub(super) code: &'a Code,
    pub(super) places: &'a Places,
    /// What the program begins with.
    pub(super) image: &'a [f64],
    pub(super) inputs: &'a [Input],
    pub(super) tables: &'a [Table],
    pub(super) states: &'a States<'a>,
}

impl Work for OfMany<'_> {
    type Output = Results;

    #[inline(always)]
    fn run<const AT_ONCE: usize>(self) -> Results {
        let OfMany { code, places, states, .. } = self;
        let inputs: Vec<Input<Block>> = self.inputs.iter().map(|input| input.map(Block::from_f64)).collect();
        let given = Given::at_rest(&inputs, self.tables);
        // Programs do not write to the registers that they begin with.
        let mut registers: Vec<Block> = self.image.iter().map(|number| Block::from_f64(*number)).collect();
        registers.resize(code.registers, Block::ZERO);
        let body = body(code, |register| register);
        let sums: Vec<BlockSum> = body.sums.iter().map(|sum| BlockSum::of(sum, self.image)).collect();
        let width: usize = places.rows.iter().map(ExactSizeIterator::len).sum();
        let count = states.times.len();
        let (mut numbers, mut refusals) = (Vec::with_capacity(width * count), Vec::new());
        for first in (0..count).step_by(STATES) {
            let filled = STATES.min(count - first);
            gather(code, states, first, filled, &mut registers);
            execute(&body, &sums, &given, &mut registers);
            // Block by block, so that they are in the cache when they are written.
            numbers.resize((first + filled) * width, 0.0);
            scatter(&registers, &places.rows, &mut numbers[first * width..], width);
            each_refused(places, &registers, |lane| {
                if lane < filled {
                    refusals.push(first + lane);
                }
            });
        }
        Results { rows: places.rows.iter().map(ExactSizeIterator::len).collect(), numbers, refused: refusals }
    }
}

/// Executes a program on registers that hold its image.
#[inline(always)]
fn execute(body: &Body<u32>, sums: &[BlockSum], given: &Given<Block>, registers: &mut [Block]) {
    for group in &body.groups {
        for sum in &sums[group.sums.clone()] {
            sum.execute(registers);
        }
        match group.last {
            Some(Instruction::Waves { place }) => {
                for wave in &body.lists().waves[place as usize] {
                    sin_cos(*wave, registers);
                }
            }
            Some(last) => step::<_, _, true>(last, body.lists(), given, registers),
            None => {}
        }
    }
}

#[inline(always)]
fn sin_cos(Wave { angle, sin, cos }: Wave<u32>, registers: &mut [Block]) {
    // Angles, sines and cosines have registers of their own.
    let Ok([angles, sines, cosines]) = registers.get_disjoint_mut([angle, sin, cos].map(|register| register as usize))
    else {
        return;
    };
    sin_cos_of_block(angles.as_array(), sines.as_array_mut(), cosines.as_array_mut());
}

/// Finds the states of a block that a program refuses.
#[inline(always)]
fn each_refused(places: &Places, registers: &[Block], found: impl FnMut(usize)) {
    let is_refused = |state: usize| places.refused(|register| registers[register as usize].lane(state));
    if places.pivots.as_ref().is_none_or(|pivots| is_any_refused(pivots, registers)) {
        (0..STATES).filter(|state| is_refused(*state)).for_each(found);
    }
}

#[inline(always)]
fn is_any_refused(pivots: &[[u32; 2]], registers: &[Block]) -> bool {
    // As wide as the numbers, so that vectors hold both.
    let mut any = 0u64;
    for [pivot, terms] in pivots {
        let [pivot, terms] = [pivot, terms].map(|register| registers[*register as usize].as_array());
        for state in 0..STATES {
            any |= u64::from(pivot_is_refused(pivot[state], terms[state]));
        }
    }
    any != 0
}

/// The results of a block, state by state.
#[inline(always)]
fn scatter(registers: &[Block], rows: &[Range<usize>], numbers: &mut [f64], width: usize) {
    let mut at = 0;
    for row in rows {
        for register in &registers[row.clone()] {
            put(register, at, width, numbers);
            at += 1;
        }
    }
}

/// Takes the arguments of so many states from the first on. Omitted ones are zero; other lanes keep what they hold.
#[inline(always)]
fn gather(code: &Code, states: &States, first: usize, filled: usize, registers: &mut [Block]) {
    let arguments = &mut registers[code.constants.len() + code.fields.len()..];
    for (register, (argument, at)) in arguments.iter_mut().zip(&code.arguments) {
        let numbers = match argument {
            Argument::Time => states.times,
            Argument::Positions => states.positions,
            // Generalised speeds stand in their place.
            Argument::Speeds | Argument::GeneralizedSpeeds => states.speeds,
            Argument::Accelerations => states.accelerations,
            Argument::Multipliers => states.multipliers,
        };
        let width = numbers.len() / states.times.len();
        if width == 0 {
            continue;
        }
        take(register, *at, width, &numbers[first * width..][..filled * width]);
    }
}

/// Calls a function with the width of a state as a constant, up to some: the numbers of all states then stand where the
/// compiler knows, and it moves several at once.
macro_rules! with_width {
    ($function:ident, $width:expr, $arguments:tt) => {
        with_width!($function, $width, $arguments, 1 2 3 4 5 6 7 8 9 10 11 12)
    };
    ($function:ident, $width:expr, $arguments:tt, $($constant:literal)*) => {
        match $width {
            $($constant => $function::<$constant> $arguments,)*
            _ => None,
        }
    };
}

/// Takes a number of each state.
#[inline(always)]
fn take(register: &mut Block, at: usize, width: usize, numbers: &[f64]) {
    if with_width!(take_of_all, width, (register, at, numbers)).is_none() {
        for (lane, state) in numbers.chunks_exact(width).enumerate() {
            register.set_lane(lane, state[at]);
        }
    }
}

/// The same of a whole block of states; nothing if it is none.
#[inline(always)]
fn take_of_all<const WIDTH: usize>(register: &mut Block, at: usize, numbers: &[f64]) -> Option<()> {
    let states: &[[f64; WIDTH]; STATES] = numbers.as_chunks().0.first_chunk()?;
    (at < WIDTH).then(|| *register = Block::from_fn(|lane| states[lane][at]))
}

/// Puts a number of each state.
#[inline(always)]
fn put(register: &Block, at: usize, width: usize, numbers: &mut [f64]) {
    if with_width!(put_to_all, width, (register, at, numbers)).is_none() {
        for (lane, state) in numbers.chunks_exact_mut(width).enumerate() {
            state[at] = register.lane(lane);
        }
    }
}

/// The same to a whole block of states; nothing if it is none.
#[inline(always)]
fn put_to_all<const WIDTH: usize>(register: &Block, at: usize, numbers: &mut [f64]) -> Option<()> {
    let states: &mut [[f64; WIDTH]; STATES] = numbers.as_chunks_mut().0.first_chunk_mut()?;
    (at < WIDTH).then(|| (0..STATES).for_each(|lane| states[lane][at] = register.lane(lane)))
}
