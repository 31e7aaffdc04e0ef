//! A program at many states: each instruction is read once for a block of them, and done by the widest vector
//! instructions that the processor has.

use super::execute::{Given, execute, refused};
use crate::numerics::vectors::{Vectors, Work};
use crate::{Results, States};
use codegen::emit::bytecode::Code;
use sim_kernel::{Input, Lanes, Mask, Scalar, Table};
use std::ops::Range;

/// How many states a block has.
const STATES: usize = 64;

/// A number at each of them.
type Block = Lanes<STATES>;

/// A program, and what it reads besides the states.
#[derive(Clone, Copy)]
pub(super) struct OfMany<'a> {
    pub(super) code: &'a Code,
    /// What the program begins with.
    pub(super) image: &'a [f64],
    pub(super) inputs: &'a [Input],
    pub(super) tables: &'a [Table],
    /// The rows of the results, in their order.
    pub(super) rows: &'a [Range<usize>],
    pub(super) states: &'a States<'a>,
}

impl OfMany<'_> {
    /// The results at all states.
    pub(super) fn results(self) -> Results {
        Vectors::widest().run(self)
    }
}

impl Work for OfMany<'_> {
    type Output = Results;

    #[inline(always)]
    fn run(self) -> Results {
        let OfMany { code, states, .. } = self;
        let inputs: Vec<Input<Block>> = self.inputs.iter().map(|input| input.map(Block::from_f64)).collect();
        // Programs do not write to the registers that they begin with.
        let mut registers: Vec<Block> = self.image.iter().map(|number| Block::from_f64(*number)).collect();
        registers.resize(code.registers, Block::ZERO);
        let mut levels = Levels::new(states);
        let width: usize = self.rows.iter().map(ExactSizeIterator::len).sum();
        let count = states.times.len();
        let (mut numbers, mut refusals) = (vec![0.0; width * count], Vec::new());
        for first in (0..count).step_by(STATES) {
            let filled = STATES.min(count - first);
            levels.fill(states, first, filled);
            execute::<_, true>(code, &levels.given(&inputs, self.tables), &mut registers);
            scatter(&registers, self.rows, &mut numbers[first * width..][..filled * width], width);
            let is_refused = refused(code, &registers);
            if is_refused.any() {
                refusals.extend((0..filled).filter(|lane| is_refused.lane(*lane)).map(|lane| first + lane));
            }
        }
        Results { rows: self.rows.iter().map(ExactSizeIterator::len).collect(), numbers, refused: refusals }
    }
}

/// The results of a block, state by state.
#[inline(always)]
fn scatter(registers: &[Block], rows: &[Range<usize>], numbers: &mut [f64], width: usize) {
    let mut at = 0;
    for row in rows {
        for register in &registers[row.clone()] {
            for (lane, state) in numbers.chunks_exact_mut(width).enumerate().take(STATES) {
                state[at] = register.lane(lane);
            }
            at += 1;
        }
    }
}

/// The numbers of a block of states.
struct Levels {
    time: Block,
    /// Positions, speeds, accelerations and multipliers.
    levels: [Vec<Block>; 4],
}

impl Levels {
    fn new(states: &States) -> Levels {
        let count = states.times.len().max(1);
        let of = |numbers: &[f64]| vec![Block::ZERO; numbers.len() / count];
        Levels { time: Block::ZERO, levels: of_states(states).map(of) }
    }

    /// Takes so many states from the first on. Other lanes keep what they hold.
    #[inline(always)]
    fn fill(&mut self, states: &States, first: usize, filled: usize) {
        for lane in 0..filled {
            self.time.set_lane(lane, states.times[first + lane]);
        }
        for (level, numbers) in self.levels.iter_mut().zip(of_states(states)) {
            let width = level.len();
            let of_block = &numbers[first * width..][..filled * width];
            for (i, block) in level.iter_mut().enumerate() {
                for (lane, state) in of_block.chunks_exact(width).enumerate().take(STATES) {
                    block.set_lane(lane, state[i]);
                }
            }
        }
    }

    fn given<'a>(&'a self, inputs: &'a [Input<Block>], tables: &'a [Table]) -> Given<'a, Block> {
        let [positions, speeds, accelerations, multipliers] = &self.levels;
        Given {
            time: self.time,
            positions,
            speeds,
            accelerations,
            multipliers,
            generalized_speeds: speeds,
            parameters: &[],
            activities: &[],
            inputs,
            prepared: &[],
            tables,
        }
    }
}

fn of_states<'a>(states: &States<'a>) -> [&'a [f64]; 4] {
    [states.positions, states.speeds, states.accelerations, states.multipliers]
}
