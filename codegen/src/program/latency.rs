//! The latency of a value: the time until it is known on a processor with unlimited execution units.
//!
//! For a right-hand side of few bodies latency matters more than the number of operations.

use super::values::{Operation, Value, Values};
use crate::symbolic::Function;

/// In cycles, as on processors of the years around 2025.
pub(super) type Time = u32;

const ADDITION: Time = 3;
/// Of a multiplication.
pub(super) const MULTIPLICATION: Time = 3;
const DIVISION: Time = 13;
const SQUARE_ROOT: Time = 16;
const LOOK_UP: Time = 30;
const FUNCTION: Time = 60;

/// The times at which the listed values are known, operands first; all others are known from the start.
pub(super) fn times(values: &Values, listed: &[Value]) -> Vec<Time> {
    let mut times = vec![0; values.len()];
    let mut factors = Vec::new();
    for value in listed {
        let arrivals = values.operands(*value).map(|operand| times[operand.index()]);
        let latest = || arrivals.clone().max().unwrap_or(0);
        times[value.index()] = match values.operation(*value) {
            Operation::Constant(_) | Operation::Input(_) => 0,
            Operation::Negate(_) | Operation::Held(..) | Operation::Entry(..) => latest(),
            Operation::Sum(_) => arrivals.reduce(|sum, term| sum.max(term) + ADDITION).unwrap_or(0),
            Operation::Product(_) => {
                factors.clear();
                factors.extend(arrivals);
                product(&mut factors)
            }
            Operation::Quotient(..) => latest() + DIVISION,
            // Each step waits for the one before, twice.
            Operation::Columns(columns) => {
                latest() + 2 * columns.shape.steps.len() as Time * (MULTIPLICATION + ADDITION)
            }
            Operation::Sqrt(_) => latest() + SQUARE_ROOT,
            Operation::Choice(..) | Operation::Call(Function::Abs, _) => latest() + ADDITION,
            Operation::Table(..) => latest() + LOOK_UP,
            Operation::Call(..) | Operation::Power(..) | Operation::Atan2(..) => latest() + FUNCTION,
        };
    }
    times
}

/// The time at which a product of such factors is known, the earliest multiplied first.
pub(super) fn product(factors: &mut [Time]) -> Time {
    factors.sort_unstable();
    factors.iter().copied().reduce(|product, factor| product.max(factor) + MULTIPLICATION).unwrap_or(0)
}
