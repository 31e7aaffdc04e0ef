//! The execution of a program: each instruction as generated Rust does it, so that the bits are the same.

use codegen::emit::bytecode::{Code, Field, Instruction, Wave};
use codegen::kernel_id::Argument;
use codegen::symbolic::Function;
use sim_kernel::{Input, Mask, Scalar, Table, pivot_is_refused};

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

/// Executes a program. Results stand in their registers. Gives where a pivot is refused.
pub(super) fn execute<S: Scalar>(code: &Code, given: Given<S>, registers: &mut [S]) -> S::Mask {
    load(code, given, registers);
    for instruction in &code.instructions {
        step(*instruction, code, given, registers);
    }
    match &code.pivots {
        None => S::not(S::Mask::NONE),
        Some(pivots) => pivots.iter().fold(S::Mask::NONE, |refused, [pivot, terms]| {
            refused | pivot_is_refused(registers[*pivot as usize], registers[*terms as usize])
        }),
    }
}

/// Constants, fields and arguments.
fn load<S: Scalar>(code: &Code, given: Given<S>, registers: &mut [S]) {
    let constants = code.constants.iter().map(|constant| S::from_f64(*constant));
    let fields = code.fields.iter().map(|field| match *field {
        Field::Parameter(at) => given.parameters[at],
        Field::Activity(at) => given.activities[at],
        Field::Prepared(at) => given.prepared[at],
    });
    let arguments = code.arguments.iter().map(|(argument, at)| match argument {
        Argument::Time => given.time,
        Argument::Positions => given.positions[*at],
        Argument::Speeds => given.speeds[*at],
        Argument::Accelerations => given.accelerations[*at],
        Argument::Multipliers => given.multipliers[*at],
        Argument::GeneralizedSpeeds => given.generalized_speeds[*at],
    });
    registers.iter_mut().zip(constants.chain(fields).chain(arguments)).for_each(|(register, value)| *register = value);
}

#[inline(always)]
fn step<S: Scalar>(instruction: Instruction<u32>, code: &Code, given: Given<S>, registers: &mut [S]) {
    use Instruction as I;
    let r = |at: u32| registers[at as usize];
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
        I::Call { function, to, a } => (to, call(function, r(a))),
        I::Power { to, a, b } => (to, r(a).powf(r(b))),
        I::Atan2 { to, a, b } => (to, r(a).atan2(r(b))),
        I::Choose { to, a, b, c } => (to, r(a).choose(r(b), r(c))),
        I::Held { input, to, a } => (to, given.inputs[input].or(r(a))),
        I::Waves { first, count } => return waves(&code.waves[first..first + count], registers),
        I::LookUp { table, a, to, count } => return look_up(&given.tables[table], r(a), &to[..count], registers),
    };
    registers[to as usize] = value;
}

#[inline(never)]
fn call<S: Scalar>(function: Function, x: S) -> S {
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
fn waves<S: Scalar>(waves: &[Wave<u32>], registers: &mut [S]) {
    let (fours, rest) = waves.as_chunks::<4>();
    fours.iter().for_each(|four| side_by_side(four, registers));
    match *rest {
        [a, b, c] => side_by_side(&[a, b, c], registers),
        [a, b] => side_by_side(&[a, b], registers),
        [a] => side_by_side(&[a], registers),
        _ => {}
    }
}

#[inline(always)]
fn side_by_side<S: Scalar, const N: usize>(waves: &[Wave<u32>; N], registers: &mut [S]) {
    let (sines, cosines) = S::sin_cos_each(waves.map(|wave| registers[wave.angle as usize]));
    for ((wave, sine), cosine) in waves.iter().zip(sines).zip(cosines) {
        registers[wave.sin as usize] = sine;
        registers[wave.cos as usize] = cosine;
    }
}

#[inline(never)]
fn look_up<S: Scalar>(table: &Table, x: S, to: &[u32], registers: &mut [S]) {
    let found: [S; 4] = table.at(x);
    for (to, value) in to.iter().zip(found) {
        registers[*to as usize] = value;
    }
}
