//! Sums of products at a block of states. A number that is the same at all of them is read once and spread over a vector, and
//! not loaded for each state.

use super::compact::SumOfProduct;
use codegen::emit::bytecode::{MINUS_ZERO, ONE};
use sim_kernel::Lanes;

/// What a sum of a product is at a block: capital letters are blocks, small ones numbers.
#[derive(Clone, Copy, Debug)]
enum Form {
    /// B C
    Product,
    /// b C
    Scaled,
    /// A + B C
    Sum,
    /// A - B C
    Difference,
    /// A + b C
    SumOfScaled,
    /// A + C
    PlainSum,
    /// A - C
    PlainDifference,
    /// a + B C
    ShiftedProduct,
    /// a - B C
    ReflectedProduct,
    /// a + b C
    ShiftedScaled,
}

/// a + b c at a block of states.
#[derive(Clone, Copy, Debug)]
pub(super) struct BlockSum {
    form: Form,
    to: u32,
    a: u32,
    b: u32,
    c: u32,
    /// a, where it is a number.
    addend: f64,
    /// b, where it is a number, or -b where the product is subtracted, which changes no bit.
    factor: f64,
}

impl BlockSum {
    /// The sum. The first registers hold these numbers, the same at all states.
    pub(super) fn of(sum: &SumOfProduct<u32>, numbers: &[f64]) -> BlockSum {
        let number = |register: u32| numbers.get(register as usize).copied();
        let is_number = |register: u32| number(register).is_some();
        // A product is the same either way round. The block of a number holds it at all states, which serves if both are numbers.
        let [b, c] = if is_number(sum.c) { [sum.c, sum.b] } else { [sum.b, sum.c] };
        let form = match (sum.a, is_number(b), sum.is_negative) {
            (MINUS_ZERO, true, _) => Form::Scaled,
            (MINUS_ZERO, false, false) => Form::Product,
            (a, true, _) if is_number(a) => Form::ShiftedScaled,
            (a, false, false) if is_number(a) => Form::ShiftedProduct,
            (a, false, true) if is_number(a) => Form::ReflectedProduct,
            (_, true, false) if b == ONE => Form::PlainSum,
            (_, true, true) if b == ONE => Form::PlainDifference,
            (_, true, _) => Form::SumOfScaled,
            (_, false, false) => Form::Sum,
            (_, false, true) => Form::Difference,
        };
        let sign = if sum.is_negative { -1.0 } else { 1.0 };
        let [addend, factor] = [sum.a, b].map(|register| number(register).unwrap_or_default());
        BlockSum { form, to: sum.to, a: sum.a, b, c, addend, factor: sign * factor }
    }

    #[inline(always)]
    pub(super) fn execute<const STATES: usize>(self, file: &mut [Lanes<STATES>]) {
        let BlockSum { to, a, b, c, addend, factor, .. } = self;
        match self.form {
            Form::Product => each(file, to, [b, c], |[b, c]| b * c),
            Form::Scaled => each(file, to, [c], |[c]| factor * c),
            Form::Sum => each(file, to, [a, b, c], |[a, b, c]| a + b * c),
            Form::Difference => each(file, to, [a, b, c], |[a, b, c]| a - b * c),
            Form::SumOfScaled => each(file, to, [a, c], |[a, c]| a + factor * c),
            Form::PlainSum => each(file, to, [a, c], |[a, c]| a + c),
            Form::PlainDifference => each(file, to, [a, c], |[a, c]| a - c),
            Form::ShiftedProduct => each(file, to, [b, c], |[b, c]| addend + b * c),
            Form::ReflectedProduct => each(file, to, [b, c], |[b, c]| addend - b * c),
            Form::ShiftedScaled => each(file, to, [c], |[c]| addend + factor * c),
        }
    }
}

/// Computes a block. A value has a register of its own, which is no operand's: the compiler has to know that, or it takes the
/// states one by one.
#[inline(always)]
fn each<const STATES: usize, const OPERANDS: usize>(
    file: &mut [Lanes<STATES>],
    to: u32,
    operands: [u32; OPERANDS],
    value: impl Fn([f64; OPERANDS]) -> f64,
) {
    let at = to as usize;
    // All registers are there.
    let Some((before, [target, after @ ..])) = file.split_at_mut_checked(at) else { return };
    let operands = operands.map(|operand| {
        let operand = operand as usize;
        if operand < at { &before[operand] } else { &after[operand - at - 1] }
    });
    fill(target, operands, value);
}

#[inline(always)]
fn fill<const STATES: usize, const OPERANDS: usize>(
    target: &mut Lanes<STATES>,
    operands: [&Lanes<STATES>; OPERANDS],
    value: impl Fn([f64; OPERANDS]) -> f64,
) {
    for state in 0..STATES {
        target.set_lane(state, value(operands.map(|operand| operand.lane(state))));
    }
}
