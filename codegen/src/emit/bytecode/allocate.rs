//! Registers for values: one is taken again as soon as its value has been used for the last time, so that few are needed.

use super::instruction::{Access, Instruction, Wave};

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
}

/// A program on registers.
pub(super) struct Allocated {
    pub(super) instructions: Vec<Instruction<u32>>,
    pub(super) waves: Vec<Wave<u32>>,
    pub(super) first_result: usize,
    pub(super) registers: usize,
}

/// Gives every value a register.
pub(super) fn allocate(instructions: &[Instruction<Place>], waves: &[Wave<Place>], sizes: Sizes) -> Allocated {
    let (last_uses, mut homes) = (last_uses(instructions, waves, sizes.locals), Homes::new(sizes));
    // Results follow the locals, whose number is known in the end.
    let mut allocated: Vec<Instruction<Place>> = Vec::with_capacity(instructions.len());
    let mut allocated_waves: Vec<Wave<Place>> = Vec::with_capacity(waves.len());
    for (at, instruction) in instructions.iter().enumerate() {
        let ends = |local: usize| last_uses[local].is_none_or(|last| last == at);
        let mut touched: Vec<usize> = Vec::new();
        if let Instruction::Waves { first, count } = instruction {
            for wave in &waves[*first..*first + *count] {
                // All angles are kept until all sines are there: several are evaluated together.
                let [angle, sin, cos] = [wave.angle, wave.sin, wave.cos].map(|place| homes.of(place, &mut touched));
                allocated_waves.push(Wave { angle, sin, cos });
            }
        }
        allocated.push(instruction.map(&mut |place, access| {
            if access == Access::Write {
                // All operands have been read by now.
                homes.leave(touched.drain(..).filter(|local| ends(*local)));
            }
            homes.of(place, &mut touched)
        }));
        homes.leave(touched.drain(..).filter(|local| ends(*local)));
    }
    let first_result = sizes.before_locals() + homes.count;
    let register = |place: Place| match place {
        Place::Constant(at) => at,
        Place::Field(at) => sizes.constants + at,
        Place::Argument(at) => sizes.constants + sizes.fields + at,
        Place::Local(at) => sizes.before_locals() + at,
        Place::Result(at) => first_result + at,
    } as u32;
    Allocated {
        instructions: allocated.into_iter().map(|each| each.map(&mut |place, _| register(place))).collect(),
        waves: allocated_waves
            .into_iter()
            .map(|Wave { angle, sin, cos }| Wave { angle: register(angle), sin: register(sin), cos: register(cos) })
            .collect(),
        first_result,
        registers: first_result + sizes.results,
    }
}

/// The last instruction that reads each local; `None` where none does.
fn last_uses(instructions: &[Instruction<Place>], waves: &[Wave<Place>], locals: usize) -> Vec<Option<usize>> {
    let mut last_uses = vec![None; locals];
    for (at, instruction) in instructions.iter().enumerate() {
        let mut read = |place: Place| {
            if let Place::Local(local) = place {
                last_uses[local] = Some(at);
            }
        };
        if let Instruction::Waves { first, count } = instruction {
            waves[*first..*first + *count].iter().for_each(|wave| read(wave.angle));
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
