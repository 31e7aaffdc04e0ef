//! Many right-hand sides of one factorised system together: in straight lines while that is short, and otherwise in a loop over the
//! columns, with vector instructions, as the machine code of straight lines would not fit the caches.

use super::eliminate::{Factors, Step};
use super::responses::Responses;
use super::values::{Operation, Value, Values};
use std::rc::Rc;

/// With more multiplications straight lines are too long.
const LONGEST: usize = 15_000;

/// How many columns the loop takes at a time.
pub const BLOCK: usize = 8;

/// A matrix of right-hand sides with what solves it, as an operation.
#[derive(Clone, PartialEq, Eq, Hash, Debug)]
pub(super) struct ColumnsOperation {
    pub(super) shape: Rc<ColumnsShape>,
    /// The reciprocals of pivots and the entries of L, by steps; then the right-hand sides, by rows.
    pub(super) operands: Vec<Value>,
}

/// The structure of a system that is solved for many right-hand sides.
#[derive(PartialEq, Eq, Hash, Debug)]
pub struct ColumnsShape {
    /// One for each row, in the order of elimination.
    pub steps: Vec<ColumnsStep>,
    /// How many columns there are, in whole blocks.
    pub columns: usize,
}

/// The elimination of one unknown.
#[derive(PartialEq, Eq, Hash, Debug)]
pub struct ColumnsStep {
    /// Its row.
    pub unknown: usize,
    /// The rows that are eliminated later and have an entry of L.
    pub rows: Vec<usize>,
    /// The blocks of columns in which its row may be other than zero on the way to the last, a bit each; those beyond the last
    /// bit may.
    pub blocks: u64,
}

impl ColumnsShape {
    /// The number of multiplications, to the last row and back; each but those with pivots comes with a subtraction.
    pub(super) fn operations(&self) -> usize {
        let blocks = self.columns / BLOCK;
        let of_step = |step: &ColumnsStep| {
            let met = (0..blocks).filter(|block| step.meets(*block)).count();
            BLOCK * (step.rows.len() * (met + blocks) + blocks)
        };
        self.steps.iter().map(of_step).sum()
    }
}

impl ColumnsStep {
    /// Whether its row may be other than zero in a block, before the way back.
    pub fn meets(&self, block: usize) -> bool {
        block >= u64::BITS as usize || self.blocks >> block & 1 == 1
    }
}

/// The solutions for these right-hand sides; no constants occur in the definitions of intermediate quantities.
pub(super) fn solve_each(values: &mut Values, factors: &Factors, columns: Vec<Vec<Value>>) -> Vec<Vec<Value>> {
    let steps: Option<Vec<(usize, Value, &[(usize, Value)])>> = factors.steps.iter().map(eliminated).collect();
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
    let matrix = values.add(Operation::Columns(Box::new(ColumnsOperation { shape: Rc::new(shape), operands })));
    let mut column = |j: usize| (0..rows).map(|i| values.add(Operation::Entry(matrix, i, j))).collect();
    (0..count).map(&mut column).collect()
}

fn eliminated(step: &Step) -> Option<(usize, Value, &[(usize, Value)])> {
    match step {
        Step::Eliminate { unknown, inverse, column } => Some((*unknown, *inverse, column)),
        Step::Substitute { .. } => None,
    }
}

fn shape(values: &Values, steps: &[(usize, Value, &[(usize, Value)])], columns: &[Vec<Value>]) -> ColumnsShape {
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
