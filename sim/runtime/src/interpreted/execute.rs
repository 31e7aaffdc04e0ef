//! The execution of a program: each instruction as generated Rust does it, so that the bits are the same.

use super::compact::{Body, Compact, Lists, Register};
use codegen::emit::bytecode::{Code, Field, Instruction, LookUp, Wave};
use codegen::kernel_id::Argument;
use codegen::symbolic::Function;
use sim_kernel::{Input, Scalar, Table};

/// What programs read: the state, and what the mechanism is set to.
#[derive(Clone, Copy)]
pub(super) struct Given<'a, S> {
    pub(super) time: S,
    pub(super) positions: &'a [S],
    pub(super) speeds: &'a [S],
    pub(super) accelerations: &'a [S],
    pub(super) multipliers: &'a [S],
    pub(super) generalized_speeds: &'a [S],
    pub(super) parameters: &'a [S],
    pub(super) activities: &'a [S],
    pub(super) inputs: &'a [Input<S>],
    /// Results of the kernel that prepares.
    pub(super) prepared: &'a [S],
    pub(super) tables: &'a [Table],
}

impl<'a, S: Scalar> Given<'a, S> {
    /// Without a state: all else of it is zero.
    pub(super) fn at_rest(inputs: &'a [Input<S>], tables: &'a [Table]) -> Self {
        Given {
            time: S::ZERO,
            positions: &[],
            speeds: &[],
            accelerations: &[],
            multipliers: &[],
            generalized_speeds: &[],
            parameters: &[],
            activities: &[],
            inputs,
            prepared: &[],
            tables,
        }
    }
}

/// What a program begins with: constants, and what it reads of the mechanism.
pub(super) fn image<S: Scalar>(code: &Code, given: &Given<S>) -> Vec<S> {
    let constants = code.constants.iter().map(|constant| S::from_f64(*constant));
    let fields = code.fields.iter().map(|field| match *field {
        Field::Parameter(at) => given.parameters[at],
        Field::Activity(at) => given.activities[at],
        Field::Prepared(at) => given.prepared[at],
    });
    constants.chain(fields).collect()
}

/// Executes a program on numbers, from an image on. Results stand in their registers.
pub(super) fn execute_compact(
    code: &Code,
    compact: &Compact,
    image: &[f64],
    given: &Given<f64>,
    registers: &mut [f64],
) {
    registers[..image.len()].copy_from_slice(image);
    load(code, given, registers);
    match compact {
        Compact::Few(body) => execute_groups(body, given, registers),
        Compact::Many(body) => execute_groups(body, given, registers),
        Compact::Any(body) => execute_groups(body, given, registers),
    }
}

fn execute_groups<R: Register>(body: &Body<R>, given: &Given<f64>, registers: &mut [f64]) {
    // There is always room.
    let Some(file) = R::file(registers) else { return };
    for group in &body.groups {
        for sum in &body.sums[group.sums.clone()] {
            sum.execute(file);
        }
        if let Some(last) = group.last {
            step::<_, _, false>(last, body.lists(), given, file);
        }
    }
}

/// Executes a program on registers that hold its image. A block of states is inlined into code for wide vector instructions
/// as a whole, and fills them by itself.
#[inline(always)]
pub(super) fn execute<S: Scalar, const IS_BLOCK: bool>(code: &Code, given: &Given<S>, registers: &mut [S]) {
    load(code, given, registers);
    for instruction in &code.instructions {
        step::<S, u32, IS_BLOCK>(*instruction, Lists::of(code), given, registers);
    }
}

/// Takes the arguments. Omitted ones are zero.
#[inline(always)]
fn load<S: Scalar>(code: &Code, given: &Given<S>, registers: &mut [S]) {
    let arguments = &mut registers[code.constants.len() + code.fields.len()..];
    for (register, (argument, at)) in arguments.iter_mut().zip(&code.arguments) {
        let numbers = match argument {
            Argument::Time => std::slice::from_ref(&given.time),
            Argument::Positions => given.positions,
            Argument::Speeds => given.speeds,
            Argument::Accelerations => given.accelerations,
            Argument::Multipliers => given.multipliers,
            Argument::GeneralizedSpeeds => given.generalized_speeds,
        };
        *register = numbers.get(*at).copied().unwrap_or(S::ZERO);
    }
}

