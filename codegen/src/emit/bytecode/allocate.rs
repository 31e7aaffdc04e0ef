//! Registers for values: one is taken again as soon as its value has been used for the last time, so that few are needed.

use super::instruction::{Access, Instruction, LookUp, Wave, Waves};
use super::parts::{Parts, Place};

/// How many registers hold constants, fields, arguments and results.
#[derive(Clone, Copy)]
pub(super) struct Sizes {
    pub(super) constants: usize,
    pub(super) fields: usize,
    pub(super) arguments: usize,
    pub(super) locals: usize,
    pub(super) results: usize,
}

impl Sizes {
    fn before_locals(self) -> usize {
        self.constants + self.fields + self.arguments
    }

    /// The number of a register, where those of results begin with this one.
    pub(super) fn register(self, place: Place, first_result: usize) -> u32 {
        let register = match place {
            Place::Constant(at) => at,
            Place::Field(at) => self.constants + at,
            Place::Argument(at) => self.constants + self.fields + at,
            Place::Local(at) => self.before_locals() + at,
            Place::Result(at) => first_result + at,
        };
        register as u32
    }
}

/// A program on registers.
pub(super) struct Allocated {
    pub(super) instructions: Vec<Instruction<u32>>,
    pub(super) waves: Vec<Waves<u32>>,
    pub(super) look_ups: Vec<LookUp<u32>>,
    pub(super) first_result: usize,
    pub(super) registers: usize,
}

/// Gives every value a register.
pub(super) fn allocate(Parts { instructions, waves, look_ups }: &Parts, sizes: Sizes) -> Allocated {
    let (last_uses, mut homes) = (last_uses(instructions, waves, sizes.locals), Homes::new(sizes));
    // Results follow the locals, whose number is known in the end.
    let mut allocated: Vec<Instruction<Place>> = Vec::with_capacity(instructions.len());
    let (mut waves, mut look_ups) = (waves.clone(), look_ups.clone());
    for (at, instruction) in instructions.iter().enumerate() {
        let ends = |local: usize| last_uses[local].is_none_or(|last| last == at);
        let mut touched: Vec<usize> = Vec::new();
        if let Instruction::Waves { place } = instruction {
            for wave in &mut waves[*place as usize] {
                // All angles are kept until all sines are there: several are evaluated together.
                for place in [&mut wave.angle, &mut wave.sin, &mut wave.cos] {
                    *place = homes.of(*place, &mut touched);
                }
            }
        }
        // A value does not overwrite an operand: a block of states is then computed without a copy.
        allocated.push(instruction.map(&mut |place, _| homes.of(place, &mut touched)));
        if let Instruction::LookUp { place, .. } = instruction {
            look_ups[*place as usize].to.iter_mut().for_each(|to| *to = homes.of(*to, &mut touched));
        }
        homes.leave(touched.drain(..).filter(|local| ends(*local)));
    }
    let first_result = sizes.before_locals() + homes.count;
    let register = |place| sizes.register(place, first_result);
    let wave =
        |Wave { angle, sin, cos }: Wave<Place>| Wave { angle: register(angle), sin: register(sin), cos: register(cos) };
    Allocated {
        instructions: allocated.into_iter().map(|each| each.map(&mut |place, _| register(place))).collect(),
        waves: waves.into_iter().map(|waves| waves.into_iter().map(wave).collect()).collect(),
        look_ups: look_ups
            .into_iter()
            .map(|LookUp { table, to, count }| LookUp { table, to: to.map(register), count })
            .collect(),
        first_result,
        registers: first_result + sizes.results,
    }
}

/// The last instruction that reads each local; `None` where none does.
fn last_uses(instructions: &[Instruction<Place>], waves: &[Waves<Place>], locals: usize) -> Vec<Option<usize>> {
    let mut last_uses = vec![None; locals];
    for (at, instruction) in instructions.iter().enumerate() {
        let mut read = |place: Place| {
            if let Place::Local(local) = place {
                last_uses[local] = Some(at);
            }
        };
        if let Instruction::Waves { place } = instruction {
            waves[*place as usize].iter().for_each(|wave| read(wave.angle));
        }
        instruction.map(&mut |place, access| {
            if access == Access::Read {
                read(place);
            }
            place
        });
    }
    last_uses
}

/// The registers of the locals that are alive.
struct Homes {
    of: Vec<Option<usize>>,
    free: Vec<usize>,
    /// How many there are.
    count: usize,
}

impl Homes {
    fn new(sizes: Sizes) -> Homes {
        Homes { of: vec![None; sizes.locals], free: Vec::new(), count: 0 }
    }

    /// The place of a value; one of its own is found for a local that has none.
    fn of(&mut self, place: Place, touched: &mut Vec<usize>) -> Place {
        let Place::Local(local) = place else { return place };
        touched.push(local);
        let home = self.of[local].or_else(|| self.free.pop()).unwrap_or_else(|| {
            self.count += 1;
            self.count - 1
        });
        self.of[local] = Some(home);
        Place::Local(home)
    }

    /// Frees the registers of these locals.
    fn leave(&mut self, locals: impl Iterator<Item = usize>) {
        for local in locals {
            self.free.extend(self.of[local].take());
        }
    }
}
