//! Balancing: a diagonal similarity by powers of two, which are exact, that makes rows and columns equally long.
//!
//! Parlett and Reinsch, Numerische Mathematik 13 (1969), with lengths in the 2-norm, diagonal included, so that
//! well-scaled matrices stay unchanged (James, Langou and Lowery, On matrix balancing and eigenvector computation,
//! arXiv:1401.5766).

use crate::numerics::power_of_two::power_of_two;
use nalgebra::DMatrix;
use std::ops::Range;

/// A change is worthwhile only if it reduces the sum of both lengths below this fraction.
const WORTH: f64 = 0.95;
/// Lengths come within a factor of two of each other in a few sweeps; further sweeps change nothing significant.
const MOST_SWEEPS: usize = 100;

/// Balances each diagonal block, and then the blocks beside each other, which changes no eigenvalue; gives the scale of each row.
pub(super) fn balance(a: &mut DMatrix<f64>, blocks: &[Range<usize>]) -> Vec<f64> {
    let mut scales = vec![1.0; a.nrows()];
    for block in blocks {
        let rows: Vec<Range<usize>> = block.clone().map(|i| i..i + 1).collect();
        equalise(a, &mut scales, &rows, block, 0.0);
    }
    let own =
        |block: &Range<usize>| length(block.clone().flat_map(|j| block.clone().map(move |i| (i, j))).map(|at| a[at]));
    let largest = blocks.iter().map(own).fold(0.0, f64::max);
    equalise(a, &mut scales, blocks, &(0..a.nrows()), if largest > 0.0 { largest } else { 1.0 });
    scales
}

/// Brings the rows and the columns of each group, within these, to one length; with a lower bound on each.
fn equalise(a: &mut DMatrix<f64>, scales: &mut [f64], groups: &[Range<usize>], within: &Range<usize>, least: f64) {
    for _ in 0..MOST_SWEEPS {
        let mut has_changed = false;
        for group in groups {
            let entries = |pick: &dyn Fn(usize, usize) -> f64| {
                length(group.clone().flat_map(|i| within.clone().map(move |k| (i, k))).map(|(i, k)| pick(i, k)))
            };
            let column = entries(&|i, k| a[(k, i)]).max(least);
            let row = entries(&|i, k| a[(i, k)]).max(least);
            if column == 0.0 || row == 0.0 {
                continue;
            }
            let factor = power_of_two((row / column).sqrt());
            if column * factor + row / factor < WORTH * (column + row) {
                has_changed = true;
                for i in group.clone() {
                    scales[i] *= factor;
                    a.column_mut(i).iter_mut().for_each(|entry| *entry *= factor);
                    a.row_mut(i).iter_mut().for_each(|entry| *entry /= factor);
                }
            }
        }
        if !has_changed {
            break;
        }
    }
}

/// The length of a vector, without overflow on the way.
pub(super) fn length(entries: impl Iterator<Item = f64> + Clone) -> f64 {
    let largest = entries.clone().fold(0.0, |largest: f64, entry| largest.max(entry.abs()));
    if largest == 0.0 {
        return 0.0;
    }
    largest * entries.map(|entry| (entry / largest) * (entry / largest)).sum::<f64>().sqrt()
}