#[inline(always)]
pub(super) fn step<S: Scalar, R: Register, const IS_BLOCK: bool>(
    instruction: Instruction<R>,
    lists: Lists<R>,
    given: &Given<S>,
    file: &mut R::File<S>,
) {
    use Instruction as I;
    let r = |at: R| at.read(file);
    let (to, value) = match instruction {
        I::Copy { to, a } => (to, r(a)),
        I::Negate { to, a } => (to, -r(a)),
        I::Add { to, a, b } => (to, r(a) + r(b)),
        I::Subtract { to, a, b } => (to, r(a) - r(b)),
        I::Multiply { to, a, b } => (to, r(a) * r(b)),
        I::Divide { to, a, b } => (to, r(a) / r(b)),
        I::AddProduct { to, a, b, c } => (to, r(a) + r(b) * r(c)),
        I::SubtractProduct { to, a, b, c } => (to, r(a) - r(b) * r(c)),
        I::SquareRoot { to, a } => (to, r(a).sqrt()),
        I::Call { function, to, a } if IS_BLOCK => (to, function_of(function, r(a))),
        I::Call { function, to, a } => (to, call(function, r(a))),
        I::Power { to, a, b } => (to, r(a).powf(r(b))),
        I::Atan2 { to, a, b } => (to, r(a).atan2(r(b))),
        I::Choose { to, a, b, c } => (to, r(a).choose(r(b), r(c))),
        I::Held { input, to, a } => (to, given.inputs[input as usize].or(r(a))),
        I::Waves { place } => return waves(&lists.waves[place as usize], file),
        I::LookUp { place, a } => return look_up(&lists.look_ups[place as usize], r(a), given.tables, file),
    };
    to.write(file, value);
}

#[inline(never)]
fn call<S: Scalar>(function: Function, x: S) -> S {
    function_of(function, x)
}

#[inline(always)]
fn function_of<S: Scalar>(function: Function, x: S) -> S {
    match function {
        Function::Sin => x.sin(),
        Function::Cos => x.cos(),
        Function::Tan => x.tan(),
        Function::Asin => x.asin(),
        Function::Acos => x.acos(),
        Function::Atan => x.atan(),
        Function::Sinh => x.sinh(),
        Function::Cosh => x.cosh(),
        Function::Tanh => x.tanh(),
        Function::Exp => x.exp(),
        Function::Ln => x.ln(),
        Function::Abs => x.abs(),
        Function::Sign => x.sign(),
    }
}

/// Sines and cosines of several angles: four at once, as far as there are so many.
#[inline(never)]
fn waves<S: Scalar, R: Register>(waves: &[Wave<R>], file: &mut R::File<S>) {
    let (fours, rest) = waves.as_chunks::<4>();
    fours.iter().for_each(|four| side_by_side(four, file));
    match *rest {
        [a, b, c] => side_by_side(&[a, b, c], file),
        [a, b] => side_by_side(&[a, b], file),
        [a] => side_by_side(&[a], file),
        _ => {}
    }
}

#[inline(always)]
fn side_by_side<S: Scalar, R: Register, const N: usize>(waves: &[Wave<R>; N], file: &mut R::File<S>) {
    let mut angles = [S::ZERO; N];
    for i in 0..N {
        angles[i] = waves[i].angle.read(file);
    }
    let (sines, cosines) = S::sin_cos_each(angles);
    for i in 0..N {
        waves[i].sin.write(file, sines[i]);
        waves[i].cos.write(file, cosines[i]);
    }
}

#[inline(never)]
fn look_up<S: Scalar, R: Register>(of: &LookUp<R>, x: S, tables: &[Table], file: &mut R::File<S>) {
    let found: [S; 4] = tables[of.table].at(x);
    for (to, value) in of.to[..of.count].iter().zip(found) {
        to.write(file, value);
    }
}
