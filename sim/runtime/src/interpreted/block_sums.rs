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
    /// -1 where the product is subtracted, and 1 elsewhere. A number takes it as a factor, which changes no bit.
    sign: f64,
    to: u32,
    a: u32,
    b: u32,
    c: u32,
}

impl BlockSum {
    /// The sum. So many registers, the first ones, hold the same number at all states.
    pub(super) fn of(sum: &SumOfProduct<u32>, numbers: usize) -> BlockSum {
        let is_number = |register: u32| (register as usize) < numbers;
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
        BlockSum { form, sign, to: sum.to, a: sum.a, b, c }
    }

    #[inline(always)]
    pub(super) fn execute<const AT_ONCE: usize, const STATES: usize>(
        self,
        numbers: &[f64],
        file: &mut [Lanes<STATES>],
    ) {
        let BlockSum { to, a, b, c, .. } = self;
        let number = |register: u32| numbers[register as usize];
        let scale = || self.sign * number(b);
        match self.form {
            Form::Product => each::<AT_ONCE, STATES, 2>(file, to, [b, c], |[b, c]| b * c),
            Form::Scaled => {
                let b = scale();
                each::<AT_ONCE, STATES, 1>(file, to, [c], |[c]| b * c);
            }
            Form::Sum => each::<AT_ONCE, STATES, 3>(file, to, [a, b, c], |[a, b, c]| a + b * c),
            Form::Difference => each::<AT_ONCE, STATES, 3>(file, to, [a, b, c], |[a, b, c]| a - b * c),
            Form::SumOfScaled => {
                let b = scale();
                each::<AT_ONCE, STATES, 2>(file, to, [a, c], |[a, c]| a + b * c);
            }
            Form::PlainSum => each::<AT_ONCE, STATES, 2>(file, to, [a, c], |[a, c]| a + c),
            Form::PlainDifference => each::<AT_ONCE, STATES, 2>(file, to, [a, c], |[a, c]| a - c),
            Form::ShiftedProduct => {
                let a = number(a);
                each::<AT_ONCE, STATES, 2>(file, to, [b, c], |[b, c]| a + b * c);
            }
            Form::ReflectedProduct => {
                let a = number(a);
                each::<AT_ONCE, STATES, 2>(file, to, [b, c], |[b, c]| a - b * c);
            }
            Form::ShiftedScaled => {
                let (a, b) = (number(a), scale());
                each::<AT_ONCE, STATES, 1>(file, to, [c], |[c]| a + b * c);
            }
        }
    }
}

/// Computes a block, as many states at once as a vector holds, so that nothing goes through memory between reading operands and
/// writing the value. Loops, since what closures of `array::map` hold may be left in memory.
#[inline(always)]
fn each<const AT_ONCE: usize, const STATES: usize, const OPERANDS: usize>(
    file: &mut [Lanes<STATES>],
    to: u32,
    operands: [u32; OPERANDS],
    value: impl Fn([f64; OPERANDS]) -> f64,
) {
    // All are there. Known before the loop, it is not checked at each vector.
    if to as usize >= file.len() || operands.iter().any(|operand| *operand as usize >= file.len()) {
        return;
    }
    for first in (0..STATES).step_by(AT_ONCE) {
        let mut vectors = [[0.0; AT_ONCE]; OPERANDS];
        for (vector, operand) in vectors.iter_mut().zip(operands) {
            *vector = file[operand as usize].part(first);
        }
        let mut values = [0.0; AT_ONCE];
        for lane in 0..AT_ONCE {
            let mut of_lane = [0.0; OPERANDS];
            for i in 0..OPERANDS {
                of_lane[i] = vectors[i][lane];
            }
            values[lane] = value(of_lane);
        }
        file[to as usize].set_part(first, values);
    }
}
