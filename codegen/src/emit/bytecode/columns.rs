//! A system that is solved for many right-hand sides, as instructions.

use super::instruction::Instruction;
use super::parts::Place;
use super::write::Writer;
use crate::program::{BLOCK, Columns, ColumnsStep, Tree};

impl Writer<'_> {
    /// Each operation of `sim_kernel::solve_columns`, in its order.
    pub(super) fn columns(&mut self, columns: &Columns) {
        let Columns { shape, inverses, entries, right_hand_sides, names } = columns;
        let mut places = |trees: &[Tree]| trees.iter().map(|tree| self.value(tree)).collect::<Vec<_>>();
        let (inverses, entries) = (places(inverses), places(entries));
        let mut rows: Vec<Vec<Place>> = right_hand_sides.iter().map(|row| places(row)).collect();
        let mut at = 0;
        let mut steps = Vec::new();
        for (ColumnsStep { unknown, rows: after, .. }, inverse) in shape.steps.iter().zip(inverses) {
            let column: Vec<(usize, Place)> = after.iter().copied().zip(entries[at..].iter().copied()).collect();
            at += after.len();
            steps.push((*unknown, inverse, column));
        }
        for (step, (unknown, _, column)) in shape.steps.iter().zip(&steps) {
            for j in (0..shape.columns).filter(|j| step.meets(j / BLOCK)) {
                let c = rows[*unknown][j];
                for (row, b) in column {
                    let (a, to) = (rows[*row][j], self.local());
                    rows[*row][j] = self.push(|to| Instruction::SubtractProduct { to, a, b: *b, c }, to);
                }
            }
        }
        for (unknown, inverse, column) in steps.iter().rev() {
            for j in 0..shape.columns {
                let (a, to) = (rows[*unknown][j], self.local());
                let mut solved = self.push(|to| Instruction::Multiply { to, a, b: *inverse }, to);
                for (row, b) in column {
                    let (a, c, to) = (solved, rows[*row][j], self.local());
                    solved = self.push(|to| Instruction::SubtractProduct { to, a, b: *b, c }, to);
                }
                rows[*unknown][j] = solved;
            }
        }
        for (names, places) in names.iter().zip(rows) {
            let named = names.iter().zip(places).filter_map(|(name, place)| Some((name.clone()?, place)));
            self.names.extend(named);
        }
    }
}
