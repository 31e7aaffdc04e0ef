//! Many right-hand sides of one factorised system together: in straight lines while that is short, and otherwise in a loop over the
//! columns, with vector instructions, as the machine code of straight lines would not fit the caches.

use super::columns::{BLOCK, ColumnsShape, ColumnsStep};
use super::eliminate::{Factors, Step};
use super::responses::Responses;
use super::values::{ColumnsOperation, Operation, Value, Values};
use std::sync::Arc;

/// An unknown with the reciprocal of its pivot and its column of L.
type Eliminated<'a> = (usize, Value, &'a [(usize, Value)]);

/// With more multiplications straight lines are too long.
const LONGEST: usize = 15_000;

/// The solutions for these right-hand sides; no constants occur in the definitions of intermediate quantities.
pub(super) fn solve_each(values: &mut Values, factors: &Factors, columns: Vec<Vec<Value>>) -> Vec<Vec<Value>> {
    let steps: Option<Vec<Eliminated>> = factors.steps.iter().map(eliminated).collect();
    let Some(steps) = steps.filter(|steps| {
        let entries: usize = steps.iter().map(|(_, _, column)| column.len()).sum();
        2 * entries * columns.len() > LONGEST
    }) else {
        let mut responses = Responses::of(factors, columns.first().map_or(0, Vec::len));
        return columns.into_iter().map(|column| responses.solve(values, column)).collect();
    };
    let count = columns.len();
    let shape = shape(values, &steps, &columns);
    let zero = values.constant(0.0);
    let mut operands: Vec<Value> = steps.iter().map(|(_, inverse, _)| *inverse).collect();
    operands.extend(steps.iter().flat_map(|(_, _, column)| column.iter().map(|(_, entry)| *entry)));
    for row in 0..steps.len() {
        operands.extend((0..shape.columns).map(|j| columns.get(j).map_or(zero, |column| column[row])));
    }
    let rows = steps.len();
    let matrix = values.add(Operation::Columns(Box::new(ColumnsOperation { shape: Arc::new(shape), operands })));
    let mut column = |j: usize| (0..rows).map(|i| values.add(Operation::Entry(matrix, i, j))).collect();
    (0..count).map(&mut column).collect()
}

fn eliminated(step: &Step) -> Option<Eliminated<'_>> {
    match step {
        Step::Eliminate { unknown, inverse, column } => Some((*unknown, *inverse, column)),
        Step::Substitute { .. } => None,
    }
}

fn shape(values: &Values, steps: &[Eliminated], columns: &[Vec<Value>]) -> ColumnsShape {
    let mut met = vec![0u64; steps.len()];
    for (j, column) in columns.iter().enumerate().take(BLOCK * u64::BITS as usize) {
        let rows = column.iter().zip(&mut met).filter(|(x, _)| !values.is_zero(**x));
        rows.for_each(|(_, met)| *met |= 1 << (j / BLOCK));
    }
    let steps = steps.iter().map(|(unknown, _, column)| {
        let blocks = met[*unknown];
        column.iter().for_each(|(row, _)| met[*row] |= blocks);
        ColumnsStep { unknown: *unknown, rows: column.iter().map(|(row, _)| *row).collect(), blocks }
    });
    ColumnsShape { steps: steps.collect(), columns: columns.len().next_multiple_of(BLOCK) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::program::values::Input;

    /// A row takes over what is other than zero in those that are eliminated before it, column by column.
    #[test]
    fn blocks_are_handed_on() {
        let mut values = Values::default();
        let (zero, x) = (values.constant(0.0), values.add(Operation::Input(Input::Position(0))));
        let steps = [(1, x, &[(0, x)][..]), (0, x, &[(2, x)][..]), (2, x, &[][..])];
        let mut columns = vec![vec![zero; 3]; BLOCK + 1];
        columns[0][1] = x;
        columns[BLOCK][2] = x;
        let shape = shape(&values, &steps, &columns);
        let met: Vec<u64> = shape.steps.iter().map(|step| step.blocks).collect();
        assert_eq!((met, shape.columns), (vec![0b01, 0b01, 0b11], 2 * BLOCK));
    }
}
