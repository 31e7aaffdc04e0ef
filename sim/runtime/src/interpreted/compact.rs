//! Programs on as few bits for a register as they need: what a register's number can reach is there, and no access has to be
//! checked.

use codegen::emit::bytecode::{Code, Instruction, LookUp, MINUS_ZERO, ONE, Wave, Waves};
use sim_kernel::Scalar;
use std::ops::Range;

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

/// What some instructions refer to.
#[derive(Clone, Copy)]
pub(super) struct Lists<'a, R> {
    pub(super) waves: &'a [Waves<R>],
    pub(super) look_ups: &'a [LookUp<R>],
}

impl<'a> Lists<'a, u32> {
    pub(super) fn of(code: &'a Code) -> Self {
        Lists { waves: &code.waves, look_ups: &code.look_ups }
    }
}

/// a + b c, or a - b c.
#[derive(Clone, Copy, Debug)]
pub(super) struct SumOfProduct<R> {
    pub(super) to: R,
    pub(super) a: R,
    pub(super) b: R,
    pub(super) c: R,
    pub(super) is_negative: bool,
}

impl<R: Register> SumOfProduct<R> {
    #[inline(always)]
    pub(super) fn execute(self, file: &mut R::File<f64>) {
        let sign = u64::from(self.is_negative) << 63;
        let product = self.b.read(file) * self.c.read(file);
        self.to.write(file, self.a.read(file) + f64::from_bits(product.to_bits() ^ sign));
    }
}

/// Sums of products, and then what is no such sum.
#[derive(Clone, Debug)]
pub(super) struct Group<R> {
    pub(super) sums: Range<usize>,
    pub(super) last: Option<Instruction<R>>,
}

/// A program for numbers. Most of it are sums, differences and products of two: all of them are written as a + b c, with -0
/// for what is not added and 1 for what is not multiplied, which changes no bit. A processor need not guess then which
/// operation comes next: in long programs wrong guesses take longer than the operations.
#[derive(Debug)]
pub(super) struct Body<R> {
    pub(super) groups: Vec<Group<R>>,
    pub(super) sums: Vec<SumOfProduct<R>>,
    waves: Vec<Waves<R>>,
    look_ups: Vec<LookUp<R>>,
}

impl<R> Body<R> {
    pub(super) fn lists(&self) -> Lists<'_, R> {
        Lists { waves: &self.waves, look_ups: &self.look_ups }
    }
}

/// Instructions on registers whose numbers are as short as possible.
#[derive(Debug)]
pub(super) enum Compact {
    Few(Body<u8>),
    Many(Body<u16>),
    Any(Body<u32>),
}

impl Compact {
    /// How many registers it has to be given.
    pub(super) fn room(&self, registers: usize) -> usize {
        match self {
            Compact::Few(_) => u8::room(registers),
            Compact::Many(_) => u16::room(registers),
            Compact::Any(_) => u32::room(registers),
        }
    }

    pub(super) fn of(code: &Code) -> Compact {
        match code.registers {
            ..=0x100 => Compact::Few(body(code, |register| register as u8)),
            0x101..=0x1_0000 => Compact::Many(body(code, |register| register as u16)),
            _ => Compact::Any(body(code, |register| register)),
        }
    }
}

pub(super) fn body<R: Copy>(code: &Code, number: impl Fn(u32) -> R) -> Body<R> {
    let wave = |wave: &Wave<u32>| Wave { angle: number(wave.angle), sin: number(wave.sin), cos: number(wave.cos) };
    let look_up = |found: &LookUp<u32>| LookUp { table: found.table, to: found.to.map(&number), count: found.count };
    let (mut groups, mut sums) = (Vec::new(), Vec::new());
    let mut first = 0;
    for instruction in &code.instructions {
        let short = instruction.map(&mut |register, _| number(register));
        match sum_of_product(short, number(MINUS_ZERO), number(ONE)) {
            Some(sum) => sums.push(sum),
            None => {
                groups.push(Group { sums: first..sums.len(), last: Some(short) });
                first = sums.len();
            }
        }
    }
    groups.push(Group { sums: first..sums.len(), last: None });
    Body {
        groups,
        sums,
        waves: code.waves.iter().map(|waves| waves.iter().map(wave).collect()).collect(),
        look_ups: code.look_ups.iter().map(look_up).collect(),
    }
}

/// An instruction as a + b c, with the same bits.
fn sum_of_product<R: Copy>(instruction: Instruction<R>, minus_zero: R, one: R) -> Option<SumOfProduct<R>> {
    let (to, a, b, c, is_negative) = match instruction {
        Instruction::Copy { to, a } => (to, minus_zero, a, one, false),
        Instruction::Negate { to, a } => (to, minus_zero, a, one, true),
        Instruction::Add { to, a, b } => (to, a, b, one, false),
        Instruction::Subtract { to, a, b } => (to, a, b, one, true),
        Instruction::Multiply { to, a, b } => (to, minus_zero, a, b, false),
        Instruction::AddProduct { to, a, b, c } => (to, a, b, c, false),
        Instruction::SubtractProduct { to, a, b, c } => (to, a, b, c, true),
        _ => return None,
    };
    Some(SumOfProduct { to, a, b, c, is_negative })
}
