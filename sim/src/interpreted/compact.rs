//! Programs on as few bits for a register as they need: what a register's number can reach is there, and no access has to be
//! checked.

use codegen::emit::bytecode::{Code, Instruction, LookUp, Wave, Waves};
use sim_kernel::Scalar;

/// The number of a register.
pub(super) trait Register: Copy {
    /// All registers that there can be.
    type File<S: Scalar>: ?Sized;

    /// The first of so many registers, as all that there are; none if these are too few.
    fn file<S: Scalar>(registers: &mut [S]) -> Option<&mut Self::File<S>>;
    /// How many registers a program on so many needs.
    fn room(registers: usize) -> usize;
    fn read<S: Scalar>(self, file: &Self::File<S>) -> S;
    fn write<S: Scalar>(self, file: &mut Self::File<S>, value: S);
}

macro_rules! register {
    ($number:ty, $count:literal) => {
        impl Register for $number {
            type File<S: Scalar> = [S; $count];

            fn file<S: Scalar>(registers: &mut [S]) -> Option<&mut [S; $count]> {
                registers.first_chunk_mut()
            }
            fn room(_: usize) -> usize {
                $count
            }
            #[inline(always)]
            fn read<S: Scalar>(self, file: &[S; $count]) -> S {
                file[self as usize]
            }
            #[inline(always)]
            fn write<S: Scalar>(self, file: &mut [S; $count], value: S) {
                file[self as usize] = value;
            }
        }
    };
}

register!(u8, 256);
register!(u16, 65536);

impl Register for u32 {
    type File<S: Scalar> = [S];

    fn file<S: Scalar>(registers: &mut [S]) -> Option<&mut [S]> {
        Some(registers)
    }
    fn room(registers: usize) -> usize {
        registers
    }
    #[inline(always)]
    fn read<S: Scalar>(self, file: &[S]) -> S {
        file[self as usize]
    }
    #[inline(always)]
    fn write<S: Scalar>(self, file: &mut [S], value: S) {
        file[self as usize] = value;
    }
}

/// Instructions on registers `R`.
#[derive(Debug)]
pub(super) struct Body<R> {
    pub(super) instructions: Vec<Instruction<R>>,
    pub(super) waves: Vec<Waves<R>>,
    pub(super) look_ups: Vec<LookUp<R>>,
}

/// Instructions on registers whose numbers are as short as possible.
#[derive(Debug)]
pub(super) enum Compact {
    Few(Body<u8>),
    Many(Body<u16>),
    Any(Body<u32>),
}

impl Compact {
    pub(super) fn of(code: &Code) -> Compact {
        match code.registers {
            ..=0x100 => Compact::Few(body(code, |register| register as u8)),
            0x101..=0x1_0000 => Compact::Many(body(code, |register| register as u16)),
            _ => Compact::Any(body(code, |register| register)),
        }
    }
}

fn body<R: Copy>(code: &Code, number: impl Fn(u32) -> R) -> Body<R> {
    let wave = |wave: &Wave<u32>| Wave { angle: number(wave.angle), sin: number(wave.sin), cos: number(wave.cos) };
    let look_up = |found: &LookUp<u32>| LookUp { table: found.table, to: found.to.map(&number), count: found.count };
    Body {
        instructions: code.instructions.iter().map(|each| each.map(&mut |register, _| number(register))).collect(),
        waves: code.waves.iter().map(|waves| waves.iter().map(wave).collect()).collect(),
        look_ups: code.look_ups.iter().map(look_up).collect(),
    }
}
