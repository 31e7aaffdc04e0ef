//! The order of instructions. A processor that executes them one by one looks at some twenty ahead, and a number that has just
//! been written to a register takes it several cycles to read: instructions that need each other should stand apart.

use super::instruction::{Access, Instruction};
use super::parts::{Parts, Place};
use rustc_hash::FxHashMap;
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// The cycles from one instruction to the next, where none waits.
const ISSUE: u32 = 4;
/// The cycles from writing a register to having read it.
const FORWARD: u32 = 7;

/// A result that an instruction takes, by the number of what writes it, and the cycles from there to its own result.
type Need = (usize, u32);

/// The instructions by list scheduling: of those whose operands are there, the one with the longest way to the end comes
/// first. Every place is written once, so the instructions may stand in any order in which what is read has been written.
pub(super) fn scheduled(parts: &Parts) -> Vec<Instruction<Place>> {
    let needs = needs(parts);
    let urgency = urgency(&needs);
    let mut needed_by: Vec<Vec<Need>> = vec![Vec::new(); needs.len()];
    let mut missing: Vec<usize> = needs.iter().map(Vec::len).collect();
    for (at, needs) in needs.iter().enumerate() {
        needs.iter().for_each(|(from, cycles)| needed_by[*from].push((at, *cycles)));
    }
    // When each can have its result.
    let mut done = vec![0; needs.len()];
    let (mut waiting, mut ready) = (BinaryHeap::new(), BinaryHeap::new());
    waiting.extend((0..needs.len()).filter(|at| missing[*at] == 0).map(|at| Reverse((0, at))));
    let (mut order, mut now) = (Vec::with_capacity(needs.len()), 0);
    loop {
        while let Some(Reverse((when, at))) = waiting.peek().copied()
            && (when <= now || ready.is_empty())
        {
            waiting.pop();
            ready.push((urgency[at], Reverse(at)));
        }
        let Some((_, Reverse(at))) = ready.pop() else { return order };
        order.push(parts.instructions[at]);
        done[at] = done[at].max(now);
        now += ISSUE;
        for &(after, cycles) in &needed_by[at] {
            done[after] = done[after].max(done[at] + cycles);
            missing[after] -= 1;
            if missing[after] == 0 {
                waiting.push(Reverse((done[after], after)));
            }
        }
    }
}

/// The cycles from each result to the last that depends on it.
fn urgency(needs: &[Vec<Need>]) -> Vec<u32> {
    let mut urgency = vec![0; needs.len()];
    for (at, needs) in needs.iter().enumerate().rev() {
        for (from, cycles) in needs {
            urgency[*from] = urgency[*from].max(urgency[at] + cycles);
        }
    }
    urgency
}

/// What each instruction needs of those before it.
fn needs(parts: &Parts) -> Vec<Vec<Need>> {
    let mut writers: FxHashMap<Place, usize> = FxHashMap::default();
    let mut needs = Vec::with_capacity(parts.instructions.len());
    for (at, instruction) in parts.instructions.iter().enumerate() {
        let (mut read, mut written) = (Vec::new(), Vec::new());
        instruction.map(&mut |place, access| {
            if access == Access::Read { read.push(place) } else { written.push(place) }
        });
        match instruction {
            Instruction::Waves { place } => {
                for wave in &parts.waves[*place as usize] {
                    read.push(wave.angle);
                    written.extend([wave.sin, wave.cos]);
                }
            }
            Instruction::LookUp { place, .. } => written.extend(parts.look_ups[*place as usize].to),
            _ => {}
        }
        let need = |(operand, place)| Some((*writers.get(place)?, FORWARD + latency(instruction, operand)));
        needs.push(read.iter().enumerate().filter_map(need).collect());
        writers.extend(written.into_iter().map(|place| (place, at)));
    }
    needs
}

/// The cycles from an operand, by its number, to the result.
fn latency<R>(instruction: &Instruction<R>, operand: usize) -> u32 {
    use Instruction as I;
    match instruction {
        I::Add { .. } | I::Subtract { .. } | I::AddProduct { .. } | I::SubtractProduct { .. } if operand == 0 => 3,
        I::Copy { .. } | I::Negate { .. } | I::Add { .. } | I::Subtract { .. } => 7,
        I::Multiply { .. } | I::AddProduct { .. } | I::SubtractProduct { .. } => 7,
        I::Choose { .. } | I::Held { .. } => 7,
        I::Divide { .. } => 13,
        I::SquareRoot { .. } | I::LookUp { .. } => 20,
        I::Call { .. } | I::Power { .. } | I::Atan2 { .. } | I::Waves { .. } => 60,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// x^2, x^3, x^4 and y^2, y^3, y^4, written one after the other.
    #[test]
    fn independent_chains_are_interleaved() {
        let power = |argument: usize, k: usize| {
            let a = if k == 0 { Place::Argument(argument) } else { Place::Local(3 * argument + k - 1) };
            Instruction::Multiply { to: Place::Local(3 * argument + k), a, b: Place::Argument(argument) }
        };
        let [x, y] = [0, 1].map(|argument| [0, 1, 2].map(|k| power(argument, k)));
        let parts = Parts { instructions: [x, y].concat(), waves: Vec::new(), look_ups: Vec::new() };
        assert_eq!(scheduled(&parts), [x[0], y[0], x[1], y[1], x[2], y[2]]);
    }

    /// The quotient is needed by more that follows than the sum is.
    #[test]
    fn the_longest_way_to_the_end_comes_first() {
        let [x, sum, quotient] = [Place::Argument(0), Place::Local(0), Place::Local(1)];
        let add = Instruction::Add { to: sum, a: x, b: x };
        let divide = Instruction::Divide { to: quotient, a: x, b: x };
        let copy = Instruction::Copy { to: Place::Result(0), a: quotient };
        let negate = Instruction::Negate { to: Place::Result(1), a: Place::Result(0) };
        let multiply = Instruction::Multiply { to: Place::Result(2), a: sum, b: quotient };
        let instructions = vec![add, divide, copy, negate, multiply];
        let parts = Parts { instructions, waves: Vec::new(), look_ups: Vec::new() };
        assert_eq!(scheduled(&parts)[..2], [divide, add]);
    }
}
