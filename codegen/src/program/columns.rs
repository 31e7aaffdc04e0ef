//! The structure of a system with many right-hand sides that are solved in a loop over the columns.

/// How many columns the loop takes at a time.
pub const BLOCK: usize = 8;

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
